#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/offset_parts.h"

namespace sightline::hard {

std::vector<HardCase> offset_cases() {
  return {offset_none(), offset_fixed(), offset_leak(), offset_absorbed(), offset_shadow_end()};
}

}  // namespace sightline::hard
