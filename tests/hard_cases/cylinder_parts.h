#pragma once
/// The rows of the group of cylinders, each where its like are.

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// cylinder_caps.cpp: cylinders, and where side and caps meet
HardCase cylinder_parallel();
HardCase cylinder_rim();
HardCase cylinder_cap_plane();
HardCase cylinder_bounds();

// cylinder_cones.cpp: cones
HardCase cone_apex();
HardCase cone_generator();
HardCase cone_nappe();

// cylinder_quadrics.cpp: quadrics
HardCase quadric_threshold();
HardCase quadric_crease();

}  // namespace sightline::hard
