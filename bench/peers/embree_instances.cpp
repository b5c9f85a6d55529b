#include "bench/peers/embree_instances.h"

#include <array>

#include "bench/peers/embree_device.h"

namespace sightline::bench {
namespace {

class EmbreeInstances final : public InstanceContender {
 public:
  explicit EmbreeInstances(const Instances& instances) : scene_(rtcNewScene(device_.get())) {
    for (const auto& mesh : instances.meshes()) {
      meshes_.push_back(rtcNewScene(device_.get()));
      positions_.push_back(attach_mesh(device_, meshes_.back(), *mesh));
      rtcCommitScene(meshes_.back());
    }
    const std::size_t before = device_.bytes();
    for (const Placement& placement : instances.placements()) {
      const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(geometry, meshes_[placement.mesh()]);
      std::array<float, 12> rows;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t k = 0; k < 4; ++k) rows[4 * axis + k] = placement.row(axis)[k];
      }
      rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, rows.data());
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene_, geometry);
      rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene_);
    device_.check("building instances");
    bytes_ = device_.bytes() - before;
  }
  ~EmbreeInstances() override {
    rtcReleaseScene(scene_);
    for (const RTCScene mesh : meshes_) rtcReleaseScene(mesh);
  }
  EmbreeInstances(const EmbreeInstances&) = delete;
  EmbreeInstances& operator=(const EmbreeInstances&) = delete;

  std::string name() const override { return "embree"; }
  bool is_peer() const override { return true; }
  std::size_t bytes() const override { return bytes_; }

  void closest_hits(std::span<const Ray<float>> rays, std::span<InstanceHit<float>> hits) const override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRayHit query;
      query.ray = to_embree(rays[i]);
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &context, &query);
      hits[i] = {};
      if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
      hits[i] = {query.ray.tfar, query.hit.instID[0], query.hit.primID, query.hit.u, query.hit.v};
    }
  }

 private:
  EmbreeDevice device_{0};
  std::vector<RTCScene> meshes_;
  std::vector<std::vector<Vec3f>> positions_;
  RTCScene scene_;
  std::size_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<InstanceContender> make_embree_instances(const Instances& instances) {
  return std::make_unique<EmbreeInstances>(instances);
}

}  // namespace sightline::bench
