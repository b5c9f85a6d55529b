#pragma once

#include <memory>
#include <optional>
#include <span>

#include "sightline/shape/torus.h"

namespace sightline::bench {

/// Finds where lines meet a torus.
class TorusSolver {
 public:
  virtual ~TorusSolver() = default;
  /// Distinct roots; of the closed form without radii.
  virtual RootList solve(const Torus& torus, const Ray<double>& ray) const = 0;
  /// What is timed: one ray after another, their roots counted.
  virtual std::size_t count_all(const Torus& torus, std::span<const Ray<double>> rays) const = 0;
};

/// Of a level, or Ferrari's.
std::unique_ptr<TorusSolver> make_torus_solver(std::optional<Level> level);

}  // namespace sightline::bench
