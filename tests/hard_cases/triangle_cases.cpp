#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/triangle_parts.h"

namespace sightline::hard {

std::vector<HardCase> triangle_cases() {
  return {triangle_edge(),      triangle_vertex(),        triangle_embree_far(), triangle_absolute_epsilon(),
          triangle_underflow(), triangle_pbrt_bad_case(), triangle_sliver(),     triangle_coplanar(),
          triangle_parity(),    triangle_t_junction(),    triangle_fan_pole(),   triangle_origin_on()};
}

}  // namespace sightline::hard
