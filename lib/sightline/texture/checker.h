#pragma once
/// Checkers in the plane and in space, right however far away.
///
///   C1  Cell k reaches from k size to (k + 1) size, its lower end included: a surface on a boundary belongs to the
///   cell
///       above, and -0 is 0. So a floor at y = 0 is one layer, as long as its points say that they are there.
///   C2  A point's cell is the one real arithmetic would find: floor(x / size) by a product whose error is known, and
///       where x / size is no longer exact to a whole number, by a remainder, which never rounds.

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>

#include "sightline/math/ray.h"
#include "sightline/texture/color.h"
#include "sightline/texture/footprint.h"
#include "sightline/texture/texture_options.h"

namespace sightline {

struct CheckerOptions {
  double size = 1;  ///< A cell's edge.
  Color even{0.85f, 0.85f, 0.82f};
  Color odd{0.06f, 0.06f, 0.07f};

  static std::span<const TextureField<CheckerOptions>> fields();
};

/// Points on one axis: x, y or z (0, 1, 2) is `at`.
struct AxisPlane {
  int axis = 1;
  double at = 0;
};

/// A footprint gets the mean over the box around it, in closed form, so that a plane along the axes, whose footprints
/// have no height, stays one layer. Price of C2: one fused product an axis; no supersampling.
/// A coordinate that is not finite counts as an even cell.
class Checker {
 public:
  using Options = CheckerOptions;

  /// \throws std::invalid_argument naming the option that is out of its range.
  explicit Checker(const CheckerOptions& options = {});

  const CheckerOptions& options() const { return options_; }

  bool is_odd(const glm::dvec2& p) const { return cell(p.x).is_odd != cell(p.y).is_odd; }
  bool is_odd(const Vec3d& p) const { return (cell(p.x).is_odd != cell(p.y).is_odd) != cell(p.z).is_odd; }

  /// The cell in space where the ray's line meets the plane, by the ray's numbers as they are: no rounded point stands
  /// between. Price: some 10 ns, and 1 us in the rare case that a filter in double leaves open. The line is finite and
  /// not along the plane.
  template <class T>
  bool is_odd(const AxisPlane& plane, const Ray<T>& ray) const {
    return is_odd_exactly(plane, Vec3d(ray.origin), Vec3d(ray.direction));
  }

  /// The share of odd cells. `extent` is the footprint's, along the axes.
  double value(const glm::dvec2& p, const glm::dvec2& extent) const {
    return 0.5 - 0.5 * (mean(p.x, extent.x) * mean(p.y, extent.y));
  }
  double value(const Vec3d& p, const Footprint& footprint = {}) const {
    const Vec3d& extent = footprint.extent;
    return 0.5 - 0.5 * (mean(p.x, extent.x) * mean(p.y, extent.y) * mean(p.z, extent.z));
  }

  Color operator()(const glm::dvec2& p, const glm::dvec2& extent = glm::dvec2(0)) const {
    return mix(options_.even, options_.odd, value(p, extent));
  }
  Color operator()(const Vec3d& p, const Footprint& footprint = {}) const {
    return mix(options_.even, options_.odd, value(p, footprint));
  }

 private:
  struct Cell {
    bool is_odd;
    double place;  ///< In the cell, in [0, 1].
  };
  Cell cell(double x) const;
  /// Of 1 in even and -1 in odd cells.
  double mean(double x, double extent) const;
  bool is_odd_exactly(const AxisPlane& plane, const Vec3d& origin, const Vec3d& direction) const;

  CheckerOptions options_;
};

}  // namespace sightline
