#pragma once
/// The kd-tree of textbooks: points in nodes, split across the axes in turn.
///   P1  Below a node are points whose coordinate along its axis is at most the node's, above such that are at least.
/// Bentley, "Multidimensional binary search trees used for associative searching", 1975.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sightline::bench {

template <int dimensions>
class PointTree {
 public:
  using Point = std::array<float, dimensions>;
  struct Found {
    std::uint64_t visited = 0;   ///< Nodes.
    std::uint64_t reported = 0;  ///< Points within the range.
  };

  /// Each node the median of what is below it.
  static PointTree balanced(std::vector<Point> points) {
    PointTree tree;
    tree.nodes_.reserve(points.size());
    tree.root_ = tree.grow(points, 0);
    return tree;
  }

  /// One after the other, as they come. Returns the nodes that it was compared with.
  std::uint64_t insert(const Point& point) {
    std::uint64_t compared = 0;
    std::int32_t parent = -1;
    bool is_above = false;
    for (std::int32_t at = root_; at >= 0; ++compared) {
      const int axis = static_cast<int>(compared % dimensions);
      parent = at;
      is_above = point[axis] >= nodes_[at].point[axis];
      at = is_above ? nodes_[at].above : nodes_[at].below;
    }
    const auto self = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({point, -1, -1});
    if (parent < 0) {
      root_ = self;
    } else {
      (is_above ? nodes_[parent].above : nodes_[parent].below) = self;
    }
    return compared;
  }

  /// All points within [lo, hi].
  Found search(const Point& lo, const Point& hi) const {
    Found found;
    search(root_, 0, lo, hi, found);
    return found;
  }

 private:
  struct Node {
    Point point;
    std::int32_t below, above;  ///< -1 for none.
  };

  std::int32_t grow(std::span<Point> points, int axis) {
    if (points.empty()) return -1;
    const std::size_t middle = points.size() / 2;
    std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(middle), points.end(),
                     [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    const auto self = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({points[middle], -1, -1});
    const int next = (axis + 1) % dimensions;
    const std::int32_t below = grow(points.first(middle), next), above = grow(points.subspan(middle + 1), next);
    nodes_[self].below = below, nodes_[self].above = above;
    return self;
  }

  void search(std::int32_t at, int axis, const Point& lo, const Point& hi, Found& found) const {
    if (at < 0) return;
    const Node& node = nodes_[at];
    ++found.visited;
    bool is_inside = true;
    for (int a = 0; a < dimensions; ++a) is_inside &= node.point[a] >= lo[a] && node.point[a] <= hi[a];
    found.reported += is_inside;
    const int next = (axis + 1) % dimensions;
    if (lo[axis] <= node.point[axis]) search(node.below, next, lo, hi, found);  // P1
    if (hi[axis] >= node.point[axis]) search(node.above, next, lo, hi, found);
  }

  std::vector<Node> nodes_;
  std::int32_t root_ = -1;
};

}  // namespace sightline::bench
