#pragma once

#include <glm/gtc/quaternion.hpp>

namespace sightline {

/// The rotation a share of the way from one rotation to another, the shorter way and at even speed, as a unit
/// quaternion. Quaternions of any length but 0; q and -q are one rotation, so that any signs give the same bits. Of
/// two ways equally short it takes one and the same, whatever the signs.
/// \throws std::invalid_argument for a quaternion that is zero or not finite.
/// Shoemake, "Animating rotation with quaternion curves", 1985.
glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double share);

/// Of unit length, with the first of w, x, y and z that is not 0 above 0. \throws as slerp does.
glm::dquat canonical(const glm::dquat& rotation);

}  // namespace sightline
