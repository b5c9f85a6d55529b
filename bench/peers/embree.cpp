#include "bench/peers/embree.h"

#include <limits>
#include <vector>

#include "bench/peers/embree_device.h"

namespace sightline::bench {
namespace {

class BuiltEmbree final : public Built {
 public:
  BuiltEmbree(std::shared_ptr<EmbreeDevice> device, EmbreeMode mode, const TriangleMesh& mesh)
      : device_(std::move(device)), bytes_before_(device_->bytes()), scene_(rtcNewScene(device_->get())) {
    if (mode == EmbreeMode::robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, mode == EmbreeMode::high ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
    positions_ = attach_mesh(*device_, scene_, mesh);
    rtcCommitScene(scene_);
    device_->check("building");
    bytes_ = device_->bytes() - bytes_before_;
  }
  ~BuiltEmbree() override { rtcReleaseScene(scene_); }
  BuiltEmbree(const BuiltEmbree&) = delete;
  BuiltEmbree& operator=(const BuiltEmbree&) = delete;

  void closest_hits(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRayHit query;
      query.ray = to_embree(rays[i]);
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &context, &query);
      hits[i] = query.hit.geomID == RTC_INVALID_GEOMETRY_ID
                    ? Hit<float>{}
                    : Hit<float>{query.ray.tfar, query.hit.primID, query.hit.u, query.hit.v};
    }
  }

  void any_hits(std::span<const Ray<float>> rays, std::span<std::uint8_t> is_hit) const override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRay query = to_embree(rays[i]);
      rtcOccluded1(scene_, &context, &query);
      is_hit[i] = query.tfar == -std::numeric_limits<float>::infinity();
    }
  }

  Bytes bytes() const override { return {bytes_, std::nullopt}; }

 private:
  std::shared_ptr<EmbreeDevice> device_;
  std::size_t bytes_before_, bytes_ = 0;
  RTCScene scene_;
  std::vector<Vec3f> positions_;
};

class Embree final : public Contender {
 public:
  Embree(EmbreeMode mode, int threads) : mode_(mode), device_(std::make_shared<EmbreeDevice>(threads)) {}

  std::string name() const override {
    switch (mode_) {
      case EmbreeMode::high:
        return "embree-high";
      case EmbreeMode::robust:
        return "embree-robust";
      case EmbreeMode::standard:
        break;
    }
    return "embree";
  }
  Kind kind() const override { return Kind::peer; }
  std::unique_ptr<Built> build(const std::shared_ptr<const TriangleMesh>& mesh) const override {
    return std::make_unique<BuiltEmbree>(device_, mode_, *mesh);
  }

 private:
  EmbreeMode mode_;
  std::shared_ptr<EmbreeDevice> device_;
};

}  // namespace

std::unique_ptr<Contender> make_embree(EmbreeMode mode, int threads) { return std::make_unique<Embree>(mode, threads); }

std::string embree_version() {
  const RTCDevice device = rtcNewDevice("threads=1");
  const auto version = rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION);
  rtcReleaseDevice(device);
  return std::to_string(version / 10000) + '.' + std::to_string(version / 100 % 100) + '.' +
         std::to_string(version % 100);
}

}  // namespace sightline::bench
