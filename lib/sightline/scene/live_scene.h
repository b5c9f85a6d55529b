#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sightline/math/enclosure.h"
#include "sightline/scene/controller.h"
#include "sightline/scene/scene.h"

namespace sightline {

/// A scene in motion: places and bounds of its nodes in the world, which follow what is changed.
///
/// The scene stays a plain value that knows nothing of this. Who moves things, a controller or a hand, calls the
/// functions here, and bounds are right whenever they are asked for, at the cost of what has changed in between:
///   L1  Only this changes the scene, so no change is missed.
///   L2  A change bubbles up from its node and marks bounds as stale, until it comes to a node that is marked already:
///       then all above are. So of many changes between two questions none goes the same way twice.
///   L3  A place in the world is kept with the time at which it was computed. It is stale where the node, or one above
///       it, was moved later; nobody tells those below. Whoever recomputes a place marks the bounds there as stale.
///   L4  Where bounds of a kind are up to date, so are they of all nodes below.
///   L5  A node's place is the product of its parent's and its own transform, in this order, so that it has the bits of
///       SceneGraph::world.
/// Changes cost as many steps as a node has ancestors at most. Questions recompute what is stale below the node asked
/// for, each node once. They fill in what is kept here, so ask from one thread. Nothing calls itself.
class LiveScene {
 public:
  /// \throws std::invalid_argument for a node whose geometry is not in the list, and for solids that make no sense.
  explicit LiveScene(Scene scene);

  const Scene& scene() const { return scene_; }
  const SceneGraph& graph() const { return scene_.graph; }

  // ---- Changes; each bubbles but the last.

  NodeId add(NodeId parent, std::string name, const Transform& local = {}, std::uint32_t geometry = no_item);
  void set_local(NodeId node, const Transform& local);
  /// \throws as SceneGraph::move does.
  void move(NodeId node, NodeId parent);
  void set_geometry(NodeId node, std::uint32_t geometry);
  /// Another shape for all nodes that have the geometry.
  void replace_geometry(std::uint32_t geometry, Geometry shape);
  void apply(std::span<const NodePose> poses);
  /// Bounds are of hidden nodes too, so nothing bubbles.
  void set_visible(NodeId node, bool is_visible) { scene_.graph.set_visible(node, is_visible); }

  // ---- Questions. References hold until the next call.

  /// \throws std::invalid_argument naming the node where products leave the range of double.
  const Transform& world(NodeId node);
  /// Of the node's own geometry; nothing where it has none. V is Aabb, Sphere or Cylinder.
  template <class V>
  const V& own_bounds(NodeId node) {
    refresh(node, kind_of<V>);
    return states_[node].own.template get<V>();
  }
  /// Of the node's geometry and all below it.
  template <class V>
  const V& bounds(NodeId node) {
    refresh(node, kind_of<V>);
    return states_[node].all.template get<V>();
  }
  /// Brings all bounds of a kind up to date.
  void refresh(BoundKind kind) { refresh(root_node, kind); }

  // ---- Events

  /// A change at `node`, and the nodes that it marked in the order in which it passed them, from the one that changed
  /// upward; none where the bounds there were stale already (L2).
  struct Bubble {
    NodeId node;
    std::span<const NodeId> way;
  };
  using Observer = std::function<void(const Bubble&)>;
  /// Tells `observer` of each bubble, while it rises, until unsubscribed. Observers do not change the scene, nor ask
  /// it.
  std::uint32_t subscribe(Observer observer);
  void unsubscribe(std::uint32_t subscription);

  /// What has been done so far.
  struct Counters {
    std::uint64_t marked = 0;         ///< Nodes whose bounds became stale by a bubble.
    std::uint64_t worlds = 0;         ///< Places computed.
    std::uint64_t bounds = 0;         ///< Nodes whose bounds of a kind were computed.
    std::uint64_t children_read = 0;  ///< Bounds of children looked at for these.
  };
  const Counters& counters() const { return counters_; }

 private:
  using Time = std::uint64_t;
  using Kinds = std::uint8_t;  ///< A bit for each kind.
  static constexpr Kinds all_kinds = 7;

  struct State {
    Transform world;
    Time moved = 1;     ///< When the transform or the parent last changed.
    Time computed = 0;  ///< When `world` was.
    Time checked = 0;   ///< When `world` was last known to be right.
    Enclosure own, all;
    Kinds own_stale = all_kinds, stale = all_kinds;
  };

  struct Observation {
    std::uint32_t subscription;
    Observer observer;
  };

  void refresh(NodeId node, BoundKind kind);
  void place(NodeId node);
  void place_below_parent(NodeId node);
  void compute_bounds(NodeId node, BoundKind kind);
  template <class V>
  void compute(State& state, NodeId node);
  void bubble(NodeId from, NodeId changed);
  void require_geometry(NodeId node, std::uint32_t geometry) const;

  Scene scene_;
  std::vector<Enclosure> shapes_;  ///< Of the geometries, each in its own coordinates.
  std::vector<State> states_;
  Time now_ = 1;
  std::vector<Observation> observers_;
  std::uint32_t next_subscription_ = 0;
  std::vector<NodeId> way_;
  std::vector<Aabb> boxes_;
  std::vector<Sphere> spheres_;
  std::vector<Cylinder> cylinders_;
  Counters counters_;
};

}  // namespace sightline
