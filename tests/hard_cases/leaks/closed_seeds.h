#pragma once
/// Closed meshes of about unit size around the origin, each with edges and vertices that are hard to hit.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/shape/closed_mesh_seeds.h"

namespace sightline::hard {

struct NamedSeed {
  std::string name;
  MeshSeed mesh;
};

/// An icosahedron whose triangles are quartered so often, pushed out to the sphere.
MeshSeed icosphere(int times);
/// Rings of `around` vertices between two poles. Next to the poles stand needles: their ring is a thousandth wide.
MeshSeed uv_sphere(std::uint32_t around, std::uint32_t rings);
/// Of random points of a sphere, as whole numbers so that no side is in doubt.
MeshSeed random_hull(std::uint32_t points, std::uint64_t seed);
/// A ring whose quads are `around` / `across` times as long as wide, cut along twisted diagonals.
MeshSeed sliver_torus(std::uint32_t around, std::uint32_t across);

/// Whether each edge of a triangle is as often one of others the other way round. Vertices count by their numbers.
bool is_closed(const MeshSeed& mesh);

/// All of them; with the dragon where data/fetch has got it, and Menger's sponge.
std::vector<NamedSeed> closed_seeds(const std::filesystem::path& data_dir);

}  // namespace sightline::hard
