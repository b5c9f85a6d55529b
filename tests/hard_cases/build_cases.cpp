#include "tests/hard_cases/build_parts.h"
#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> build_cases() {
  return {build_contraction(), build_round_trip(), build_fast_math(), build_float_to_int()};
}

}  // namespace sightline::hard
