#pragma once

#include <vector>

#include "viz/walk/walk_state.h"

namespace sightline::viz {

/// Where the node that was opened last by the end of a step is divided: the faces that its children have and it has
/// not, each a convex polygon. None of what is dropped unopened, and of structures that put things into volumes of their own instead of dividing space.
std::vector<std::vector<Vec3d>> split_faces(std::string_view structure, const Walk& walk, std::size_t step);

/// Whether split_faces() knows how this structure divides.
bool has_split_planes(std::string_view structure);

}  // namespace sightline::viz
