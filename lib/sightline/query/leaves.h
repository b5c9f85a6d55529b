#pragma once
/// Where queries find the shapes that leaf positions stand for, and how they test them.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/large_pages.h"
#include "sightline/math/level.h"
#include "sightline/shape/mesh.h"
#include "sightline/shape/shapes.h"
#include "sightline/shape/triangle_sieve.h"

namespace sightline {

/// The shapes where they are, found through the structure's leaf order and tested one by one: for shapes of any kind,
/// and for structures that still rearrange their order.
template <Shapes S>
class IndexedLeaves {
 public:
  IndexedLeaves(const S& shapes, std::span<const std::uint32_t> order) : shapes_(shapes), order_(order) {}

  template <class T>
  typename S::PreparedRay prepare(const Ray<T>& ray) const {
    return shapes_.prepare(to_double(ray));
  }

  /// Calls see(id, crossing) for the crossings of the leaf's shapes with the line of the ray until it returns
  /// false. Those beyond `far`, or before the ray's range, may be left out.
  template <class T, class See>
  void for_each_crossing(const typename S::PreparedRay& prepared, LeafRange leaf, T /*far*/, See&& see) const {
    bool goes_on = true;
    for (std::uint32_t i = 0; i < leaf.count && goes_on; ++i) {
      const std::uint32_t id = order_[leaf.first + i];
      prepared.for_each_crossing(shapes_[id],
                                 [&](const Crossing& crossing) { goes_on = goes_on && see(id, crossing); });
    }
  }

 private:
  const S& shapes_;
  std::span<const std::uint32_t> order_;
};

/// Triangles where they are, with t rounded to the nearest double: for double rays at the level `exact`.
class ExactLeaves {
 public:
  ExactLeaves(const TriangleMesh& mesh, std::span<const std::uint32_t> order) : mesh_(mesh), order_(order) {}

  TriangleRay prepare(const Ray<double>& ray) const { return mesh_.prepare(ray); }

  template <class See>
  void for_each_crossing(const TriangleRay& prepared, LeafRange leaf, double /*far*/, See&& see) const {
    for (const std::uint32_t id : order_.subspan(leaf.first, leaf.count)) {
      Crossing crossing;
      if (!prepared.intersect(mesh_[id], crossing)) continue;
      crossing.t = prepared.nearest_t(mesh_[id]);
      if (!see(id, crossing)) return;
    }
  }

 private:
  const TriangleMesh& mesh_;
  std::span<const std::uint32_t> order_;
};

/// Copies of the triangles in leaf order, as blocks of at most eight (structure of arrays), so that a leaf reads
/// consecutive memory and is tested at once. Made outside the structure, so that every structure shares it.
///   P1  The triangles at positions [first, first + count) of a block take the floats from first * rows on, whichever
///       leaf it belongs to: a leaf's place follows from its range.
class TriangleBlocks {
 public:
  /// `accel` is final: its leaf order does not change any more.
  template <Accelerator A>
  TriangleBlocks(const TriangleMesh& mesh, const A& accel) : floats_(accel.leaf_order().size() * rows + slack) {
    std::fill_n(floats_.data() + floats_.size() - slack, slack, 0.0f);
    std::vector<LeafRange> leaves;
    for_each_leaf(accel, [&](LeafRange leaf) { leaves.push_back(leaf); });
    const std::span<const std::uint32_t> order = accel.leaf_order();
    tbb::parallel_for(std::size_t(0), leaves.size(), [&](std::size_t i) {
      if (i + ahead < leaves.size()) {
        const LeafRange next = leaves[i + ahead];
        for (const std::uint32_t id : order.subspan(next.first, next.count)) mesh.fetch(id);
      }
      for (LeafRange leaf = leaves[i]; leaf.count > 0;) {
        const LeafRange block = next_block(leaf);
        for (std::uint32_t lane = 0; lane < block.count; ++lane) {
          const std::uint32_t id = order[block.first + lane];
          TriangleBlock::store(mesh[id], id, floats_.data() + at(block), block.count, lane);
        }
      }
    });
  }

  std::size_t memory_bytes() const { return floats_.size() * sizeof(float); }

  /// Has the leaf's triangles brought near, as far as one block reaches.
  void fetch(LeafRange leaf) const {
    prefetch(floats_.data() + at(leaf), std::min(leaf.count, TriangleBlock::lanes) * rows * sizeof(float));
  }

  /// The leaf's first block, which is taken away from it.
  static LeafRange next_block(LeafRange& leaf) {
    const LeafRange block{leaf.first, std::min(leaf.count, TriangleBlock::lanes)};
    leaf = {leaf.first + block.count, leaf.count - block.count};
    return block;
  }

  TriangleBlock operator[](LeafRange block) const { return {floats_.data() + at(block), block.count}; }

 private:
  static constexpr std::size_t rows = TriangleBlock::rows;
  static constexpr std::size_t ahead = 8;                     ///< Leaves whose triangles are on their way.
  static constexpr std::size_t slack = TriangleBlock::lanes;  ///< The last row may be read past its end.

  static std::size_t at(LeafRange block) { return block.first * rows; }  // P1

  LargeBuffer<float> floats_;
};

/// A ray as triangles are tested with. Each test is made ready when the first triangles need it: many rays meet none.
/// Refers to the ray, and to bounds of all triangles.
template <class T>
class PreparedTriangles {
 public:
  PreparedTriangles(const Ray<T>& ray, const Aabb& bounds) : ray_(ray), bounds_(bounds) {}

  [[gnu::always_inline]] const TriangleSieve& sieve() {
    if (!sieve_) sieve_.emplace(ray_, bounds_);
    return *sieve_;
  }
  const TriangleRay& exact() {
    if (!exact_) {
      const TriangleSieve& known = sieve();
      exact_.emplace(ray_, known.last_axis(), known.reach());
    }
    return *exact_;
  }
  const Ray<T>& ray() const { return ray_; }

 private:
  const Ray<T>& ray_;
  const Aabb& bounds_;
  std::optional<TriangleSieve> sieve_;
  std::optional<TriangleRay> exact_;
};

namespace detail {

/// Tests lanes exactly. False when `see` returned that.
template <class T, class See>
[[gnu::noinline]] bool decide(PreparedTriangles<T>& ray, const TriangleBlock& block, std::uint32_t lanes, See& see) {
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
    Crossing crossing;
    const TriangleRay& exact = ray.exact();
    const bool takes_behind = ray.ray().t_min < 0;
    if (exact.intersect_ordered(block.ordered(lane, exact.axes()), takes_behind, crossing) &&
        !see(block.id(lane), crossing))
      return false;
  }
  return true;
}

/// Calls see(id, crossing) for crossings of the block's triangles until it returns false, and returns that. Those
/// beyond `far`, or before the ray's range, may be left out.
template <Level level, class T, class See>
[[gnu::always_inline]] inline bool cross_block(PreparedTriangles<T>& ray, const TriangleBlock& block, T far, See& see) {
  static_assert(level != Level::fast || std::is_same_v<T, float>, "fast is a level of float rays");
  std::uint32_t unsure;
  if constexpr (level == Level::watertight) {
    unsure = ray.sieve().may_cross(block);
  } else {
    TriangleSieve::Crossings found;
    ray.sieve().cross(block, ray.ray().t_min, far, found);
    for (std::uint32_t lanes = found.hits; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      if (!see(block.id(lane), Crossing{found.t[lane], found.u[lane], found.v[lane]})) return false;
    }
    unsure = found.unsure;
  }
  return unsure == 0 || decide(ray, block, unsure, see);
}

}  // namespace detail

/// Triangle blocks as queries of one precision level test them. Refers to its parts.
template <Level level>
class PackedLeaves {
 public:
  PackedLeaves(const TriangleMesh& mesh, const TriangleBlocks& blocks) : bounds_(mesh.bounds()), blocks_(blocks) {}

  template <class T>
  PreparedTriangles<T> prepare(const Ray<T>& ray) const {
    return {ray, bounds_};
  }

  void fetch(LeafRange leaf) const { blocks_.fetch(leaf); }

  template <class T, class See>
  [[gnu::always_inline]] void for_each_crossing(PreparedTriangles<T>& ray, LeafRange leaf, T far, See&& see) const {
    while (leaf.count > 0) {
      if (!detail::cross_block<level>(ray, blocks_[TriangleBlocks::next_block(leaf)], far, see)) return;
    }
  }

 private:
  Aabb bounds_;
  const TriangleBlocks& blocks_;
};

}  // namespace sightline
