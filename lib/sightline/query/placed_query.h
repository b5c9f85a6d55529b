#pragma once
/// A query of instances, as it comes to one instance after the other.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "sightline/query/instance_ray.h"
#include "sightline/query/leaves.h"
#include "sightline/query/queries.h"

namespace sightline {

/// The nearest crossing of a ray with an instance; a miss when prim_id is no_primitive. u and v are weights of the
/// placed triangle's second and third vertex (I2 of shape/instances.h).
template <class T>
struct InstanceHit {
  T t = std::numeric_limits<T>::infinity();
  std::uint32_t instance = no_primitive;
  std::uint32_t prim_id = no_primitive;  ///< Of the instance's mesh.
  T u = 0;
  T v = 0;

  bool is_hit() const { return prim_id != no_primitive; }
  friend bool operator==(const InstanceHit&, const InstanceHit&) = default;
};

/// The order of the flattened mesh: nearer first, then the lower instance, then its lower triangle.
template <class T>
bool is_closer(const InstanceHit<T>& a, const InstanceHit<T>& b) {
  if (a.t != b.t) return a.t < b.t;
  return a.instance != b.instance ? a.instance < b.instance : a.prim_id < b.prim_id;
}

/// Triangles of a block where a placement puts them, as Placement::triangle does.
class PlacedBlock {
 public:
  PlacedBlock(const TriangleBlock& local, const Placement& placement) : count_(local.count()) {
    constexpr std::uint32_t lanes = TriangleBlock::lanes;
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const float *x = local.row(3 * corner), *y = x + count_, *z = y + count_;
      const std::uint32_t to = placement.is_mirroring() && corner > 0 ? 3 - corner : corner;
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const auto& r = placement.row(axis);
        const double a = r[0], b = r[1], c = r[2], d = r[3];
        std::array<float, lanes> placed;
        for (std::uint32_t i = 0; i < lanes; ++i) placed[i] = static_cast<float>(a * x[i] + b * y[i] + c * z[i] + d);
        std::copy_n(placed.begin(), count_, rows_.begin() + (3 * to + axis) * count_);
      }
    }
    std::copy_n(local.row(TriangleBlock::id_row), count_, rows_.begin() + TriangleBlock::id_row * count_);
  }

  TriangleBlock block() const { return {rows_.data(), count_}; }

 private:
  std::uint32_t count_;
  std::array<float, (TriangleBlock::rows + 1) * TriangleBlock::lanes> rows_;  ///< One row may be read past its end.
};

/// What a ray looks for among instances, and has found so far. One visitor serves both kinds of queries: that for any
/// hit ends at the first.
template <class T>
class PlacedQuery {
 public:
  /// Refers to both.
  PlacedQuery(const Ray<T>& ray, const Instances& instances, bool takes_any)
      : ray_(ray), instances_(instances), prepared_(ray, instances.bounds()), takes_any_(takes_any) {}

  const InstanceHit<T>& best() const { return best_; }
  /// Whether nothing that is found could change the answer.
  bool is_done() const { return takes_any_ && best_.is_hit(); }
  T far() const { return std::min(best_.t, ray_.t_max); }

  /// Walks through the structure over an instance's mesh. `blocks` may be null: then triangles are taken from the mesh.
  template <Level level, class Accel, class Probe>
  void visit(std::uint32_t instance, const Accel& accel, const TriangleMesh& mesh, const TriangleBlocks* blocks,
             Probe& probe) {
    const Placement& placement = instances_.placements()[instance];
    // E4 of triangle_sieve.h, in units of 2^-24 of reach.
    const double error = level == Level::fast ? 26 * 0x1p-24 * reach_of(Vec3d(ray_.origin), instances_.bounds()) : 0;
    const InstanceRay<T> local(ray_, placement, mesh.bounds(), error);
    auto see = [&](std::uint32_t id, const Crossing& crossing) {
      const T t = detail::parameter<T>(crossing);
      if (t <= best_.t && detail::is_in_range(ray_, t)) {
        const InstanceHit<T> hit{t, instance, id, static_cast<T>(crossing.u), static_cast<T>(crossing.v)};
        if (is_closer(hit, best_)) best_ = hit;
      }
      return !is_done();
    };
    const auto test = [&](std::uint32_t id) {
      Crossing crossing;
      return !prepared_.exact().intersect(placement.triangle(mesh[id]), crossing) || see(id, crossing);
    };
    if (!local.is_clear()) {
      for (std::uint32_t id = 0; id < mesh.size() && test(id); ++id) continue;
      return;
    }
    accel.traverse(
        local.ray(),
        [&](LeafRange leaf) {
          if (blocks) {
            while (leaf.count > 0) {
              const PlacedBlock placed((*blocks)[TriangleBlocks::next_block(leaf)], placement);
              if (!detail::cross_block<level>(prepared_, placed.block(), far(), see)) break;
            }
          } else {
            for (const std::uint32_t id : accel.leaf_order().subspan(leaf.first, leaf.count)) {
              if (!test(id)) break;
            }
          }
          return is_done() ? -std::numeric_limits<T>::infinity() : local.far_limit(far());
        },
        probe);
  }

 private:
  const Ray<T>& ray_;
  const Instances& instances_;
  PreparedTriangles<T> prepared_;
  InstanceHit<T> best_{};
  bool takes_any_;
};

}  // namespace sightline
