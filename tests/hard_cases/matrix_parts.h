#pragma once
/// The rows of the group of matrices, each where its like are.

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// matrix_chains.cpp: long products, and the way back
HardCase matrix_chain();
HardCase matrix_pop_inverse();
HardCase matrix_far_translate();

// matrix_signs.cpp: small determinants and negative ones
HardCase matrix_determinant_test();
HardCase matrix_reflect();

// matrix_turns.cpp: frames, turns and bent rays at the edge of what they are defined for
HardCase matrix_look_at();
HardCase slerp_antipodal();
HardCase refract_critical();

}  // namespace sightline::hard
