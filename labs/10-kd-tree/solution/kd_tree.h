#pragma once
/// Lab 10: a kd-tree.

#include "sightline/accel/accelerator.h"
#include "sightline/accel/fixed_stack.h"
#include "sightline/accel/padded_ray.h"

namespace student {

using namespace sightline;

struct KdTreeOptions {
  int max_leaf_size = 4;           ///< A cell that holds no more is never split.
  float traversal_cost = 1;        ///< Of one plane test, relative to ...
  float intersection_cost = 1.5f;  ///< ... one primitive test.

  static constexpr std::array<OptionField<KdTreeOptions>, 3> fields() {
    using O = KdTreeOptions;
    return {{{"max_leaf_size", &O::max_leaf_size, 1, 1024, "a cell that holds no more is never split"},
             {"traversal_cost", &O::traversal_cost, 0, 1000, "cost of one plane test"},
             {"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of one primitive test"}}};
  }
};

/// The two halves of a cell: below the plane axis = split, and above it.
inline std::pair<Aabb, Aabb> halves_of(const Aabb& cell, int axis, float split) {
  Aabb below = cell, above = cell;
  // lab:hole halves_of | 1. Two halves of a cell
  below.hi[axis] = split;
  above.lo[axis] = split;
  return {below, above};
  // lab:end
}

/// What a ray that crosses `cell` is expected to cost when the cell is split there: one plane test, and the primitives
/// of each half, `below` and `above` of them, times the chance that the ray meets that half.
inline double split_cost(const Aabb& cell, int axis, float split, std::uint32_t below, std::uint32_t above,
                         const KdTreeOptions& options) {
  // lab:hole split_cost | 2. What a split costs
  const auto [low, high] = halves_of(cell, axis, split);
  const double crossed = half_area(low) * below + half_area(high) * above;
  return options.traversal_cost + options.intersection_cost * crossed / half_area(cell);
  // lab:end
}

/// Which halves a primitive belongs to.
struct Sides {
  bool is_below = false, is_above = false;
};

/// Of a primitive that reaches from lo to hi along the axis. Never neither; both only where it really is on both sides:
/// one that just touches the plane belongs to its own side, one that lies in the plane belongs below.
inline Sides sides_of(float lo, float hi, float split) {
  // lab:hole sides_of | 3. Who goes where
  const bool is_above = hi > split;
  return {lo < split || !is_above, is_above};
  // lab:end
}

class KdTree {
 public:
  static constexpr std::string_view name = "my-kd-tree";
  static constexpr std::string_view description = "space halved by axis-aligned planes; written in a lab";
  static constexpr int max_depth = 48;
  using Options = KdTreeOptions;

  static KdTree build(const Primitives& primitives, const Options& options = {});

  std::size_t memory_bytes() const { return nodes_.size() * sizeof(Node) + order_.size() * sizeof(order_[0]); }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  template <class See>
  void for_each_cell(See&& see) const {
    if (!nodes_.empty()) show(0, bounds_, 0, see);
  }

 private:
  struct Node {
    float split = 0;
    int axis = -1;            ///< -1: a leaf.
    std::uint32_t below = 0;  ///< The child below the plane; the one above it follows.
    LeafRange range;          ///< Of a leaf.

    bool is_leaf() const { return axis < 0; }
  };
  class Builder;

  template <class See>
  void show(std::uint32_t index, const Aabb& cell, int depth, See& see) const {
    const Node& node = nodes_[index];
    see(Cell{cell, depth, node.is_leaf(), node.range, index});
    if (node.is_leaf()) return;
    const auto [below, above] = halves_of(cell, node.axis, node.split);
    show(node.below, below, depth + 1, see);
    show(node.below + 1, above, depth + 1, see);
  }

 public:
  static constexpr std::size_t node_bytes = sizeof(Node);

 private:
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;  ///< Primitives, leaf by leaf.
  Aabb bounds_;
};

// ---- Traversal

template <class T, LeafVisitor<T> Visit, class Probe>
void KdTree::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  if (nodes_.empty()) return;
  const PaddedRay<T> padded(ray, bounds_);
  const Interval<T> range = padded.clip(bounds_, padded.t_max);  // empty where the ray is broken
  if (range.is_empty()) return;
  struct Visited {
    std::uint32_t node;
    T enter, leave;
  };
  FixedStack<Visited, max_depth + 1> aside;
  Visited at{0, range.lo, range.hi};
  T far = ray.t_max;
  // lab:hole KdTree::traverse | 5. The walk
  for (;;) {
    const Node& node = nodes_[at.node];
    bool goes_on = false;
    if (!node.is_leaf()) {
      probe.node(at.node, at.enter);
      const std::uint32_t above = padded.is_negative[node.axis] ? 0 : 1;
      const T leave_near = padded.leave(node.axis, node.split), enter_far = padded.enter(node.axis, node.split);
      // Written so that NaN, where the ray runs in the plane, keeps both halves.
      const Visited near{node.below + 1 - above, at.enter, leave_near < at.leave ? leave_near : at.leave};
      const Visited beyond{node.below + above, enter_far > at.enter ? enter_far : at.enter, at.leave};
      const bool meets_near = !(near.enter > near.leave), meets_far = !(beyond.enter > beyond.leave);
      if (meets_near && meets_far) aside.push(beyond);
      if (meets_near || meets_far) {
        at = meets_near ? near : beyond;
        goes_on = true;
      }
    } else if (node.range.count == 0) {
      probe.node(at.node, at.enter);
    } else {
      probe.leaf(at.node, node.range, at.enter);
      far = visit(node.range);
    }
    while (!goes_on) {
      if (aside.empty()) return;
      at = aside.pop();
      goes_on = !(at.enter > far);
      if (!goes_on) probe.cull(at.node, at.enter);
    }
    if (at.leave > far) at.leave = far;
  }
  // lab:end
}

// ---- Construction

class KdTree::Builder {
 public:
  Builder(const Primitives& primitives, const Options& options, KdTree& tree)
      : primitives_(primitives), options_(options), tree_(tree) {}

  void build() {
    std::vector<Reference> all;
    for (std::uint32_t id = 0; id < primitives_.size(); ++id) {
      all.push_back({id, primitives_.bounds(id)});
      tree_.bounds_.extend(all.back().box);
    }
    const int usual = static_cast<int>(8 + 1.3 * std::log2(double(primitives_.size())));
    tree_.nodes_.emplace_back();
    divide(0, std::move(all), tree_.bounds_, std::min(usual, max_depth));
  }

 private:
  struct Reference {
    std::uint32_t id;
    Aabb box;  ///< Of the part of the primitive within the cell.
  };
  struct Split {
    int axis = -1;
    float at = 0;
    double cost = std::numeric_limits<double>::infinity();
  };

  /// The cheapest plane through a face of a box, of any axis, strictly within the cell.
  Split best_split(const std::vector<Reference>& references, const Aabb& cell) const {
    Split best;
    // lab:hole best_split | 4. The best plane
    std::vector<float> lows, highs, flats;
    for (int axis = 0; axis < 3; ++axis) {
      lows.clear(), highs.clear(), flats.clear();
      for (const Reference& reference : references) {
        lows.push_back(reference.box.lo[axis]);
        highs.push_back(reference.box.hi[axis]);
        if (lows.back() == highs.back()) flats.push_back(lows.back());
      }
      std::ranges::sort(lows);
      std::ranges::sort(highs);
      std::ranges::sort(flats);
      for (const std::vector<float>* faces : {&lows, &highs}) {
        for (const float at : *faces) {
          if (!(at > cell.lo[axis] && at < cell.hi[axis])) continue;
          const auto in_plane = std::ranges::equal_range(flats, at).size();
          const auto below = static_cast<std::uint32_t>(std::ranges::lower_bound(lows, at) - lows.begin());
          const auto above = static_cast<std::uint32_t>(highs.end() - std::ranges::upper_bound(highs, at));
          const double cost = split_cost(cell, axis, at, below + static_cast<std::uint32_t>(in_plane), above, options_);
          if (cost < best.cost) best = {axis, at, cost};
        }
      }
    }
    // lab:end
    return best;
  }

  void divide(std::uint32_t index, std::vector<Reference> references, const Aabb& cell, int depth) {
    const auto count = static_cast<double>(references.size());
    const bool is_small = references.size() <= static_cast<std::size_t>(options_.max_leaf_size);
    const Split split = is_small || depth == 0 ? Split{} : best_split(references, cell);
    if (split.axis < 0 || split.cost >= options_.intersection_cost * count) return make_leaf(index, references);
    const auto [cell_below, cell_above] = halves_of(cell, split.axis, split.at);
    std::vector<Reference> below, above;
    for (const Reference& reference : references) {
      const Sides sides = sides_of(reference.box.lo[split.axis], reference.box.hi[split.axis], split.at);
      const bool is_cut = sides.is_below && sides.is_above;
      if (sides.is_below) add(below, reference, cell_below, is_cut);
      if (sides.is_above) add(above, reference, cell_above, is_cut);
    }
    references = {};
    const auto child = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.resize(child + 2);
    tree_.nodes_[index] = {split.at, split.axis, child, {}};
    divide(child, std::move(below), cell_below, depth - 1);
    divide(child + 1, std::move(above), cell_above, depth - 1);
  }

  /// A primitive that the plane cuts is bounded anew: only its part in the half counts.
  void add(std::vector<Reference>& half, const Reference& reference, const Aabb& cell, bool is_cut) const {
    const Aabb box = is_cut ? primitives_.clip(reference.id, intersection(reference.box, cell)) : reference.box;
    if (!box.is_empty()) half.push_back({reference.id, box});
  }

  void make_leaf(std::uint32_t index, const std::vector<Reference>& references) {
    const auto first = static_cast<std::uint32_t>(tree_.order_.size());
    for (const Reference& reference : references) tree_.order_.push_back(reference.id);
    tree_.nodes_[index].range = {first, static_cast<std::uint32_t>(references.size())};
  }

  const Primitives& primitives_;
  const Options& options_;
  KdTree& tree_;
};

inline KdTree KdTree::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  KdTree tree;
  if (primitives.size() > 0) Builder(primitives, options, tree).build();
  return tree;
}

static_assert(Accelerator<KdTree>);

}  // namespace student
