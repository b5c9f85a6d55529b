#pragma once

#include "bench/accuracy/axis.h"

namespace sightline::bench {

Axis triangle_axis();
Axis box_axis();
Axis sphere_axis();
Axis quadratic_axis();
Axis torus_axis();
Axis query_axis();
Axis offset_axis();
Axis volume_axis();
Axis build_axis();
Axis noise_axis();
Axis gradient_axis();
Axis matrix_axis();
Axis tessellation_axis();
Axis samples_axis();
Axis adaptive_axis();
Axis cutoff_axis();

}  // namespace sightline::bench
