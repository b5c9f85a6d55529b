#pragma once

#include <memory>

#include "bench/contender.h"

namespace sightline::bench {

/// The locators of VTK that a line can be asked of, as they come. They know no any-hit query, so that both workloads
/// ask for the nearest; a ray without end is cut off behind the mesh. Too slow to be asked all rays.
enum class VtkLocator { static_cell, cell, cell_tree, bsp, obb };
std::unique_ptr<Contender> make_vtk(VtkLocator locator);

}  // namespace sightline::bench
