#pragma once
/// What solids truly are, from their definitions alone: an oracle that shares no code with the library but the classes
/// that name the shapes. Closed primitives, regularised results: a line that lies in a face is in the primitive, points
/// alone and gaps of no length do not count.

#include <array>
#include <vector>

#include "sightline/csg/solid_tree.h"
#include "sightline/math/ray.h"
#include "tests/csg/evaluate.h"
#include "tests/csg/exact_root.h"

namespace sightline::oracle {

struct ExactSpans {
  bool begins_inside = false;
  std::vector<Root> ends;
};

/// Along the whole line. Meshes count as the common part of what is behind their triangles, so they have to be convex;
/// tori are not known here.
ExactSpans exact_spans(const SolidTree& tree, const Ray<double>& ray);

using Point = std::array<Binary, 3>;

inline Point point_at(const Ray<double>& ray, const Binary& t) {
  Point p;
  for (int i = 0; i < 3; ++i) p[static_cast<std::size_t>(i)] = Binary(ray.origin[i]) + t * Binary(ray.direction[i]);
  return p;
}

/// Whether the point is in the solid: closed primitives, complements without their boundary. Knows tori.
bool contains(const SolidTree& tree, const Point& point);

/// What is wrong with a list of a level, or "": at exact each end has to be the nearest double, at watertight within
/// 2^-46 and at precise within 2^-52 of itself, and at both within its own bound.
std::string fault_of(const Spans& spans, const ExactSpans& truth, Level level);

}  // namespace sightline::oracle
