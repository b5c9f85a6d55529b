/// From the root down: of what overlaps, the parts are held against one another. Parts of a node, or of two, are swept
/// along the axis on which they are spread the widest, so that a node of many children does not take the square of
/// their number (Baraff, "Dynamic Simulation of Non-penetrating Rigid Bodies", 1992; Cohen, Lin, Manocha and Ponamgi,
/// "I-COLLIDE", 1995).

#include "sightline/scene/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sightline/math/volume_overlap.h"

namespace sightline {
namespace {

/// A node with all below it, or its own geometry alone.
struct Part {
  NodeId node;
  bool is_own;
};

template <class V>
class Search {
 public:
  explicit Search(LiveScene& scene) : scene_(scene), graph_(scene.graph()) { scene.refresh(kind_of<V>); }

  Overlaps run() {
    within_.push_back(root_node);
    while (!within_.empty() || !between_.empty()) {
      if (!between_.empty()) {
        const auto [a, b] = between_.back();
        between_.pop_back();
        split(a, b);
      } else {
        const NodeId node = within_.back();
        within_.pop_back();
        split(node);
      }
    }
    std::sort(found_.pairs.begin(), found_.pairs.end());
    return std::move(found_);
  }

 private:
  struct Item {
    Part part;
    V bounds;
    int side;  ///< Items of one side are not held against each other where there are two.
    Interval<double> extent;
  };

  bool is_leaf(NodeId node) const { return graph_.first_child(node) == no_node; }

  V bounds_of(const Part& part) const {
    return part.is_own ? scene_.template own_bounds<V>(part.node) : scene_.template bounds<V>(part.node);
  }

  void add(const Part& part, int side) {
    const V bounds = bounds_of(part);
    if (!is_nothing(bounds)) items_.push_back({part, bounds, side, {}});
  }

  /// The parts of a node; a leaf, and what is its own, stay one.
  void add_parts(const Part& whole, int side) {
    if (whole.is_own || is_leaf(whole.node)) return add({whole.node, true}, side);
    add({whole.node, true}, side);
    for (NodeId child = graph_.first_child(whole.node); child != no_node; child = graph_.next_sibling(child)) {
      add({child, is_leaf(child)}, side);
    }
  }

  void split(NodeId node) {
    items_.clear();
    add_parts({node, false}, 0);
    for (const Item& item : items_) {
      if (!item.part.is_own) within_.push_back(item.part.node);
    }
    sweep(false);
  }

  void split(const Part& a, const Part& b) {
    items_.clear();
    add_parts(a, 0);
    add_parts(b, 1);
    const V whole_a = bounds_of(a), whole_b = bounds_of(b);
    found_.tests += items_.size();
    std::erase_if(items_,
                  [&](const Item& item) { return !may_overlap(item.bounds, item.side == 0 ? whole_b : whole_a); });
    sweep(true);
  }

  void sweep(bool has_sides) {
    const int axis = widest_axis();
    for (Item& item : items_) item.extent = extent_along(item.bounds, axis);
    std::sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) { return a.extent.lo < b.extent.lo; });
    active_.clear();
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const Item& item = items_[i];
      std::erase_if(active_, [&](std::size_t k) { return items_[k].extent.hi < item.extent.lo; });
      for (const std::size_t k : active_) {
        if (has_sides && items_[k].side == item.side) continue;
        ++found_.tests;
        if (may_overlap(items_[k].bounds, item.bounds)) meet(items_[k].part, item.part);
      }
      active_.push_back(i);
    }
  }

  void meet(const Part& a, const Part& b) {
    if (a.is_own && b.is_own) {
      found_.pairs.emplace_back(std::min(a.node, b.node), std::max(a.node, b.node));
    } else {
      between_.emplace_back(a, b);
    }
  }

  /// Of the middles; those that are not finite do not count.
  int widest_axis() const {
    Vec3d lo(std::numeric_limits<double>::infinity()), hi(-lo);
    for (const Item& item : items_) {
      for (int axis = 0; axis < 3; ++axis) {
        const Interval<double> extent = extent_along(item.bounds, axis);
        const double middle = 0.5 * extent.lo + 0.5 * extent.hi;
        if (!std::isfinite(middle)) continue;
        lo[axis] = std::min(lo[axis], middle);
        hi[axis] = std::max(hi[axis], middle);
      }
    }
    return largest_axis(hi - lo);
  }

  LiveScene& scene_;
  const SceneGraph& graph_;
  std::vector<NodeId> within_;
  std::vector<std::pair<Part, Part>> between_;
  std::vector<Item> items_;
  std::vector<std::size_t> active_;
  Overlaps found_;
};

}  // namespace

Overlaps find_overlaps(LiveScene& scene, BoundKind kind) {
  return with_kind(kind, [&]<class V>(const V&) { return Search<V>(scene).run(); });
}

}  // namespace sightline
