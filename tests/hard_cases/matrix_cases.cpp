#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> matrix_cases() { return {}; }

}  // namespace sightline::hard
