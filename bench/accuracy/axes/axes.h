#pragma once

#include "bench/accuracy/axis.h"

namespace sightline::bench {

Axis triangle_axis();
Axis box_axis();
Axis sphere_axis();
Axis quadratic_axis();
Axis torus_axis();

}  // namespace sightline::bench
