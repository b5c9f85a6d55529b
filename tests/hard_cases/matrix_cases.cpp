#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/matrix_parts.h"

namespace sightline::hard {

std::vector<HardCase> matrix_cases() {
  return {matrix_chain(),         matrix_pop_inverse(), matrix_determinant_test(), matrix_look_at(),
          matrix_far_translate(), matrix_reflect(),     slerp_antipodal(),         refract_critical()};
}

}  // namespace sightline::hard
