#pragma once
/// The rows of the group of what compilers do, each where its like are.

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// build_triangles.cpp: contraction
HardCase build_contraction();

// build_arithmetic.cpp: roundings, tiny numbers, NaN, and conversions
HardCase build_round_trip();
HardCase build_fast_math();
HardCase build_float_to_int();

}  // namespace sightline::hard
