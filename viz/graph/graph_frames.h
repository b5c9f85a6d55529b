#pragma once
/// What pictures of a scene graph tell: how it stands, a change step by step, a motion.

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "sightline/scene/live_scene.h"

namespace sightline::viz {

using Bound = std::variant<Aabb, Sphere, Cylinder>;

bool is_nothing(const Bound& bound);
bool is_unbounded(const Bound& bound);
/// In cubic units of the world; 0 of nothing, infinity of what has no bounds.
double volume_of(const Bound& bound);

/// All nodes' places and bounds at one time.
struct Snapshot {
  std::vector<Affine> worlds;
  std::vector<Bound> bounds;  ///< Each of a node and all below it.
};
using SharedSnapshot = std::shared_ptr<const Snapshot>;

SharedSnapshot snapshot_of(LiveScene& scene, BoundKind kind);

/// A node that a hand has moved, and what followed.
struct Change {
  NodeId node = root_node;
  Vec3d by{0};
  SharedSnapshot before, after;
  std::vector<NodeId> way;     ///< Nodes that the event passed, in order: from `node` up to the root.
  LiveScene::Counters work{};  ///< From asking for bounds before to having them after.
};

/// Moves the node by a way in the world. All bounds of the kind are asked for before and after.
Change drag(LiveScene& scene, NodeId node, const Vec3d& by, BoundKind kind);

struct GraphFrame {
  std::string title, text;
  SharedSnapshot places;          ///< Where things are.
  SharedSnapshot bounds;          ///< Bounds as they are known: stale ones are those of before.
  SharedSnapshot former;          ///< Bounds to compare with; or none.
  std::vector<NodeId> told = {};  ///< Nodes that know of a change, in the order in which the event has passed them.
  bool is_stale = false;          ///< Bounds of nodes that were told are not asked for again yet.
  NodeId moved = no_node;         ///< The node whose place was changed, by a hand.
};

inline constexpr int most_frames = 24, most_drag_frames = 12;

/// Before, the event on its way up in as many steps as there are frames for, and after. `count` is at least 2.
std::vector<GraphFrame> frames_of(const Change& change, const SceneGraph& graph, int count);

/// Those that a controller poses at `count` times, evenly from the first to the last; `told` is what its events pass.
std::vector<GraphFrame> frames_of(LiveScene& scene, const Controller& controller, double first, double last, int count,
                                  BoundKind kind);

/// As it stands.
GraphFrame still_frame(LiveScene& scene, BoundKind kind);

/// Poses the scene; the nodes that events pass while this is done, each once.
std::vector<NodeId> pose(LiveScene& scene, const Controller& controller, double time);

/// With four significant digits.
std::string short_number(double x);
/// "1 node", "5 nodes".
std::string counted(std::uint64_t count, const std::string& noun);

}  // namespace sightline::viz
