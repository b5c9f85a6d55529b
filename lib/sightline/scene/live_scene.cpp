#include "sightline/scene/live_scene.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sightline/math/enclosure_image.h"
#include "sightline/scene/geometry_bounds.h"

namespace sightline {
namespace {

constexpr std::uint8_t bit_of(BoundKind kind) { return static_cast<std::uint8_t>(1 << static_cast<int>(kind)); }

const Aabb& closer_to_box(const Aabb& made, const Aabb&) { return made; }
Sphere closer_to_box(const Sphere& made, const Aabb& box) { return closer_of(made, ball_around(box)); }
Cylinder closer_to_box(const Cylinder& made, const Aabb& box) { return closer_of(made, cylinder_around(box)); }

}  // namespace

LiveScene::LiveScene(Scene scene) : scene_(std::move(scene)), states_(scene_.graph.size()) {
  for (const Geometry& geometry : scene_.geometries) shapes_.push_back(enclosure_of(geometry));
  for (NodeId node = 0; node < graph().size(); ++node) require_geometry(node, graph().geometry(node));
}

void LiveScene::require_geometry(NodeId node, std::uint32_t geometry) const {
  if (geometry == no_item || geometry < shapes_.size()) return;
  throw std::invalid_argument("scene graph: expected node " + graph().path(node) + " to have one of " +
                              std::to_string(shapes_.size()) + " geometries, found number " + std::to_string(geometry));
}

// ---- Changes

NodeId LiveScene::add(NodeId parent, std::string name, const Transform& local, std::uint32_t geometry) {
  require_geometry(parent, geometry);
  const NodeId node = scene_.graph.add(parent, std::move(name), local);
  scene_.graph.set_geometry(node, geometry);
  states_.emplace_back();
  states_[node].moved = ++now_;
  bubble(parent, node);
  return node;
}

void LiveScene::set_local(NodeId node, const Transform& local) {
  scene_.graph.set_local(node, local);
  states_[node].moved = ++now_;
  bubble(node, node);
}

void LiveScene::move(NodeId node, NodeId parent) {
  const NodeId left = graph().parent(node);
  scene_.graph.move(node, parent);
  states_[node].moved = ++now_;
  bubble(left, node);
  bubble(node, node);
  if (states_[parent].stale != all_kinds) bubble(parent, node);  // the node may have been marked where it was
}

void LiveScene::set_geometry(NodeId node, std::uint32_t geometry) {
  require_geometry(node, geometry);
  scene_.graph.set_geometry(node, geometry);
  states_[node].own_stale = all_kinds;
  bubble(node, node);
}

void LiveScene::replace_geometry(std::uint32_t geometry, Geometry shape) {
  if (geometry >= shapes_.size()) {
    throw std::invalid_argument("scene: expected one of " + std::to_string(shapes_.size()) +
                                " geometries to replace, found number " + std::to_string(geometry));
  }
  shapes_[geometry] = enclosure_of(shape);
  scene_.geometries[geometry] = std::move(shape);
  for (NodeId node = 0; node < graph().size(); ++node) {
    if (graph().geometry(node) == geometry) set_geometry(node, geometry);
  }
}

void LiveScene::apply(std::span<const NodePose> poses) {
  for (const auto& [node, local] : poses) {
    if (node >= graph().size()) {
      throw std::invalid_argument("pose: expected a node of the graph, which has " + std::to_string(graph().size()) +
                                  ", found " + std::to_string(node));
    }
    set_local(node, local);
  }
}

/// L2.
void LiveScene::bubble(NodeId from, NodeId changed) {
  way_.clear();
  for (NodeId node = from; node != no_node && states_[node].stale != all_kinds; node = graph().parent(node)) {
    states_[node].stale = all_kinds;
    way_.push_back(node);
  }
  counters_.marked += way_.size();
  for (const Observation& each : observers_) each.observer({changed, way_});
}

std::uint32_t LiveScene::subscribe(Observer observer) {
  observers_.push_back({next_subscription_, std::move(observer)});
  return next_subscription_++;
}

void LiveScene::unsubscribe(std::uint32_t subscription) {
  std::erase_if(observers_, [&](const Observation& each) { return each.subscription == subscription; });
}

// ---- Places

/// L3, of a node whose parent is in place.
void LiveScene::place_below_parent(NodeId node) {
  State& state = states_[node];
  if (state.checked == now_) return;
  const NodeId parent = graph().parent(node);
  if (state.computed < std::max(state.moved, parent == no_node ? 0 : states_[parent].computed)) {
    const Transform& local = graph().local(node);
    const Transform world = parent == no_node ? local : states_[parent].world * local;
    if (!is_finite(world.matrix()) || !is_finite(world.inverse())) {
      throw std::invalid_argument("scene graph: expected transforms whose product is within the range of double at " +
                                  graph().path(node));
    }
    state.world = world;
    state.computed = now_;
    state.stale = state.own_stale = all_kinds;
    ++counters_.worlds;
  }
  state.checked = now_;
}

void LiveScene::place(NodeId node) {
  way_.clear();
  for (NodeId above = node; above != no_node && states_[above].checked != now_; above = graph().parent(above)) {
    way_.push_back(above);
  }
  for (auto it = way_.rbegin(); it != way_.rend(); ++it) place_below_parent(*it);
}

const Transform& LiveScene::world(NodeId node) {
  place(node);
  return states_[node].world;
}

// ---- Bounds

/// Parents after their children, and only those that are stale (L4).
void LiveScene::refresh(NodeId asked, BoundKind kind) {
  place(asked);
  const Kinds bit = bit_of(kind);
  if ((states_[asked].stale & bit) == 0) return;
  NodeId node = asked, child = graph().first_child(asked);
  while (true) {
    for (; child != no_node; child = graph().next_sibling(child)) {
      place_below_parent(child);
      ++counters_.children_read;
      if ((states_[child].stale & bit) != 0) break;
    }
    if (child != no_node) {
      node = child;
      child = graph().first_child(node);
      continue;
    }
    compute_bounds(node, kind);
    if (node == asked) return;
    child = graph().next_sibling(node);
    node = graph().parent(node);
  }
}

void LiveScene::compute_bounds(NodeId node, BoundKind kind) {
  State& state = states_[node];
  if ((state.stale & bit_of(BoundKind::box)) != 0) compute<Aabb>(state, node);  // others are never larger than its
  if (kind == BoundKind::sphere) compute<Sphere>(state, node);
  if (kind == BoundKind::cylinder) compute<Cylinder>(state, node);
  ++counters_.bounds;
}

/// Of the node's own geometry, and around that and the bounds of the children, which are up to date.
template <class V>
void LiveScene::compute(State& state, NodeId node) {
  constexpr Kinds bit = bit_of(kind_of<V>);
  if ((state.own_stale & bit) != 0) {
    const std::uint32_t geometry = graph().geometry(node);
    state.own.get<V>() = geometry == no_item
                             ? Enclosure().get<V>()
                             : EnclosureImage(state.world.matrix(), shapes_[geometry]).template get<V>();
    state.own_stale = static_cast<Kinds>(state.own_stale & ~bit);
  }
  std::vector<V>* const scratch = [&] {
    if constexpr (kind_of<V> == BoundKind::box) return &boxes_;
    if constexpr (kind_of<V> == BoundKind::sphere) return &spheres_;
    if constexpr (kind_of<V> == BoundKind::cylinder) return &cylinders_;
  }();
  scratch->clear();
  const NodeId first = graph().first_child(node);
  const V& own = state.own.get<V>();
  if (!is_nothing(own)) scratch->push_back(own);
  for (NodeId child = first; child != no_node; child = graph().next_sibling(child)) {
    const V& part = states_[child].all.get<V>();
    if (!is_nothing(part)) scratch->push_back(part);
  }
  const V made = around(std::span<const V>(*scratch));
  state.all.get<V>() = scratch->size() > 1 ? closer_to_box(made, state.all.box) : made;
  state.stale = static_cast<Kinds>(state.stale & ~bit);
}

}  // namespace sightline
