#include "bench/peers/embree.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <limits>
#include <stdexcept>
#include <vector>

namespace sightline::bench {
namespace {

/// One device, which lives as long as anything built with it; it counts the bytes that Embree holds.
class Device {
 public:
  explicit Device(int threads) {
    const std::string config = threads > 0 ? "threads=" + std::to_string(threads) : std::string();
    device_ = rtcNewDevice(config.c_str());
    if (!device_) throw std::runtime_error("Embree: no device (error " + error_text(nullptr) + ")");
    rtcSetDeviceMemoryMonitorFunction(device_, count, &bytes_);
  }
  ~Device() { rtcReleaseDevice(device_); }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  RTCDevice get() const { return device_; }
  std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }

  void check(const char* step) const {
    const std::string error = error_text(device_);
    if (!error.empty()) throw std::runtime_error(std::string("Embree: ") + step + " failed (error " + error + ")");
  }

 private:
  static std::string error_text(RTCDevice device) {
    const RTCError error = rtcGetDeviceError(device);
    return error == RTC_ERROR_NONE ? std::string() : std::to_string(static_cast<int>(error));
  }
  static bool count(void* bytes, ssize_t change, bool) {
    static_cast<std::atomic<std::int64_t>*>(bytes)->fetch_add(change);
    return true;
  }

  RTCDevice device_ = nullptr;
  std::atomic<std::int64_t> bytes_ = 0;
};

RTCRay to_embree(const Ray<float>& ray) {
  RTCRay out;
  out.org_x = ray.origin.x;
  out.org_y = ray.origin.y;
  out.org_z = ray.origin.z;
  out.tnear = ray.t_min;
  out.dir_x = ray.direction.x;
  out.dir_y = ray.direction.y;
  out.dir_z = ray.direction.z;
  out.time = 0;
  out.tfar = ray.t_max;
  out.mask = 0xffff'ffff;
  out.id = 0;
  out.flags = 0;
  return out;
}

class BuiltEmbree final : public Built {
 public:
  BuiltEmbree(std::shared_ptr<Device> device, EmbreeMode mode, const TriangleMesh& mesh)
      : device_(std::move(device)), bytes_before_(device_->bytes()), scene_(rtcNewScene(device_->get())) {
    if (mode == EmbreeMode::robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, mode == EmbreeMode::high ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
    const RTCGeometry geometry = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree reads 16 bytes of every vertex, so the mesh's own array ends too early for it.
    positions_.reserve(mesh.positions().size() + 2);
    positions_ = mesh.positions();
    positions_.resize(mesh.positions().size() + 2);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions_.data(), 0,
                               sizeof(Vec3f), mesh.positions().size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles().data(), 0,
                               sizeof(TriangleMesh::Corners), mesh.triangles().size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
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
  std::shared_ptr<Device> device_;
  std::size_t bytes_before_, bytes_ = 0;
  RTCScene scene_;
  std::vector<Vec3f> positions_;
};

class Embree final : public Contender {
 public:
  Embree(EmbreeMode mode, int threads) : mode_(mode), device_(std::make_shared<Device>(threads)) {}

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
  std::shared_ptr<Device> device_;
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
