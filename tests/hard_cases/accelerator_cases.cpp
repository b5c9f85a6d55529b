#include "tests/hard_cases/accelerator_parts.h"
#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> accelerator_cases() {
  return {kd_planar(),      kd_outside_cell(),     kd_zero_direction(), kd_split_at_origin(),  bih_overlap(),
          bih_clip_round(), grid_insert(),         grid_outside_cell(), grid_drift(),          grid_index_n(),
          grid_flat(),      build_same_centroid(), bsp_on_plane(),      bounding_sphere_far(), nan_inf_ray()};
}

}  // namespace sightline::hard
