#pragma once
/// The table of all families.

#include <span>
#include <string_view>

#include "tests/hard_cases/families/family.h"

namespace sightline::hard {

// Each in its file.
Family mesh_edges();
Family mesh_vertices();
Family near_diagonals();
Family slivers();
Family grazing_spheres();
Family far_spheres();
Family box_silhouettes();
Family torus_tangents();
Family csg_gaps();
Family offsets();
Family quadratics();
Family rims_and_apexes();
Family far_noise();
Family matrix_chains();
Family grid_marching();
Family lattice_scenes();

std::span<const Family> families();

/// Null where there is none of that name.
const Family* family_named(std::string_view name);

}  // namespace sightline::hard
