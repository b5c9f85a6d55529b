#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/torus_parts.h"

namespace sightline::hard {

std::vector<HardCase> torus_cases() {
  return {torus_quadruple(), torus_crest(), torus_equator(),      torus_inner(),           torus_villarceau(),
          torus_far(),       torus_thin(),  torus_horn_spindle(), torus_root_elimination()};
}

}  // namespace sightline::hard
