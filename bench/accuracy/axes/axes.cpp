#include "bench/accuracy/axes/axes.h"

#include "bench/accuracy/run.h"

namespace sightline::bench {

const std::vector<Axis>& accuracy_axes() {
  static const std::vector<Axis> axes{triangle_axis(),     box_axis(),     sphere_axis(),   quadratic_axis(),
                                      torus_axis(),        query_axis(),   offset_axis(),   volume_axis(),
                                      build_axis(),        noise_axis(),   gradient_axis(), matrix_axis(),
                                      tessellation_axis(), samples_axis(), adaptive_axis(), cutoff_axis()};
  return axes;
}

}  // namespace sightline::bench
