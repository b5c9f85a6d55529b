#pragma once

#include <vector>

#include "sightline/math/transform.h"
#include "sightline/scene/scene_graph.h"

namespace sightline {

/// Where a node is within its parent.
struct NodePose {
  NodeId node;
  Transform local;
};

/// The logic of a scene: which nodes are where at a time. It knows of nodes and places only, never of shapes, and
/// shapes know nothing of it.
class Controller {
 public:
  virtual ~Controller() = default;
  /// Appends the poses of those nodes that it moves, at a time in seconds. The same at the same time, whatever was
  /// asked before.
  virtual void pose(double time, std::vector<NodePose>& poses) const = 0;
};

/// The pose of a node that a hand has moved by a way in the world, so that what it holds follows.
inline Transform dragged(const Transform& local, const Transform& parent_world, const Vec3d& by) {
  return Transform::translation(parent_world.inverse().vector(by)) * local;
}

/// \throws std::invalid_argument for a pose of a node that is not in the graph.
void apply(const std::vector<NodePose>& poses, SceneGraph& graph);

}  // namespace sightline
