#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> solver_cases() { return {}; }

}  // namespace sightline::hard
