#include "bench/accuracy/axes/axes.h"

#include "bench/accuracy/run.h"

namespace sightline::bench {

const std::vector<Axis>& accuracy_axes() {
  static const std::vector<Axis> axes{triangle_axis(), box_axis(), sphere_axis(), quadratic_axis(), torus_axis()};
  return axes;
}

}  // namespace sightline::bench
