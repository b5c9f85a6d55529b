#include "sightline/scene/view_frustum.h"

#include <cmath>

namespace sightline {

/// A ray's direction d is off by e, |e| < 2^-23 |d|, and is on the inner side of a plane with the normal n but for
/// that: n . d >= -2^-23 |d|. As |d| <= (f . d) / (|f| cos), where cos is that of the angle to the picture's corners,
/// it is on the inner side of n + k f / (|f| cos) for k = 2^-22, which leaves half of k for roundings here.
ViewFrustum::ViewFrustum(const Camera& camera) : eye_(Vec3f(camera.eye)) {
  const Vec3d ahead = glm::normalize(camera.forward);
  const double corner = glm::length(camera.forward + camera.right + camera.up) / glm::length(camera.forward);
  const double tilt = 0x1p-22 * corner;
  const auto add = [&](const Vec3d& across) {
    const double length = glm::length(across);
    if (!(length > 0 && std::isfinite(length))) return;  // a picture without an area has no such edge
    const Vec3d inward = across * ((glm::dot(across, ahead) < 0 ? -1 : 1) / length);
    normals_.push_back(glm::normalize(inward + tilt * ahead));
  };
  add(glm::cross(camera.up, camera.forward + camera.right));
  add(glm::cross(camera.up, camera.forward - camera.right));
  add(glm::cross(camera.right, camera.forward + camera.up));
  add(glm::cross(camera.right, camera.forward - camera.up));
  if (tilt < 1) normals_.push_back(ahead);
}

}  // namespace sightline
