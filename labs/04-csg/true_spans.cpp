#include "labs/04-csg/true_spans.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace sightline::labs::csg {
namespace {

/// A fraction of small whole numbers, its denominator positive.
struct Fraction {
  std::int64_t above = 0, below = 1;

  friend bool operator<(const Fraction& a, const Fraction& b) { return a.above * b.below < b.above * a.below; }
  double value() const { return static_cast<double>(above) / static_cast<double>(below); }
};

Fraction fraction(double above, double below) {
  const double sign = below < 0 ? -1 : 1;
  return {static_cast<std::int64_t>(sign * above), static_cast<std::int64_t>(sign * below)};
}

const Boundary* boundary_at(const Spans& spans, double t) {
  const auto found = std::ranges::find(spans.boundaries, t, &Boundary::t);
  return found == spans.boundaries.end() ? nullptr : &*found;
}

}  // namespace

bool is_in(Operation operation, bool in_a, bool in_b) {
  constexpr bool table[3][2][2] = {
      {{false, true}, {true, true}}, {{false, false}, {false, true}}, {{false, false}, {true, false}}};
  return table[static_cast<int>(operation)][in_a][in_b];
}

bool is_in(const Spans& spans, double t) {
  const auto before = std::ranges::count_if(spans.boundaries, [t](const Boundary& b) { return b.t < t; });
  return (spans.begins_inside != 0) == (before % 2 == 0);
}

Spans true_combination(Operation operation, const Spans& a, const Spans& b) {
  const auto at = [&](double t) { return is_in(operation, is_in(a, t), is_in(b, t)); };
  std::set<double> places;
  for (const Spans* spans : {&a, &b}) {
    for (const Boundary& boundary : spans->boundaries) places.insert(boundary.t);
  }
  Spans result{at(places.empty() ? 0 : *places.begin() - 0.5) ? 1 : 0, {}};
  for (const double t : places) {
    if (at(t - 0.5) == at(t + 0.5)) continue;
    const Boundary* of_a = boundary_at(a, t);
    Boundary boundary = of_a != nullptr ? *of_a : *boundary_at(b, t);
    if (of_a == nullptr && operation == Operation::subtract) boundary.is_flipped = 1 - boundary.is_flipped;
    result.boundaries.push_back(boundary);
  }
  return result;
}

Spans true_box_spans(const Ray<double>& ray, const Vec3d& lo, const Vec3d& hi, std::int32_t surface) {
  Fraction enter{-1'000'000, 1}, leave{1'000'000, 1};
  for (int axis = 0; axis < 3; ++axis) {
    const double from = ray.origin[axis], step = ray.direction[axis];
    if (step == 0) {
      if (from <= lo[axis] || from >= hi[axis]) return {};
      continue;
    }
    const Fraction to_lo = fraction(lo[axis] - from, step), to_hi = fraction(hi[axis] - from, step);
    enter = std::max(enter, std::min(to_lo, to_hi));
    leave = std::min(leave, std::max(to_lo, to_hi));
  }
  if (!(enter < leave)) return {};
  return {0, {{enter.value(), surface, 0}, {leave.value(), surface, 0}}};
}

}  // namespace sightline::labs::csg
