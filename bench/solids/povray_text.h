#pragma once

#include <string>

#include "bench/solids/scene.h"

namespace sightline::bench {

/// The scene in POV-Ray's scene description language: the same trees, numbers, camera, light and shading. Numbers are
/// written with as many digits as tell them from all other doubles.
/// \throws std::invalid_argument for what that language does not have: closed meshes, symmetric differences.
std::string povray_text(const SolidScene& scene);

/// Parts of that: `look` is what stands behind each solid's shapes, such as its pigment and finish.
std::string povray_text(const SolidTree& solid, const std::string& look);
std::string povray_text(const Camera& camera);
std::string povray_text(const Vec3d& v);

}  // namespace sightline::bench
