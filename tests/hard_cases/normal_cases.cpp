#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/normal_parts.h"

namespace sightline::hard {

std::vector<HardCase> normal_cases() {
  return {normal_degenerate_uv(), normal_mirrored_uv(), normal_nonuniform_scale(), normal_frame_pole(),
          normal_interpolated_below()};
}

}  // namespace sightline::hard
