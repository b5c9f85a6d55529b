#include "tests/hard_cases/box_parts.h"
#include "tests/hard_cases/hard_cases.h"

namespace sightline::hard {

std::vector<HardCase> box_cases() {
  return {box_face_plane(),     box_fma_residual(), box_safe_reciprocal(), box_denormal_direction(),
          box_silhouette(),     box_flat(),         box_corner_touch(),    box_origin_on_face(),
          box_normal_epsilon(), box_far_sentinel(), bounds_round(),        bounds_infinite()};
}

}  // namespace sightline::hard
