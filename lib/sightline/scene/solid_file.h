#pragma once
/// Solids as JSON.
///
/// A node is an operation or a primitive:
///   {"op": "union|inter|diff|xor|compl", "args": [node, ...]}       one argument of compl, at least one of the others
///   {"prim": "box", "lo": [3], "hi": [3]}          {"prim": "sphere", "c": [3], "r": radius}
///   {"prim": "half", "n": [3], "w": offset}        the points x with n . x <= w
///   {"prim": "cylinder", "p": [3], "q": [3], "r": radius}            with caps at p and q
///   {"prim": "cone", "p": [3], "q": [3], "r": radius}                from its apex p to its base around q
///   {"prim": "torus", "R": major, "r": minor}      around "c": [3] and the axis "a": [3]; normally 0 and z
///   {"prim": "quadric", "q": [10]}                 coefficients of x^2 y^2 z^2 xy xz yz x y z 1: where the sum is <= 0
///   {"prim": "mesh", "v": [[3], ...], "f": [[3], ...]}               a closed one, counter-clockwise from outside
/// Any node may have a "material", a name for what it is made of, and a "frame" (see solid_frame.h), within which its
/// arguments stand. Other members are ignored.

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "sightline/csg/solid_tree.h"
#include "sightline/io/json_value.h"

namespace sightline {

/// \throws FileError naming the place in the document, what is expected and what was found; of shapes that make no
/// sense, such as meshes that are not closed, std::invalid_argument that does.
SolidTree solid_of(const JsonValue&);

/// The same of a file that holds one.
SolidTree read_solid(const std::filesystem::path&);

struct TriangleList {
  std::vector<Vec3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Of {"v": [[3], ...], "f": [[3], ...]}, closed or not; each index is one of a vertex.
TriangleList triangles_of(const JsonValue&);

}  // namespace sightline
