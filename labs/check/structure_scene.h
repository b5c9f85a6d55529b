#pragma once
/// The scene and the rays that work is counted on: the same for everyone.

#include <vector>

#include "sightline/math/ray.h"
#include "sightline/shape/triangle.h"

namespace sightline::labs {

/// Some thousand triangles of very different sizes: small ones crowd about a few places, between large ones.
std::vector<Triangle> budget_triangles();
/// Through the scene, from all sides.
std::vector<Ray<float>> budget_rays();

}  // namespace sightline::labs
