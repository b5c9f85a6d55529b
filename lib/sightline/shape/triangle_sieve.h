#pragma once
/// Up to eight triangles against one ray at once, in float.
///
/// The test is that of triangle.h: edge functions of the sheared triangle. In float their signs are certain only
/// outside an error bound, so the sieve keeps every triangle that may be crossed, and few others; the exact test
/// decides about those. `cross` takes the signs as float gives them instead, and is what the precision level `fast`
/// uses.
///
/// With u = 2^-24, M the largest sheared coordinate of a triangle, L that along the direction's largest component, and
/// R the largest distance over the axes from the origin to the scene's bounds:
///   E1  A sheared coordinate is off by at most e = 6 u (M + L) + 2 o: two rounded differences, the sheared one at most
///       M + L, a rounded slope, a product, a difference; o is what rounding the origin to float has moved it.
///   E2  An edge function is off, as computed, by at most m (4 e + 4 u m), where m = M + e.
///   E3  Where squares of coordinates might leave the range of float nothing is sifted out; e is at least 2^-60, which
///       covers what underflows.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "sightline/math/aabb.h"
#include "sightline/math/ray.h"
#include "sightline/math/simd.h"
#include "sightline/shape/triangle.h"

namespace sightline {

/// Triangles of one leaf as structure of arrays: nine rows of coordinates (a.x, a.y, a.z, b.x, ... c.z) and one of
/// the bits of their ids, each row as long as there are triangles. Reading a row may run over its end by up to `lanes`
/// floats.
class TriangleBlock {
 public:
  static constexpr std::uint32_t lanes = 8;
  static constexpr std::uint32_t rows = 10;
  static constexpr std::uint32_t id_row = 9;

  TriangleBlock(const float* rows_begin, std::uint32_t count) : rows_(rows_begin), count_(count) {}

  std::uint32_t count() const { return count_; }
  /// A bit for every lane.
  std::uint32_t mask() const { return (1u << count_) - 1; }
  const float* row(std::uint32_t index) const { return rows_ + index * count_; }

  /// A triangle with its coordinates in the order of `axes`.
  Triangle ordered(std::uint32_t lane, const std::array<int, 4>& axes) const {
    const auto at = [&](std::uint32_t axis) { return row(static_cast<std::uint32_t>(axes[axis])) + lane; };
    const float *x = at(0), *y = at(1), *z = at(2);
    const std::size_t next = 3 * std::size_t(count_);
    return {{x[0], y[0], z[0]}, {x[next], y[next], z[next]}, {x[2 * next], y[2 * next], z[2 * next]}};
  }
  Triangle operator[](std::uint32_t lane) const { return ordered(lane, axis_orders[2]); }

  std::uint32_t id(std::uint32_t lane) const { return std::bit_cast<std::uint32_t>(row(id_row)[lane]); }

  /// Writes a triangle into the lane of the block of `count` that begins at `rows_begin`.
  static void store(const Triangle& triangle, std::uint32_t id, float* rows_begin, std::uint32_t count,
                    std::uint32_t lane);

 private:
  const float* rows_;
  std::uint32_t count_;
};

class TriangleSieve {
 public:
  /// `bounds` contain every triangle that will be tested.
  template <class T>
  TriangleSieve(const Ray<T>& ray, const Aabb& bounds);

  /// What the exact test of the same ray can do with: the axis of the direction's largest component, and a bound of R.
  int last_axis() const { return last_axis_; }
  double reach() const { return reach_; }

  /// One bit a lane: set where the line of the ray may cross the triangle, and always set where it does.
  ///   E5  That a triangle is passed by outside takes less to tell than E2, and is true of most. With F = 6.2 u R +
  ///       2.1 o, L is at most R and M at most 2.01 R, so that E2's bound is at most 14 F (1.001 M + F), and its square
  ///       at most 400 F^2 (q + F^2), q being the sum of the squares of the sheared coordinates. 2^-126 covers what
  ///       underflows. Beside the two or three triangles that are met this keeps one of a hundred, and what t is, the
  ///       exact test has to say anyway.
  [[gnu::always_inline]] std::uint32_t may_cross(const TriangleBlock& block) const {
    std::uint32_t bits = 0;
    for (std::uint32_t lane = 0; lane < lanes_of(block); lane += step) {
      const Edges e = edges(block, lane);
      const V apart = hn::Min(hn::Neg(e.lowest()), e.highest());
      const M is_outside = hn::Gt(hn::Mul(apart, hn::Abs(apart)),
                                  hn::MulAdd(hn::Set(d, squares_share_), e.squares(), hn::Set(d, least_square_)));
      bits |= bits_of(d, hn::Not(is_outside)) << lane;
    }
    return bits & block.mask();
  }

  /// What `cross` found, by lanes.
  struct Crossings {
    std::uint32_t hits = 0;    ///< Bits of lanes with t within the range.
    std::uint32_t unsure = 0;  ///< Bits of lanes that float cannot tell t of; other lanes have no crossing.
    alignas(64) float t[TriangleBlock::lanes], u[TriangleBlock::lanes], v[TriangleBlock::lanes];
  };

  /// Crossings with t_min < t <= far, with signs and parameters as float computes them.
  ///   E4  A hit at t lies within 26 u R, on every axis, of the point of the triangle with the weights u and v, which
  ///       margin M1 (padded_ray.h) allows: coordinates are off by e (6 u R), the weighted mean of the vertices strays
  ///       from the line by 12 u M^3 / |sum|, where M is the largest sheared coordinate and sum that of the edge
  ///       functions, t d from the mean by 8 u R. Where M^3 > R |sum|, as in triangles seen edge-on, or where numbers
  ///       leave the middle of the range of float, lanes are unsure.
  [[gnu::always_inline]] void cross(const TriangleBlock& block, float t_min, float far, Crossings& found) const {
    if (!is_ordinary_) [[unlikely]] {
      found.hits = 0;
      found.unsure = may_cross(block);
      return;
    }
    std::uint32_t hits = 0, unsure = 0;
    for (std::uint32_t lane = 0; lane < lanes_of(block); lane += step) {
      const Edges e = edges(block, lane);
      const V zero = hn::Zero(d);
      const M is_inside = hn::Or(hn::Ge(e.lowest(), zero), hn::Le(e.highest(), zero));
      if (hn::AllFalse(d, is_inside)) continue;

      const V sum = e.sum(), size = hn::Abs(sum);
      const V t = hn::Div(hn::Mul(e.height(), hn::Set(d, slopes_[2])), sum);
      hn::StoreU(t, d, found.t + lane);
      hn::StoreU(hn::Div(e.v, sum), d, found.u + lane);
      hn::StoreU(hn::Div(e.w, sum), d, found.v + lane);

      const V m = e.largest();
      const M is_sure =
          hn::And(hn::Gt(size, hn::Set(d, smallest_sum)),
                  hn::Le(hn::Mul(m, hn::Mul(m, m)), hn::Mul(hn::Set(d, static_cast<float>(reach_)), size)));
      const M is_in_range = hn::And(hn::Gt(t, hn::Set(d, t_min)), hn::Le(t, hn::Set(d, far)));
      hits |= bits_of(d, hn::And(is_inside, hn::And(is_sure, is_in_range))) << lane;
      unsure |= bits_of(d, hn::AndNot(is_sure, is_inside)) << lane;
    }
    found.hits = hits & block.mask();
    found.unsure = unsure & block.mask();
  }

 private:
  using D = hn::CappedTag<float, TriangleBlock::lanes>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  static constexpr D d{};
  static constexpr std::uint32_t step = hn::MaxLanes(d);
  static constexpr float unit_roundoff = 0x1p-24f;
  static constexpr float largest = 0x1p+60f;
  static constexpr float smallest_sum = 0x1p-80f;  ///< From here on what underflows in a height does not matter.

  struct Edges {
    V u, v, w;                 ///< Edge functions opposite to a, b and c.
    V az, bz, cz;              ///< Along the direction's largest component, from the origin.
    V ax, ay, bx, by, cx, cy;  ///< Sheared.

    V lowest() const { return hn::Min(u, hn::Min(v, w)); }
    V highest() const { return hn::Max(u, hn::Max(v, w)); }

    V sum() const { return hn::Add(u, hn::Add(v, w)); }
    /// Along the direction's largest component, times the sum of the edge functions.
    V height() const { return hn::MulAdd(u, az, hn::MulAdd(v, bz, hn::Mul(w, cz))); }

    /// q of E5.
    V squares() const {
      const V a = hn::MulAdd(ax, ax, hn::Mul(ay, ay)), b = hn::MulAdd(bx, bx, hn::Mul(by, by));
      return hn::Add(hn::Add(a, b), hn::MulAdd(cx, cx, hn::Mul(cy, cy)));
    }

    /// M of E1.
    V largest() const {
      const auto larger = [](V p, V q) { return hn::Max(hn::Abs(p), hn::Abs(q)); };
      return hn::Max(larger(ax, ay), hn::Max(larger(bx, by), larger(cx, cy)));
    }
  };

  [[gnu::always_inline]] Edges edges(const TriangleBlock& block, std::uint32_t lane) const {
    const V ox = hn::Set(d, origin_[0]), oy = hn::Set(d, origin_[1]), oz = hn::Set(d, origin_[2]);
    const V sx = hn::Set(d, slopes_[0]), sy = hn::Set(d, slopes_[1]);
    const std::array<int, 4>& axes = axis_orders[last_axis_];
    const auto load = [&](std::uint32_t corner, int axis) {
      return hn::LoadU(d, block.row(static_cast<std::uint32_t>(axes[axis])) + 3 * corner * block.count() + lane);
    };
    Edges e;
    e.az = hn::Sub(load(0, 2), oz), e.bz = hn::Sub(load(1, 2), oz), e.cz = hn::Sub(load(2, 2), oz);
    e.ax = hn::NegMulAdd(sx, e.az, hn::Sub(load(0, 0), ox)), e.ay = hn::NegMulAdd(sy, e.az, hn::Sub(load(0, 1), oy));
    e.bx = hn::NegMulAdd(sx, e.bz, hn::Sub(load(1, 0), ox)), e.by = hn::NegMulAdd(sy, e.bz, hn::Sub(load(1, 1), oy));
    e.cx = hn::NegMulAdd(sx, e.cz, hn::Sub(load(2, 0), ox)), e.cy = hn::NegMulAdd(sy, e.cz, hn::Sub(load(2, 1), oy));
    e.u = hn::MulSub(e.cx, e.by, hn::Mul(e.cy, e.bx));
    e.v = hn::MulSub(e.ax, e.cy, hn::Mul(e.ay, e.cx));
    e.w = hn::MulSub(e.bx, e.ay, hn::Mul(e.by, e.ax));
    return e;
  }

  /// How many lanes of the block to go through, `step` at a time.
  static std::uint32_t lanes_of(const TriangleBlock& block) {
    return hn::MaxLanes(d) == TriangleBlock::lanes ? TriangleBlock::lanes : block.count();
  }

  float origin_[4];                     ///< In the order of the axes.
  float slopes_[4];                     ///< Of the first two axes against the last, and 1 / the last of the direction.
  int last_axis_;                       ///< Of the direction's largest component.
  float squares_share_, least_square_;  ///< 400 F^2, and that times F^2 (E5).
  double reach_;                        ///< R.
  bool is_ordinary_;                    ///< Nothing that `cross` computes overflows or underflows.
};

template <class T>
[[gnu::always_inline]] inline TriangleSieve::TriangleSieve(const Ray<T>& ray, const Aabb& bounds) {
  constexpr float smallest = 0x1p-20f;
  const int last = last_axis_ = largest_axis(glm::abs(ray.direction));
  const T along = ray.direction[last];
  const T reach = reach_of(ray.origin, bounds);
  const bool is_in_range = reach <= largest;
  T moved = 0;
  if constexpr (std::is_same_v<T, float> && hn::MaxLanes(hn::CappedTag<T, 4>()) == 4) {
    const hn::CappedTag<T, 4> f;
    const auto order = hn::SetTableIndices(f, axis_orders[last].data());
    const auto in_order = [&](const Vec3<T>& v) { return hn::TableLookupLanes(hn::LoadU(f, &v.x), order); };
    hn::StoreU(hn::IfThenElseZero(hn::FirstN(f, is_in_range ? 3 : 0), in_order(ray.origin)), f, origin_);
    const auto slopes = hn::IfThenElse(hn::FirstN(f, 2), in_order(ray.direction), hn::Set(f, 1));
    hn::StoreU(hn::Div(slopes, hn::Set(f, along)), f, slopes_);
  } else {
    for (int i = 0; i < 3; ++i) {
      const T exact = is_in_range ? ray.origin[axis_orders[last][i]] : 0;
      origin_[i] = static_cast<float>(exact);
      moved = std::max(moved, std::fabs(exact - origin_[i]));
      slopes_[i] = static_cast<float>((i < 2 ? ray.direction[axis_orders[last][i]] : 1) / along);
    }
  }
  reach_ = static_cast<double>(reach) * 0x1.00001p+0;  // above what was rounded
  const float moved_error = is_in_range ? std::max(2.1f * static_cast<float>(moved), 0x1p-60f)
                                        : std::numeric_limits<float>::infinity();  // E3
  const float most_error = moved_error + 6.2f * unit_roundoff * static_cast<float>(reach_);
  squares_share_ = 400 * most_error * most_error;
  least_square_ = std::max(squares_share_ * most_error * most_error, 0x1p-126f);
  const T speed = std::fabs(along);
  const bool is_moderate = (reach >= smallest) & is_in_range & (speed <= largest) & (speed >= 1 / largest);
  is_ordinary_ = (moved == 0) & is_moderate;
}

}  // namespace sightline
