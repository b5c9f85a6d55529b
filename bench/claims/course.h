#pragma once
/// The claims, each defined in the file of its name.

#include "bench/claims/claim.h"

namespace sightline::bench {

extern const Claim bsp_cost_claim, kd_build_claim, kd_search_claim, lazy_bih_claim, bounding_spheres_claim,
    unordered_hierarchies_claim, grid_cells_claim, matrices_claim, csg_claim, noise_claim;

}  // namespace sightline::bench
