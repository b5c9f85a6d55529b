#pragma once
/// The kinds of rays that structures are measured and tested with. All are reproducible: the same arguments give the
/// same rays.

#include <cstdint>
#include <span>
#include <vector>

#include "sightline/math/ray.h"
#include "sightline/shape/mesh.h"

namespace sightline {

/// Between random points of the bounds enlarged by half on every side.
std::vector<Ray<float>> random_rays(const Aabb& bounds, std::size_t count, std::uint64_t seed);

/// From outside the bounds at random points of random edges and, every fourth ray, exactly at a vertex: where leaks
/// show.
std::vector<Ray<float>> edge_rays(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed);

/// For every hit one ray from the surface, on the side that the ray came from, in a cosine-distributed random
/// direction. Misses give no ray. Origins stand off the surface by the rounding error of computing them, so that t_min
/// is 0.
std::vector<Ray<float>> bounce_rays(const TriangleMesh& mesh, std::span<const Ray<float>> rays,
                                    std::span<const Hit<float>> hits, std::uint64_t seed);

/// For every hit one ray from the surface to `light`, which lies at t = 1 (t_max). Hits that face away give no ray.
std::vector<Ray<float>> shadow_rays(const TriangleMesh& mesh, std::span<const Ray<float>> rays,
                                    std::span<const Hit<float>> hits, const Vec3f& light);

}  // namespace sightline
