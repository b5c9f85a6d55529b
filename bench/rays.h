#pragma once

#include <array>
#include <functional>
#include <vector>

#include "bench/plan.h"
#include "sightline/math/ray.h"
#include "sightline/shape/mesh.h"

namespace sightline::bench {

/// The rays of every workload, by Workload; none for build.
using RaySets = std::array<std::vector<Ray<float>>, workload_count>;

using ClosestHits = std::function<void(std::span<const Ray<float>>, std::span<Hit<float>>)>;

/// About `count` rays of each kind, always the same for the same mesh and count.
///   primary  one a pixel of a 4:3 picture of the whole scene, row by row
///   bounce   from what the primary rays hit, in as many directions per pixel as make up the count
///   shadow   from there to points of a square lamp above the scene, likewise
/// Bounce and shadow rays are missing where the primary rays hit nothing.
RaySets make_rays(const TriangleMesh& mesh, std::size_t count, const ClosestHits& closest_hits);

/// `count` of the indices below `size`, evenly at random, in order; all when there are fewer.
std::vector<std::size_t> pick(std::size_t size, std::size_t count);

}  // namespace sightline::bench
