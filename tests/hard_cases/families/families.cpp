#include "tests/hard_cases/families/families.h"

#include <algorithm>
#include <array>

namespace sightline::hard {

std::span<const Family> families() {
  static const std::array all{mesh_edges(),      mesh_vertices(), near_diagonals(),  slivers(),
                              grazing_spheres(), far_spheres(),   box_silhouettes(), torus_tangents(),
                              csg_gaps(),        offsets(),       quadratics(),      rims_and_apexes(),
                              far_noise(),       matrix_chains(), grid_marching(),   lattice_scenes()};
  return all;
}

const Family* family_named(std::string_view name) {
  const std::span<const Family> all = families();
  const auto found = std::ranges::find(all, name, &Family::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace sightline::hard
