#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/solver_parts.h"

namespace sightline::hard {

std::vector<HardCase> solver_cases() {
  return {quadratic_cancel(),         quadratic_kahan(),     quadratic_overflow(),
          quadratic_linear_limit(),   quartic_quadruple(),   quartic_double_sign(),
          quartic_near_biquadratic(), quartic_mixed_scale(), quartic_diagrams(),
          quartic_celeritas(),        quartic_rpoly()};
}

}  // namespace sightline::hard
