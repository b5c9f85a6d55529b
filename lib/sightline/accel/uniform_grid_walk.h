#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "sightline/accel/padded_ray.h"
#include "sightline/accel/uniform_grid_cells.h"

namespace sightline {

/// A ray against the planes of a grid, all in the precision T, u its unit roundoff.
///   W1  Plane i of the top level is crossed at i * per_layer + at_origin, up to a distance of 8 u reach along the
///       axis, and ray(t) is t * speed + start layers from the first plane, up to as much: each is a few roundings of
///       numbers that stand for distances up to reach, which no size of the scene or of the direction changes.
///   W2  Dividing layers by a power of two, and numbering planes to match, changes no bit of a crossing parameter.
template <class T>
struct GridRay {
  Vec3<T> per_layer, at_origin, speed, start;
  bool is_ordinary = true;  ///< Nothing overflows or underflows.

  GridRay(const Ray<T>& ray, const GridParts& grid) {
    constexpr T largest = T(0x1p+60), smallest = T(0x1p-60);
    for (int axis = 0; axis < 3; ++axis) {
      const T from_origin = ray.origin[axis] - grid.origin[axis], inverse_size = grid.inverse_size[axis];
      start[axis] = from_origin * inverse_size;
      speed[axis] = ray.direction[axis] * inverse_size;
      const T inverse = T(1) / ray.direction[axis];
      per_layer[axis] = grid.size[axis] * inverse;
      at_origin[axis] = -from_origin * inverse;
      if (ray.direction[axis] == 0) {
        per_layer[axis] = 0;
        at_origin[axis] = std::numeric_limits<T>::infinity();
      } else {
        const T crossing = std::fabs(per_layer[axis]);
        is_ordinary &= crossing >= smallest && crossing <= largest && std::fabs(at_origin[axis]) <= largest;
      }
    }
  }
};

/// Walks from plane to plane, and within the block of a divided cell likewise.
///   W3  Parameters grow with plane numbers, whatever is rounded, so for every t of the ray within the grid there is a
///       visited cell into whose layers the ray has come, and which it has not left, by those parameters; by W1 ray(t)
///       is within 9 u reach of that cell. The first cell of a level is found from the position, as near to the ray.
///   W4  What is reported at t has a point within 32 u reach of ray(t) (M1), hence within 41 u reach of a visited cell,
///       which holds the primitive by G2 as pad is at least 64 u reach. The grid extends beyond the primitives by pad,
///       so that point is met before the walk leaves the grid.
template <class T, class Visit, class Probe>
class GridWalk {
 public:
  GridWalk(const GridParts& grid, const GridRay<T>& ray, Visit& visit, Probe& probe)
      : grid_(grid), ray_(ray), visit_(visit), probe_(probe) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_negative = ray.per_layer[axis] < 0;
      step_[axis] = is_negative ? -1 : 1;
      ahead_[axis] = is_negative ? 0 : 1;
    }
  }

  void walk(T t_min, T t_max) {
    // Nothing is reported at infinity, so that an infinite entry always ends the walk.
    far_ = std::min(t_max, std::numeric_limits<T>::max());
    T t = t_min, t_exit = std::numeric_limits<T>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const int count = grid_.resolution[axis];
      if (ray_.per_layer[axis] == 0) {
        if (ray_.start[axis] < 0 || ray_.start[axis] > static_cast<T>(count)) return;
      } else {
        const T one = ray_.at_origin[axis], other = static_cast<T>(count) * ray_.per_layer[axis] + one;
        t = std::max(t, std::min(one, other));
        t_exit = std::min(t_exit, std::max(one, other));
      }
    }
    if (!(t <= t_exit && t <= far_)) return;
    const std::array<int, 3> strides{1, grid_.resolution[0], grid_.resolution[0] * grid_.resolution[1]};
    cross({0, 0, 0}, grid_.resolution, Vec3<T>(1), strides, t, t_exit,
          [&](int index, const Vec3<T>& place, T t_in, T t_out) {
            const auto number = static_cast<std::uint32_t>(index);
            return examine(number, grid_.cells[number], place, Vec3<T>(1), t_in, t_out);
          });
  }

 private:
  /// Visits cells of one size, in the order in which the ray enters them, from t until it leaves at t_exit. False when
  /// the whole walk is over. The planes below the first cells have the numbers `first`.
  template <class Examine>
  bool cross(const Vec3<T>& first, const std::array<int, 3>& counts, const Vec3<T>& finer,
             const std::array<int, 3>& strides, T t, T t_exit, Examine&& examine) {
    Vec3<T> place, next, per_layer;
    int index = 0;
    std::array<int, 3> moves;
    for (int axis = 0; axis < 3; ++axis) {
      const T position = (t * ray_.speed[axis] + ray_.start[axis]) * finer[axis] - first[axis];
      const int layer = clamp_to_index(position, counts[axis]);
      index += layer * strides[axis];
      moves[axis] = ray_.per_layer[axis] < 0 ? -strides[axis] : strides[axis];
      place[axis] = first[axis] + static_cast<T>(layer);
      per_layer[axis] = ray_.per_layer[axis] / finer[axis];
      next[axis] = (place[axis] + ahead_[axis]) * per_layer[axis] + ray_.at_origin[axis];
    }
    for (;;) {
      const T nearest = std::min(next.x, std::min(next.y, next.z));
      if (!examine(index, place, t, nearest)) return false;
      t = nearest;
      if (!(t < t_exit)) return true;
      if (t > far_) return false;
      if (next.x == t) {
        advance(0, place, next, per_layer), index += moves[0];
      } else if (next.y == t) {
        advance(1, place, next, per_layer), index += moves[1];
      } else {
        advance(2, place, next, per_layer), index += moves[2];
      }
    }
  }

  void advance(int axis, Vec3<T>& place, Vec3<T>& next, const Vec3<T>& per_layer) const {
    place[axis] += step_[axis];
    next[axis] = (place[axis] + ahead_[axis]) * per_layer[axis] + ray_.at_origin[axis];
  }

  bool examine(std::uint32_t number, GridCell cell, const Vec3<T>& place, const Vec3<T>& finer, T t, T t_exit) {
    if (cell.is_leaf()) {
      probe_.leaf(number, cell.range(), t);
      far_ = std::min<T>(visit_(cell.range()), far_);
      return !(t > far_);
    }
    probe_.node(number, t);
    return cell.is_empty() || walk_block(number, grid_.blocks[cell.block()], place, finer, t, t_exit);
  }

  bool walk_block(std::uint32_t number, const GridBlock& block, const Vec3<T>& place, const Vec3<T>& coarser, T t,
                  T t_exit) {
    std::array<int, 3> counts;
    Vec3<T> first, finer;
    for (int axis = 0; axis < 3; ++axis) {
      counts[axis] = 1 << block.shifts[axis];
      first[axis] = place[axis] * static_cast<T>(counts[axis]);
      finer[axis] = coarser[axis] * static_cast<T>(counts[axis]);
    }
    return cross(first, counts, finer, {1, GridBlock::side, GridBlock::side * GridBlock::side}, t, t_exit,
                 [&](int bit, const Vec3<T>& at, T t_in, T t_out) {
                   if (!block.has(bit)) {
                     probe_.node(number, t_in);
                     return true;
                   }
                   const std::uint32_t child = block.cell_at(bit);
                   return examine(child, grid_.cells[child], at, finer, t_in, t_out);
                 });
  }

  const GridParts& grid_;
  const GridRay<T>& ray_;
  Visit& visit_;
  Probe& probe_;
  T far_ = 0;
  Vec3<T> step_, ahead_;  ///< From a layer to the next one, and to the plane between them.
};

/// Halves the grid down to cells, nearer halves first: for rays from so far away that their margin exceeds what the
/// cells allow for, and those whose parameters leave the range of T.
template <class T, class Visit, class Probe>
class GridDescent {
 public:
  GridDescent(const GridParts& grid, const PaddedRay<T>& ray, Visit& visit, Probe& probe)
      : grid_(grid), ray_(ray), visit_(visit), probe_(probe) {}

  void descend() {
    far_ = std::min(ray_.t_max, std::numeric_limits<T>::max());
    halve(grid_.top(), static_cast<std::uint32_t>(grid_.cells.size()), nullptr);
  }

 private:
  /// Cells of the region, which belong to the block, or to the top level where there is none. False when the whole
  /// walk is over.
  bool halve(const GridRegion& region, std::uint32_t number, const GridBlock* block) {
    const Interval<T> inside = ray_.clip(grid_.box(region), far_);
    if (inside.is_empty()) return true;
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (region.last[axis] - region.first[axis] > region.last[longest] - region.first[longest]) longest = axis;
    }
    if (region.first[longest] == region.last[longest]) return examine(region, number, block, inside.lo);
    const int middle = region.first[longest] + (region.last[longest] - region.first[longest]) / 2;
    GridRegion halves[2] = {region, region};
    halves[0].last[longest] = middle;
    halves[1].first[longest] = middle + 1;
    const bool is_negative = ray_.is_negative[longest];
    return halve(halves[is_negative], number, block) && halve(halves[!is_negative], number, block);
  }

  bool examine(const GridRegion& region, std::uint32_t number, const GridBlock* block, T t) {
    const std::array<int, 3>& place = region.first;
    if (block == nullptr) {
      number = grid_.top_cell(place);
    } else {
      const int bit = block->bit_of(place);
      if (!block->has(bit)) {
        probe_.node(number, t);
        return true;
      }
      number = block->cell_at(bit);
    }
    const GridCell cell = grid_.cells[number];
    if (cell.is_leaf()) {
      probe_.leaf(number, cell.range(), t);
      far_ = std::min<T>(visit_(cell.range()), far_);
      return far_ > -std::numeric_limits<T>::infinity();  // a cell beside this one may be entered earlier
    }
    probe_.node(number, t);
    if (cell.is_empty()) return true;
    const GridBlock& inner = grid_.blocks[cell.block()];
    return halve(region.inside(place, inner), number, &inner);
  }

  const GridParts& grid_;
  const PaddedRay<T>& ray_;
  Visit& visit_;
  Probe& probe_;
  T far_ = 0;
};

}  // namespace sightline
