#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> build_cases() { return {}; }

}  // namespace sightline::hard
