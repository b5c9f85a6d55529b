#include "sightline/math/slerp.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sightline/math/vec.h"

namespace sightline {

glm::dquat canonical(const glm::dquat& rotation) {
  const Vec3d axis(rotation.x, rotation.y, rotation.z);
  const double size = std::max(max_norm(axis), std::fabs(rotation.w));
  if (!is_finite(axis) || !std::isfinite(rotation.w) || size == 0) {
    throw std::invalid_argument("rotation: expected a quaternion other than 0");
  }
  const int exponent = std::ilogb(size);  // so that squares neither over- nor underflow
  const auto scaled = [&](double x) { return std::scalbn(x, -exponent); };
  const glm::dquat near_one(scaled(rotation.w), scaled(axis.x), scaled(axis.y), scaled(axis.z));
  const glm::dquat unit = near_one / std::sqrt(glm::dot(near_one, near_one));
  for (const double x : {unit.w, unit.x, unit.y, unit.z}) {
    if (x != 0) return x > 0 ? unit : -unit;
  }
  return unit;
}

glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double share) {
  const glm::dquat a = canonical(from), other = canonical(to);
  const glm::dquat b = glm::dot(a, other) < 0 ? -other : other;
  // Half the angle between them by the tangent of its half, which is as exact for small angles as for large ones.
  const glm::dquat apart = b - a, together = a + b;
  const double angle = 2 * std::atan2(std::sqrt(glm::dot(apart, apart)), std::sqrt(glm::dot(together, together)));
  if (angle == 0) return a;
  const glm::dquat mixed = a * std::sin((1 - share) * angle) + b * std::sin(share * angle);
  return mixed / std::sqrt(glm::dot(mixed, mixed));
}

}  // namespace sightline
