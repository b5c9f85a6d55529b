#pragma once
/// The rows of the group of noise, each where its like are.

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// noise_near.cpp: at lattice points, next to them and below 0
HardCase noise_lattice();
HardCase noise_negative();
HardCase noise_negative_tiny();
HardCase noise_second_derivative();

// noise_far.cpp: where floats, and integers, end
HardCase noise_two_to_24();
HardCase noise_two_to_31();
HardCase noise_period();

}  // namespace sightline::hard
