#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/sphere_parts.h"

namespace sightline::hard {

std::vector<HardCase> sphere_cases() {
  return {sphere_far(),
          sphere_graze(),
          sphere_tangent(),
          sphere_planet(),
          sphere_near_root(),
          sphere_on_surface(),
          sphere_direction_underflow(),
          sphere_scale(),
          sphere_absolute_epsilon(),
          sphere_interval_reject(),
          sphere_uv_seam(),
          sphere_pole(),
          sphere_zero_radius(),
          unit_dot_acos()};
}

}  // namespace sightline::hard
