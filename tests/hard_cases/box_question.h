#pragma once
/// Boxes asked for in all the ways that the library has: as solids, as primitives, as triangles below every structure,
/// and as volumes that a walk through a structure keeps or skips.

#include <boost/multiprecision/cpp_int.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sightline/math/aabb.h"
#include "sightline/query/tracer.h"
#include "tests/hard_cases/solid_question.h"

namespace sightline::hard {

/// Several boxes whose numbers are floats.
class BoxesByStructure {
 public:
  explicit BoxesByStructure(std::span<const Aabb> boxes);

  const UnionByStructure& solids() const { return solids_; }
  /// Twelve triangles a box, below each structure.
  std::span<const std::unique_ptr<Tracer>> meshes() const { return meshes_; }

 private:
  UnionByStructure solids_;
  std::vector<std::unique_ptr<Tracer>> meshes_;
};

/// Nine copies of a box, `apart` from each other in x and y.
BoxesByStructure boxes_around(const Aabb& box, float apart);

solid::Box solid_of(const Aabb& box);

/// The first hit ahead of triangles whose truth is the question's first end. The ray's numbers are floats.
///   fast        t within 2^-19 of the distance to the farthest part (lib/README.md),
///   watertight  rounded once to float, of a number within 2^-35 of that distance,
///   precise     rays of double, t within 2^-35 of that distance.
/// Triangles have no level `exact`. What is farther than the largest float is no hit for rays of float.
void ask_triangles(Trial& trial, const BoxesByStructure& boxes, const SolidQuestion& question);

/// Both, solids and triangles.
void ask_structures(Trial& trial, const BoxesByStructure& boxes, const Ray<double>& ray);

/// The box as a primitive of BoxSet.
void ask_box_set(Trial& trial, const Aabb& box, const SolidQuestion& question);

/// Where a line is in a closed box, in rationals; touching counts.
struct TrueClip {
  boost::multiprecision::cpp_rational enter, leave;
};
std::optional<TrueClip> true_clip(const Aabb& box, const Ray<double>& ray);

/// Every test by which structures skip volumes: a box that the ray truly meets ahead is kept (M2 of
/// accel/padded_ray.h), and for as long as the ray is in it. Rays that miss ask nothing: keeping too much only takes
/// time.
void ask_volume_tests(Trial& trial, const Aabb& scene, const Aabb& box, const Ray<float>& ray);

/// A rational as the oracle's number.
TrueNumber true_number(const boost::multiprecision::cpp_rational& x);

}  // namespace sightline::hard
