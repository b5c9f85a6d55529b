#pragma once
/// What the peers made of Embree 3 share.

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "sightline/shape/mesh.h"

namespace sightline::bench {

/// One device, which lives as long as anything built with it; it counts the bytes that Embree holds.
class EmbreeDevice {
 public:
  explicit EmbreeDevice(int threads) {
    const std::string config = threads > 0 ? "threads=" + std::to_string(threads) : std::string();
    device_ = rtcNewDevice(config.c_str());
    if (!device_) throw std::runtime_error("Embree: no device (error " + error_text(nullptr) + ")");
    rtcSetDeviceMemoryMonitorFunction(device_, count, &bytes_);
  }
  ~EmbreeDevice() { rtcReleaseDevice(device_); }
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

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

inline RTCRay to_embree(const Ray<float>& ray) {
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

/// Adds the mesh to a scene that is not committed yet. What is returned has to live as long as the scene.
inline std::vector<Vec3f> attach_mesh(const EmbreeDevice& device, RTCScene scene, const TriangleMesh& mesh) {
  const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  // Embree reads 16 bytes of every vertex, so the mesh's own array ends too early for it.
  std::vector<Vec3f> positions;
  positions.reserve(mesh.positions().size() + 2);
  positions = mesh.positions();
  positions.resize(mesh.positions().size() + 2);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(), 0, sizeof(Vec3f),
                             mesh.positions().size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles().data(), 0,
                             sizeof(TriangleMesh::Corners), mesh.triangles().size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  return positions;
}

}  // namespace sightline::bench
