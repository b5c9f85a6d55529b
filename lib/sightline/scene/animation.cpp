#include "sightline/scene/animation.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "sightline/math/slerp.h"

namespace sightline {
namespace {

Vec3d between(const Vec3d& a, const Vec3d& b, double share) { return (1 - share) * a + share * b; }
glm::dquat between(const glm::dquat& a, const glm::dquat& b, double share) { return slerp(a, b, share); }

/// Of a track with keys.
template <class T>
T value_at(const Track<T>& track, double time) {
  const auto after = std::upper_bound(track.times.begin(), track.times.end(), time);
  const auto next = static_cast<std::size_t>(after - track.times.begin());
  if (next == 0) return track.values.front();
  const T& value = track.values[next - 1];
  if (next == track.times.size() || track.interpolation == Interpolation::step) return value;
  const double from = track.times[next - 1], to = track.times[next];
  if (time == from) return value;
  return between(value, track.values[next], (time - from) / (to - from));
}

bool is_valid(const Vec3d& translation) { return is_finite(translation); }
bool is_valid(const glm::dquat& q) {
  return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) &&
         (q.w != 0 || q.x != 0 || q.y != 0 || q.z != 0);
}

struct Place {
  const std::string& animation;
  const std::string node;

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::invalid_argument("animation " + animation + ", node " + node + ": " + what);
  }
};

template <class T>
void check(const Track<T>& track, const std::string& what, const Place& place) {
  if (track.times.size() != track.values.size()) {
    place.refuse(what + ": expected as many times as values, found " + std::to_string(track.times.size()) + " and " +
                 std::to_string(track.values.size()));
  }
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    const std::string key = what + ", key " + std::to_string(i) + ": expected ";
    if (!std::isfinite(track.times[i])) place.refuse(key + "a finite time");
    if (i > 0 && !(track.times[i] > track.times[i - 1] && std::isfinite(track.times[i] - track.times[i - 1])))
      place.refuse(key + "a time later than that of the key before");
    if (!is_valid(track.values[i])) place.refuse(key + "finite numbers, and of rotations not only zeros");
  }
}

void check_scale(const Track<Vec3d>& track, const Place& place) {
  for (std::size_t i = 0; i < track.values.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double factor = track.values[i][axis];
      const std::string key = "scale, key " + std::to_string(i) + ": expected ";
      if (factor == 0) place.refuse(key + "factors other than 0");
      const bool is_mixed = i > 0 && track.interpolation == Interpolation::linear;
      if (is_mixed && (factor > 0) != (track.values[i - 1][axis] > 0)) {
        place.refuse(key + "factors with the signs of the key before, or steps, since 0 lies between");
      }
    }
  }
}

}  // namespace

double Animation::duration() const {
  double latest = 0;
  const auto see = [&](const std::vector<double>& times) {
    if (!times.empty()) latest = std::max(latest, times.back());
  };
  for (const Channel& channel : channels) {
    see(channel.translation.times);
    see(channel.rotation.times);
    see(channel.scale.times);
  }
  return latest;
}

Transform place(const Channel& channel, double time) {
  Transform placed;
  if (!channel.translation.is_empty()) placed = Transform::translation(value_at(channel.translation, time));
  if (!channel.rotation.is_empty()) placed = placed * Transform::rotation(value_at(channel.rotation, time));
  if (!channel.scale.is_empty()) placed = placed * Transform::scaling(value_at(channel.scale, time));
  return placed;
}

void check(const Animation& animation, const SceneGraph& graph) {
  std::set<NodeId> moved;
  for (const Channel& channel : animation.channels) {
    if (channel.node >= graph.size()) {
      Place{animation.name, std::to_string(channel.node)}.refuse("expected a node of the graph, which has " +
                                                                 std::to_string(graph.size()));
    }
    const Place place{animation.name, graph.path(channel.node)};
    if (!moved.insert(channel.node).second) place.refuse("expected one channel a node");
    check(channel.translation, "translation", place);
    check(channel.rotation, "rotation", place);
    check(channel.scale, "scale", place);
    check_scale(channel.scale, place);
  }
}

AnimationController::AnimationController(Animation animation)
    : animation_(std::move(animation)), duration_(animation_.duration()) {}

void AnimationController::pose(double time, std::vector<NodePose>& poses) const {
  double at = time;
  if (animation_.is_loop && duration_ > 0) {
    at = std::fmod(time, duration_);  // exact
    if (at < 0) at += duration_;
  }
  for (const Channel& channel : animation_.channels) poses.push_back({channel.node, place(channel, at)});
}

void apply(const std::vector<NodePose>& poses, SceneGraph& graph) {
  for (const auto& [node, local] : poses) {
    if (node >= graph.size()) {
      throw std::invalid_argument("pose: expected a node of the graph, which has " + std::to_string(graph.size()) +
                                  ", found " + std::to_string(node));
    }
    graph.set_local(node, local);
  }
}

}  // namespace sightline
