#pragma once
/// Solids asked at every level and through every structure, and held against where rays truly enter and leave.

#include <functional>
#include <vector>

#include "sightline/csg/solid_tree.h"
#include "sightline/math/level.h"
#include "sightline/math/ray.h"
#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

/// A true place where a ray enters or leaves, as comparisons with numbers.
struct TrueEnd {
  std::function<bool(double)> is_nearest;         ///< Whether it rounds to this double.
  std::function<bool(double, double)> is_within;  ///< Whether it is within so much of this number.
  bool is_ahead = false;                          ///< Beyond 0.
};

struct TrueEnds {
  bool begins_inside = false;
  std::vector<TrueEnd> ends;

  /// The first one beyond 0, or null.
  const TrueEnd* first() const;
};

/// By the exact oracle, which knows no tori.
TrueEnds true_spans(const SolidTree& tree, const Ray<double>& ray);

struct AskedRay {
  Ray<double> ray;
  TrueEnds truth;
};

/// What an answer is worth at a level. Documented are, relative to t itself, 2^-46 at watertight, 2^-52 at precise, and
/// the nearest double at exact; of fast that rays leave surfaces by 2^-18 (render/surfaces.cpp).
Verdict verdict_of(const TrueEnd& truth, double t, Level level);

/// Whole lists of one solid, at each level: "solid".
void ask_lists(const SolidTree& tree, const std::vector<AskedRay>& questions, Trial& trial);

/// The first hit, through each structure at each level. The solid has bounds and is not empty.
void ask_structures(const SolidTree& tree, const std::vector<AskedRay>& questions, Trial& trial);

}  // namespace sightline::hard
