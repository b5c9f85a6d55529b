#pragma once
/// Lab 04: solids by interval lists.

#include "sightline/math/ray.h"

namespace student {

using namespace sightline;

/// A place where a ray crosses the surface of a solid.
struct Boundary {
  double t = 0;
  std::int32_t surface = 0;  ///< Which primitive's surface it is.
  std::int32_t is_flipped =
      0;  ///< 1 where the solid lies outside of that surface, so that its normal is turned around.
};

/// Where a whole line, t from -infinity to infinity, is inside of a solid. At each boundary inside and outside change
/// places, so the list needs no more than where they are.
///   S1  Boundaries are in order, and no two are at the same t.
struct Spans {
  std::int32_t begins_inside = 0;  ///< 1 where the line is inside before the first boundary.
  std::vector<Boundary> boundaries;
};

enum class Operation : std::int32_t { unite, intersect, subtract };

/// Of a ball around `center`. A line that only touches it is never inside.
inline Spans sphere_spans(const Ray<double>& ray, const Vec3d& center, double radius, std::int32_t surface) {
  // lab:hole sphere_spans | 1. A ball
  const Vec3d from_center = ray.origin - center;
  const double a = glm::dot(ray.direction, ray.direction), b = glm::dot(from_center, ray.direction);
  const double c = glm::dot(from_center, from_center) - radius * radius;
  const double discriminant = b * b - a * c;
  if (discriminant <= 0) return {};
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double one = q / a, other = c / q;
  return {0, {{std::min(one, other), surface, 0}, {std::max(one, other), surface, 0}}};
  // lab:end
}

/// Of the box from lo to hi. A line within one of its faces, or through no more than an edge, is never inside.
inline Spans box_spans(const Ray<double>& ray, const Vec3d& lo, const Vec3d& hi, std::int32_t surface) {
  // lab:hole box_spans | 2. A box
  double enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] <= lo[axis] || ray.origin[axis] >= hi[axis]) return {};
      continue;
    }
    const double to_lo = (lo[axis] - ray.origin[axis]) / ray.direction[axis];
    const double to_hi = (hi[axis] - ray.origin[axis]) / ray.direction[axis];
    enter = std::max(enter, std::min(to_lo, to_hi));
    leave = std::min(leave, std::max(to_lo, to_hi));
  }
  if (!(enter < leave)) return {};
  return {0, {{enter, surface, 0}, {leave, surface, 0}}};
  // lab:end
}

/// Whether a point is in the result, told whether it is in a and in b.
inline bool is_inside(Operation operation, bool in_a, bool in_b) {
  // lab:hole is_inside | 3. In or out
  switch (operation) {
    case Operation::unite:
      return in_a || in_b;
    case Operation::intersect:
      return in_a && in_b;
    case Operation::subtract:
      break;
  }
  return in_a && !in_b;
  // lab:end
}

/// What is inside is outside, and the other way round; every surface is seen from its other side.
inline Spans complement(Spans spans) {
  // lab:hole complement | 4. Everything else
  spans.begins_inside = 1 - spans.begins_inside;
  for (Boundary& boundary : spans.boundaries) boundary.is_flipped = 1 - boundary.is_flipped;
  return spans;
  // lab:end
}

/// Both lists in one sweep. Where boundaries of a and b are at the same t, the result changes there once or not at all,
/// and where it changes, the boundary is a's. What is left of b after it was subtracted is flipped.
inline Spans combine(Operation operation, const Spans& a, const Spans& b) {
  // lab:hole combine | 5. One sweep
  bool in_a = a.begins_inside != 0, in_b = b.begins_inside != 0;
  bool is_in = is_inside(operation, in_a, in_b);
  Spans result{is_in ? 1 : 0, {}};
  std::size_t i = 0, k = 0;
  while (i < a.boundaries.size() || k < b.boundaries.size()) {
    const bool has_a = i < a.boundaries.size(), has_b = k < b.boundaries.size();
    const double t = !has_b || (has_a && a.boundaries[i].t < b.boundaries[k].t) ? a.boundaries[i].t : b.boundaries[k].t;
    std::optional<Boundary> boundary;
    // All that happens at t happens at once: only then is it looked at what has become of it.
    if (has_b && b.boundaries[k].t == t) {
      in_b = !in_b;
      boundary = b.boundaries[k++];
      if (operation == Operation::subtract) boundary->is_flipped = 1 - boundary->is_flipped;
    }
    if (has_a && a.boundaries[i].t == t) {
      in_a = !in_a;
      boundary = a.boundaries[i++];
    }
    const bool was_in = is_in;
    is_in = is_inside(operation, in_a, in_b);
    if (is_in != was_in) result.boundaries.push_back(*boundary);
  }
  return result;
  // lab:end
}

/// The first boundary with t_min < t <= t_max: what a camera sees. Nothing where there is none.
inline std::optional<Boundary> first_hit(const Spans& spans, double t_min, double t_max) {
  // lab:hole first_hit | 6. What is seen
  for (const Boundary& boundary : spans.boundaries) {
    if (boundary.t > t_min && boundary.t <= t_max) return boundary;
  }
  return std::nullopt;
  // lab:end
}

// ---- Given: the solid of the picture

/// A die: a cube, rounded off by a ball, with three holes through it and a dent in each face that is seen.
inline Spans die_spans(const Ray<double>& ray) {
  Spans die =
      combine(Operation::intersect, box_spans(ray, Vec3d(-1), Vec3d(1), 0), sphere_spans(ray, Vec3d(0), 1.38, 1));
  die = combine(Operation::subtract, die, box_spans(ray, {-2, -0.35, -0.35}, {2, 0.35, 0.35}, 2));
  die = combine(Operation::subtract, die, box_spans(ray, {-0.35, -2, -0.35}, {0.35, 2, 0.35}, 2));
  die = combine(Operation::subtract, die, box_spans(ray, {-0.35, -0.35, -2}, {0.35, 0.35, 2}, 2));
  const Spans core = sphere_spans(ray, Vec3d(0), 0.55, 3);
  return combine(Operation::unite, die, core);
}

}  // namespace student
