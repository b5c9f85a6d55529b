#pragma once
/// Solids and rays that meet as badly as they can: numbers of a small lattice, so that faces, edges, tangents and whole
/// subtrees coincide.

#include <functional>
#include <string>

#include "sightline/csg/solid_tree.h"
#include "sightline/math/random.h"
#include "sightline/math/ray.h"

namespace sightline {

/// One of 0 ... n - 1.
using Dice = std::function<int(int n)>;

inline Dice dice_of(Random& random) {
  return [&random](int n) { return static_cast<int>(random.below(static_cast<std::uint32_t>(n))); };
}

/// A box, a sphere or a half-space.
SolidTree lattice_primitive(const Dice& dice);

/// Number of kinds of shapes, and one of each. Meshes are convex.
inline constexpr int shape_kinds = std::variant_size_v<SolidShape>;
SolidTree primitive_of_kind(int kind, const Dice& dice);

/// Any of them, often in a frame.
SolidTree any_primitive(const Dice& dice);

/// Operations within each other, with parts that occur again.
SolidTree random_tree(const Dice& dice, int depth, const std::function<SolidTree(const Dice&)>& primitive);

/// Through lattice points, along axes, diagonals and anything.
Ray<double> lattice_ray(const Dice& dice);

/// To read.
std::string text_of(const SolidTree& tree);
std::string text_of(const Ray<double>& ray);

}  // namespace sightline
