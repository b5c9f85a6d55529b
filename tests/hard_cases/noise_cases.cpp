#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/noise_parts.h"

namespace sightline::hard {

std::vector<HardCase> noise_cases() {
  return {noise_lattice(),   noise_negative(), noise_negative_tiny(),    noise_two_to_24(),
          noise_two_to_31(), noise_period(),   noise_second_derivative()};
}

}  // namespace sightline::hard
