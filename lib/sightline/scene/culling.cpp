#include "sightline/scene/culling.h"

#include <algorithm>

namespace sightline {
namespace {

/// Depth-first; leaves out all below a node that is hidden or whose bounds are not met. Clark, "Hierarchical Geometric
/// Models for Visible Surface Algorithms", 1976.
template <class V, class Meets>
Culled cull_by(LiveScene& scene, const Meets& meets) {
  scene.refresh(kind_of<V>);
  const SceneGraph& graph = scene.graph();
  Culled culled;
  for (NodeId node = root_node;;) {
    ++culled.tests;
    const bool is_met = graph.is_visible(node) && meets(scene.bounds<V>(node));
    const NodeId child = graph.first_child(node);
    if (is_met && graph.geometry(node) != no_item) {
      culled.tests += child != no_node;  // of a leaf both bounds are one
      if (child == no_node || meets(scene.own_bounds<V>(node))) culled.nodes.push_back(node);
    }
    if (is_met && child != no_node) {
      node = child;
      continue;
    }
    while (node != root_node && graph.next_sibling(node) == no_node) node = graph.parent(node);
    if (node == root_node) break;
    node = graph.next_sibling(node);
  }
  std::sort(culled.nodes.begin(), culled.nodes.end());
  return culled;
}

}  // namespace

Culled cull(LiveScene& scene, const VolumeRay& ray, BoundKind kind) {
  return with_kind(kind, [&]<class V>(const V&) {
    return cull_by<V>(scene, [&](const V& bounds) { return ray.may_meet(bounds); });
  });
}

Culled cull(LiveScene& scene, const ViewFrustum& view, BoundKind kind) {
  return with_kind(kind, [&]<class V>(const V&) {
    return cull_by<V>(scene, [&](const V& bounds) { return view.may_see(bounds); });
  });
}

}  // namespace sightline
