#pragma once
/// Interval lists as they should be: every question is answered point by point.

#include <tuple>
#include <vector>

#include "sightline/math/ray.h"

namespace sightline::labs::csg {

// As the student's file has them.
struct Boundary {
  double t = 0;
  std::int32_t surface = 0;
  std::int32_t is_flipped = 0;
};
struct Spans {
  std::int32_t begins_inside = 0;
  std::vector<Boundary> boundaries;
};
inline auto wired(Spans& s) { return std::tie(s.begins_inside, s.boundaries); }
enum class Operation : std::int32_t { unite, intersect, subtract };

bool is_in(Operation operation, bool in_a, bool in_b);
/// Whether t, which is no boundary, is inside.
bool is_in(const Spans& spans, double t);

/// By looking on both sides of each boundary. Of lists with whole t.
Spans true_combination(Operation operation, const Spans& a, const Spans& b);
/// Of whole numbers: compared as fractions, so that a line through an edge is told from one beside it.
Spans true_box_spans(const Ray<double>& ray, const Vec3d& lo, const Vec3d& hi, std::int32_t surface);

}  // namespace sightline::labs::csg
