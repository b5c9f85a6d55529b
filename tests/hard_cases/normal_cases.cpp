#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> normal_cases() { return {}; }

}  // namespace sightline::hard
