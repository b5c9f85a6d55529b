#pragma once
/// Where queries find the shapes that leaf positions stand for, and how they test them.

#include <tbb/parallel_for.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/large_pages.h"
#include "sightline/query/level.h"
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

/// Copies of the triangles in leaf order, as blocks of at most eight (structure of arrays), so that a leaf reads
/// consecutive memory and is tested at once. Made outside the structure, so that every structure shares it.
///   P1  The triangles at positions [first, first + count) of a block take the floats from first * rows on, whichever
///       leaf it belongs to: a leaf's place follows from its range.
class TriangleBlocks {
 public:
  /// `accel` is final: its leaf order does not change any more.
  template <Accelerator A>
  TriangleBlocks(const TriangleMesh& mesh, const A& accel) : floats_(accel.leaf_order().size() * rows + slack) {
    std::vector<LeafRange> leaves;
    for_each_leaf(accel, [&](LeafRange leaf) { leaves.push_back(leaf); });
    const std::span<const std::uint32_t> order = accel.leaf_order();
    tbb::parallel_for(std::size_t(0), leaves.size(), [&](std::size_t i) {
      for_each_block(leaves[i], [&](LeafRange block) {
        for (std::uint32_t lane = 0; lane < block.count; ++lane) {
          const std::uint32_t id = order[block.first + lane];
          TriangleBlock::store(mesh[id], id, floats_.data() + at(block), block.count, lane);
        }
        return true;
      });
    });
  }

  std::size_t memory_bytes() const { return floats_.size() * sizeof(float); }

  /// Has the leaf's triangles brought near, as far as one block reaches.
  void fetch(LeafRange leaf) const {
    prefetch(floats_.data() + at(leaf), std::min(leaf.count, TriangleBlock::lanes) * rows * sizeof(float));
  }

  /// Calls see(block) until it returns false.
  template <class See>
  void for_each(LeafRange leaf, See&& see) const {
    for_each_block(leaf, [&](LeafRange block) { return see(TriangleBlock(floats_.data() + at(block), block.count)); });
  }

 private:
  static constexpr std::size_t rows = TriangleBlock::rows;
  static constexpr std::size_t slack = TriangleBlock::lanes;  ///< The last row may be read past its end.

  static std::size_t at(LeafRange block) { return block.first * rows; }  // P1

  template <class See>
  static void for_each_block(LeafRange leaf, See&& see) {
    while (leaf.count > 0) {
      const LeafRange block{leaf.first, std::min(leaf.count, TriangleBlock::lanes)};
      if (!see(block)) return;
      leaf = {leaf.first + block.count, leaf.count - block.count};
    }
  }

  LargeVector<float> floats_;
};

/// Triangle blocks as queries of one precision level test them. Refers to its parts.
template <Level level>
class PackedLeaves {
 public:
  PackedLeaves(const TriangleMesh& mesh, const TriangleBlocks& blocks) : bounds_(mesh.bounds()), blocks_(blocks) {}

  /// Each test is made ready when the first triangles need it: many rays meet none.
  template <class T>
  class PreparedRay {
   public:
    PreparedRay(const Ray<T>& ray, const Aabb& bounds) : ray_(ray), bounds_(bounds) {}

    const TriangleSieve& sieve() {
      if (!sieve_) sieve_.emplace(ray_, bounds_);
      return *sieve_;
    }
    const TriangleRay& exact() {
      if (!exact_) exact_.emplace(to_double(ray_), bounds_);
      return *exact_;
    }
    float t_min() const { return static_cast<float>(ray_.t_min); }

   private:
    const Ray<T>& ray_;
    const Aabb& bounds_;
    std::optional<TriangleSieve> sieve_;
    std::optional<TriangleRay> exact_;
  };

  template <class T>
  PreparedRay<T> prepare(const Ray<T>& ray) const {
    return {ray, bounds_};
  }

  void fetch(LeafRange leaf) const { blocks_.fetch(leaf); }

  template <class T, class See>
  void for_each_crossing(PreparedRay<T>& ray, LeafRange leaf, T far, See&& see) const {
    static_assert(level != Level::fast || std::is_same_v<T, float>, "fast is a level of float rays");
    blocks_.for_each(leaf, [&](const TriangleBlock& block) {
      const auto for_each_lane = [&](std::uint32_t lanes, auto&& crossing_of) {
        for (; lanes != 0; lanes &= lanes - 1) {
          const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
          Crossing crossing;
          if (crossing_of(lane, crossing) && !see(block.id(lane), crossing)) return false;
        }
        return true;
      };
      const auto exactly = [&](std::uint32_t lane, Crossing& crossing) {
        return ray.exact().intersect(block[lane], crossing);
      };
      if constexpr (level == Level::watertight) {
        return for_each_lane(ray.sieve().may_cross(block), exactly);
      } else {
        TriangleSieve::Crossings found;
        ray.sieve().cross(block, ray.t_min(), far, found);
        const auto as_found = [&](std::uint32_t lane, Crossing& crossing) {
          crossing = {found.t[lane], found.u[lane], found.v[lane]};
          return true;
        };
        return for_each_lane(found.hits, as_found) && for_each_lane(found.unsure, exactly);
      }
    });
  }

 private:
  Aabb bounds_;
  const TriangleBlocks& blocks_;
};

}  // namespace sightline
