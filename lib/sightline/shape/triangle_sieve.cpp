#include "sightline/shape/triangle_sieve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sightline {

void TriangleBlock::store(const Triangle& triangle, float* rows_begin, std::uint32_t count, std::uint32_t lane) {
  float* at = rows_begin + lane;
  const auto write = [&](float value) { *std::exchange(at, at + count) = value; };
  for (const Vec3f* corner : {&triangle.a, &triangle.b, &triangle.c}) {
    for (int axis = 0; axis < 3; ++axis) write((*corner)[axis]);
  }
  const Aabb box = bounds_of(triangle);
  const float extent = std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
  write(extent * 0x1.00001p+1f);  // above twice the extent, whose difference was rounded
}

TriangleSieve::TriangleSieve(const Ray<double>& ray, const Aabb& bounds) {
  const Vec3d size = glm::abs(ray.direction);
  axes_[2] = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  axes_[0] = (axes_[2] + 1) % 3;
  axes_[1] = (axes_[0] + 1) % 3;
  const double along = ray.direction[axes_[2]];
  shear_x_ = static_cast<float>(ray.direction[axes_[0]] / along);
  shear_y_ = static_cast<float>(ray.direction[axes_[1]] / along);
  scale_z_ = static_cast<float>(1 / along);

  constexpr double largest = 0x1p+60, smallest = 0x1p-20;
  const double reach =
      max_norm(glm::max(glm::abs(Vec3d(bounds.lo) - ray.origin), glm::abs(Vec3d(bounds.hi) - ray.origin)));
  double moved = 0;
  for (int i = 0; i < 3; ++i) {
    const double exact = reach <= largest ? ray.origin[axes_[i]] : 0;
    origin_[i] = static_cast<float>(exact);
    moved = std::max(moved, std::fabs(exact - origin_[i]));
  }
  error_ = reach <= largest ? static_cast<float>(std::max(6.1 * unit_roundoff * reach + 2.1 * moved, 0x1p-60))
                            : std::numeric_limits<float>::infinity();  // E4
  reach_ = static_cast<float>(std::min(reach, largest));
  is_ordinary_ = moved == 0 && reach >= smallest && reach <= largest && std::fabs(along) <= largest &&
                 std::fabs(along) >= 1 / largest;
}

void TriangleSieve::cross(const TriangleBlock& block, float t_min, float far, Crossings& found) const {
  if (!is_ordinary_) {
    found.hits = 0;
    found.unsure = may_cross(block);
    return;
  }
  found.unsure = 0;
  found.hits = gather_bits(block, [&](std::uint32_t lane) {
    const Edges e = edges(block, lane);
    const V zero = hn::Zero(d);
    const V lowest = hn::Min(e.u, hn::Min(e.v, e.w)), highest = hn::Max(e.u, hn::Max(e.v, e.w));
    const M is_inside = hn::Or(hn::Ge(lowest, zero), hn::Le(highest, zero));
    if (hn::AllFalse(d, is_inside)) return is_inside;

    const V sum = hn::Add(e.u, hn::Add(e.v, e.w)), size = hn::Abs(sum);
    const V height = hn::MulAdd(e.u, e.az, hn::MulAdd(e.v, e.bz, hn::Mul(e.w, e.cz)));
    const V t = hn::Div(hn::Mul(height, hn::Set(d, scale_z_)), sum);
    hn::StoreU(t, d, found.t + lane);
    hn::StoreU(hn::Div(e.v, sum), d, found.u + lane);
    hn::StoreU(hn::Div(e.w, sum), d, found.v + lane);

    const auto larger = [](V p, V q) { return hn::Max(hn::Abs(p), hn::Abs(q)); };
    const V m = hn::Max(larger(e.ax, e.ay), hn::Max(larger(e.bx, e.by), larger(e.cx, e.cy)));
    const M is_sure = hn::And(hn::Gt(size, hn::Set(d, 0x1p-80f)),
                              hn::Le(hn::Mul(m, hn::Mul(m, m)), hn::Mul(hn::Set(d, reach_), size)));
    found.unsure |= bits_of(hn::AndNot(is_sure, is_inside)) << lane;
    const M is_in_range = hn::And(hn::Gt(t, hn::Set(d, t_min)), hn::Le(t, hn::Set(d, far)));
    return hn::And(is_inside, hn::And(is_sure, is_in_range));
  });
  found.unsure &= (1u << block.count()) - 1;
}

}  // namespace sightline
