#pragma once
/// Vectors in fifty digits, and what unit vectors and frames are held against.

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>

#include "tests/hard_cases/hard_case.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {

using Wide = boost::multiprecision::cpp_bin_float_50;
using WideVec = std::array<Wide, 3>;

inline WideVec wide(const Vec3d& v) { return {Wide(v.x), Wide(v.y), Wide(v.z)}; }
inline Wide dot(const WideVec& a, const WideVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline WideVec cross(const WideVec& a, const WideVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline WideVec sum(const Wide& x, const WideVec& a, const Wide& y, const WideVec& b) {
  return {x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]};
}
inline WideVec unit(const WideVec& v) {
  const Wide length = sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// Of unit length and at right angles, with products off by no more than 2^-50: those of components with a few
/// roundings each (tests/texture/tangent_frame_test.cpp has it so).
inline constexpr double frame_bound = 0x1p-50;

/// Holds a unit vector against a true one: within the bound where no component is off by more than `bound`.
inline void judge_unit(Tally& tally, const Vec3d& got, const WideVec& truth, const std::string& inputs,
                       double bound = frame_bound) {
  bool is_nearest = true;
  Wide off = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Wide& x = truth[static_cast<std::size_t>(axis)];
    is_nearest = is_nearest && got[axis] == x.convert_to<double>();
    off = std::isfinite(got[axis]) ? std::max<Wide>(off, abs(Wide(got[axis]) - x)) : Wide(1e300);
  }
  const Verdict verdict = is_nearest ? Verdict::exact : off <= bound ? Verdict::within_bound : Verdict::wrong;
  tally.add(verdict, off.convert_to<double>(), [&] {
    const Vec3d nearest(truth[0].convert_to<double>(), truth[1].convert_to<double>(), truth[2].convert_to<double>());
    return Example{inputs, vector_text(nearest), vector_text(got)};
  });
}

/// Whether three vectors, of any lengths, are at right angles, and of length 1 where `has_unit_length`.
inline void judge_frame(Tally& tally, const std::array<Vec3d, 3>& axes, const std::string& inputs,
                        bool has_unit_length = true, double bound = frame_bound) {
  bool is_sound = true;
  for (const Vec3d& axis : axes) is_sound = is_sound && is_finite(axis) && axis != Vec3d(0);
  Wide off = is_sound ? 0 : 1;
  for (std::size_t i = 0; is_sound && i < 3; ++i) {
    for (std::size_t k = has_unit_length ? i : i + 1; k < 3; ++k) {
      WideVec a = wide(axes[i]), b = wide(axes[k]);
      if (!has_unit_length) a = unit(a), b = unit(b);
      off = std::max<Wide>(off, abs(dot(a, b) - (i == k ? 1 : 0)));
    }
  }
  const Verdict verdict = off == 0 ? Verdict::exact : off <= bound ? Verdict::within_bound : Verdict::wrong;
  tally.add(verdict, off.convert_to<double>(), [&] {
    return Example{inputs, "three vectors at right angles",
                   vector_text(axes[0]) + ", " + vector_text(axes[1]) + ", " + vector_text(axes[2])};
  });
}

}  // namespace sightline::hard
