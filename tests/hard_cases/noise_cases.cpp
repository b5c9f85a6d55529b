#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> noise_cases() { return {}; }

}  // namespace sightline::hard
