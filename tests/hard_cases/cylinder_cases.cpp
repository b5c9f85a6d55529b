#include "tests/hard_cases/cylinder_parts.h"
#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> cylinder_cases() {
  return {cylinder_parallel(), cylinder_rim(), cylinder_cap_plane(), cylinder_bounds(), cone_apex(),
          cone_generator(),    cone_nappe(),   quadric_threshold(),  quadric_crease()};
}

}  // namespace sightline::hard
