#pragma once
/// The rows of the group of spheres, each where its like are.

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// sphere_size.cpp: near and far, large and small
HardCase sphere_far();
HardCase sphere_planet();
HardCase sphere_direction_underflow();
HardCase sphere_scale();
HardCase sphere_absolute_epsilon();

// sphere_graze.cpp: hit or missed
HardCase sphere_graze();
HardCase sphere_tangent();
HardCase sphere_interval_reject();
HardCase sphere_zero_radius();

// sphere_surface.cpp: on the surface and next to it
HardCase sphere_near_root();
HardCase sphere_on_surface();

// sphere_uv.cpp: places and frames
HardCase sphere_uv_seam();
HardCase sphere_pole();
HardCase unit_dot_acos();

}  // namespace sightline::hard
