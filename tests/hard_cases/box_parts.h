#pragma once
/// The rows of the group of boxes, each where its like are.

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// box_planes.cpp: rays in planes of faces, and directions without a reciprocal
HardCase box_face_plane();
HardCase box_fma_residual();
HardCase box_safe_reciprocal();
HardCase box_denormal_direction();

// box_edges.cpp
HardCase box_silhouette();
HardCase box_corner_touch();

// box_faces.cpp
HardCase box_flat();
HardCase box_origin_on_face();
HardCase box_normal_epsilon();

// box_bounds.cpp: boxes around things
HardCase box_far_sentinel();
HardCase bounds_round();
HardCase bounds_infinite();

}  // namespace sightline::hard
