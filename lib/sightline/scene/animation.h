#pragma once
/// Motions of nodes by keys over time, apart from what they move.

#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

#include "sightline/math/transform.h"
#include "sightline/scene/controller.h"
#include "sightline/scene/scene_graph.h"

namespace sightline {

enum class Interpolation {
  step,   ///< Each key's value holds until the next one.
  linear  ///< Rotations go the shorter way, at even speed.
};

/// Values at times. Before the first key and after the last, those hold.
///   K1  As many times as values; times, in seconds, are finite and each above the one before.
template <class T>
struct Track {
  std::vector<double> times;
  std::vector<T> values;
  Interpolation interpolation = Interpolation::linear;

  bool is_empty() const { return times.empty(); }
  friend bool operator==(const Track&, const Track&) = default;
};

/// The motion of a node: translation * rotation * scaling is its place within its parent. A track without keys stands
/// for no translation, rotation or scaling; a part that does not move has one key.
struct Channel {
  NodeId node = root_node;
  Track<Vec3d> translation;
  Track<glm::dquat> rotation;  ///< By quaternions of any length but 0; q and -q are one rotation.
  Track<Vec3d> scale;

  friend bool operator==(const Channel&, const Channel&) = default;
};

/// Channels that run together, from time 0 to the latest of their keys, then again if it loops.
struct Animation {
  std::string name;
  std::vector<Channel> channels;
  bool is_loop = true;

  /// The latest time of a key; 0 without keys.
  double duration() const;

  friend bool operator==(const Animation&, const Animation&) = default;
};

/// Where a channel places its node at a time. \throws std::invalid_argument for a scale that is singular.
Transform place(const Channel& channel, double time);

/// \throws std::invalid_argument in one line that names animation, node and key: for nodes that are not in the graph or
/// have two channels, for tracks that break K1, values that are not finite, quaternions of length 0, scales of 0, and
/// those that change sign where a linear track would pass through 0.
void check(const Animation& animation, const SceneGraph& graph);

/// Plays an animation: at any time, where its nodes are.
class AnimationController final : public Controller {
 public:
  explicit AnimationController(Animation animation);
  void pose(double time, std::vector<NodePose>& poses) const override;
  const Animation& animation() const { return animation_; }

 private:
  Animation animation_;
  double duration_;
};

}  // namespace sightline
