#pragma once
/// Sketches of functions of one variable.

#include <algorithm>
#include <functional>
#include <utility>

#include "tests/hard_cases/sketch.h"

namespace sightline::hard {

/// y = f(x) from lo to hi, where it is within `tall`, over the x axis, which stands for the ray.
inline Sketch& draw_graph(Sketch& sketch, const std::function<double(double)>& f, double lo, double hi, double tall,
                          Role role = Role::shape) {
  sketch.line({lo, 0}, {hi, 0}, Role::ray);
  std::vector<glm::dvec2> curve;
  constexpr int steps = 240;
  for (int i = 0; i <= steps; ++i) {
    const double x = lo + (hi - lo) * i / steps, y = f(x);
    if (y >= -tall && y <= tall) {
      curve.emplace_back(x, y);
    } else if (!curve.empty()) {
      sketch.path(std::exchange(curve, {}), role);
    }
  }
  return curve.empty() ? sketch : sketch.path(std::move(curve), role);
}

}  // namespace sightline::hard
