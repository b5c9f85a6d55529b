#include "sightline/shape/triangle_sieve.h"

namespace sightline {

void TriangleBlock::store(const Triangle& triangle, std::uint32_t id, float* rows_begin, std::uint32_t count,
                          std::uint32_t lane) {
  float* at = rows_begin + lane;
  const auto write = [&](float value) { *std::exchange(at, at + count) = value; };
  for (const Vec3f* corner : {&triangle.a, &triangle.b, &triangle.c}) {
    for (int axis = 0; axis < 3; ++axis) write((*corner)[axis]);
  }
  write(std::bit_cast<float>(id));
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

    const V m = e.largest();
    const M is_sure = hn::And(hn::Gt(size, hn::Set(d, 0x1p-80f)),
                              hn::Le(hn::Mul(m, hn::Mul(m, m)), hn::Mul(hn::Set(d, reach_), size)));
    found.unsure |= bits_of(d, hn::AndNot(is_sure, is_inside)) << lane;
    const M is_in_range = hn::And(hn::Gt(t, hn::Set(d, t_min)), hn::Le(t, hn::Set(d, far)));
    return hn::And(is_inside, hn::And(is_sure, is_in_range));
  });
  found.unsure &= (1u << block.count()) - 1;
}

}  // namespace sightline
