#include "tests/hard_cases/csg_parts.h"
#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> csg_cases() {
  return {csg_self(),        csg_two_ways(), csg_pov(),       csg_gap(),           csg_ulp_seam(),
          csg_zero_length(), csg_tangent(),  csg_infinite(),  csg_camera_inside(), csg_edge_share(),
          csg_deep(),        csg_frames(),   csg_pythagoras()};
}

}  // namespace sightline::hard
