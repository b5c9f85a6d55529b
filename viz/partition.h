#pragma once
/// Which of a structure's cells a picture shows.

#include <cstddef>
#include <optional>
#include <vector>

#include "sightline/query/tracer.h"

namespace sightline::viz {

/// A plane at right angles to an axis, at a share (0 to 1) of the scene's extent along it.
struct Slice {
  int axis = 0;
  double share = 0.5;

  double position(const Aabb& bounds) const;
};

struct CellFilter {
  int shallowest = 0;
  /// Where not given, as deep as keeps a picture of nested cells readable (readable_cells), or, with leaves_only or a
  /// slice, down to the deepest.
  std::optional<int> deepest;
  bool leaves_only = false;
  std::optional<Slice> slice;    ///< Only cells that the plane cuts.
  std::size_t max_cells = 4000;  ///< Of those that pass, the largest by volume.

  /// Nested cells that a picture shows at once, by the shape of the root.
  static std::size_t readable_cells(const Cell& root);
};

/// The cells to show, shallow ones first, and what there is besides.
struct Partition {
  std::vector<Cell> cells;
  std::size_t passing = 0;  ///< Cells that passed the filter, of which `cells` are the largest.
  std::size_t total = 0;
  int shallowest = 0;  ///< Of `cells`.
  int deepest = 0;
  int total_deepest = 0;
};

Partition select_cells(const Tracer& tracer, const CellFilter& filter);

/// Bounds of a region along one axis.
struct Extent {
  double lo, hi;
};
Extent extent_along(const Cell& cell, int axis);

double volume_of(const Cell& cell);

}  // namespace sightline::viz
