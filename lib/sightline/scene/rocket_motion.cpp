#include "sightline/scene/rocket_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sightline {

double RocketFlight::landing() const {
  const double height = 0.5 * acceleration.y * burning * burning, speed = acceleration.y * burning;
  return burning + (speed + std::sqrt(speed * speed + 2 * gravity * height)) / gravity;
}

Vec3d RocketFlight::velocity(double time) const {
  if (time <= 0 || time >= landing()) return Vec3d(0);
  Vec3d speed = acceleration * std::min(time, burning);
  if (time > burning) speed.y -= gravity * (time - burning);
  return speed;
}

Vec3d RocketFlight::place(double time) const {
  const double at = std::clamp(time, 0.0, landing()), burned = std::min(at, burning), thrown = at - burned;
  Vec3d place = 0.5 * burned * burned * acceleration + thrown * burned * acceleration;
  place.y = std::max(0.0, place.y - 0.5 * gravity * thrown * thrown);
  return place;
}

RocketMotion::RocketMotion(const RocketFlight& flight, NodeId rocket, NodeId flame)
    : flight_(flight), rocket_(rocket), flame_(flame) {
  if (flight.burning > 0 && flight.acceleration.y > 0 && flight.gravity > 0 && std::isfinite(flight.landing())) return;
  throw std::invalid_argument("rocket: expected burning, upward acceleration and gravity above 0");
}

void RocketMotion::pose(double time, std::vector<NodePose>& poses) const {
  const Vec3d velocity = flight_.velocity(time);
  Transform local = Transform::translation(flight_.place(time));
  const Vec3d up(0, 1, 0), turn_axis = glm::cross(up, velocity);
  if (max_norm(turn_axis) > 0) {
    const double angle = std::atan2(glm::length(turn_axis), velocity.y) * (180 / std::numbers::pi);
    local = local * Transform::rotation(turn_axis, angle);
  }
  const double rolled = std::clamp(time, 0.0, flight_.landing()) * flight_.roll;
  poses.push_back({rocket_, local * Transform::rotation(up, rolled)});
  if (flame_ == no_node) return;
  const double size = flight_.is_burning(time) ? 1 + 0.25 * std::sin(40 * time) : 1. / 64;
  poses.push_back({flame_, Transform::scaling(Vec3d(1, size, 1))});
}

}  // namespace sightline
