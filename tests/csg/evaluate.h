#pragma once
/// Solids evaluated at a level that is chosen at run time, compiled once for all tests.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "sightline/csg/solid.h"
#include "sightline/math/level.h"

namespace sightline {

inline constexpr std::array<Level, 4> all_levels{Level::fast, Level::watertight, Level::precise, Level::exact};
/// Those that promise the right lists.
inline constexpr std::array<Level, 3> sure_levels{Level::watertight, Level::precise, Level::exact};

/// A list that outlives its evaluator.
struct Spans {
  bool begins_inside = false;
  std::vector<Boundary> boundaries;
};

Spans spans_of(const Solid& solid, const Ray<double>& ray, Level level);

/// The first boundary in (t_min, t_max].
std::optional<Boundary> first_of(const Solid& solid, const Ray<double>& ray, double t_min, double t_max, Level level);

/// Of the registry.
std::vector<std::string_view> accelerator_names();

}  // namespace sightline
