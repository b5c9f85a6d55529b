#pragma once
/// The rows of the group of normals, each where its like are.

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// normal_frames.cpp: tangents and bitangents
HardCase normal_degenerate_uv();
HardCase normal_mirrored_uv();
HardCase normal_frame_pole();

// normal_shading.cpp: normals themselves
HardCase normal_nonuniform_scale();
HardCase normal_interpolated_below();

}  // namespace sightline::hard
