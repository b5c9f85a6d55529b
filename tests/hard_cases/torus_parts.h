#pragma once
/// The rows of the group of tori, each where its like are.

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// torus_touch.cpp: lines that touch
HardCase torus_quadruple();
HardCase torus_crest();
HardCase torus_equator();
HardCase torus_inner();
HardCase torus_villarceau();

// torus_size.cpp: far, thin, near, and of all shapes
HardCase torus_far();
HardCase torus_thin();
HardCase torus_horn_spindle();
HardCase torus_root_elimination();

}  // namespace sightline::hard
