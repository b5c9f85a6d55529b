#pragma once
/// The rows of the group of solvers, by degree.

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// solver_quadratics.cpp
HardCase quadratic_cancel();
HardCase quadratic_kahan();
HardCase quadratic_overflow();
HardCase quadratic_linear_limit();

// solver_quartics.cpp: roots that fall together, or almost
HardCase quartic_quadruple();
HardCase quartic_double_sign();
HardCase quartic_near_biquadratic();

// solver_reports.cpp: quartics from reports on other programs
HardCase quartic_mixed_scale();
HardCase quartic_diagrams();
HardCase quartic_celeritas();
HardCase quartic_rpoly();

}  // namespace sightline::hard
