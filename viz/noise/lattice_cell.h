#pragma once
/// How noise of the plane comes about in one cell of its lattice.

#include <array>
#include <glm/vec2.hpp>
#include <string_view>

#include "sightline/noise/noise.h"

namespace sightline::viz {

/// A corner of the cell, as the point asked for sees it.
struct CellCorner {
  std::string_view name;  ///< LL, LR, UL, UR: lower or upper, left or right.
  glm::dvec2 position;
  glm::dvec2 gradient;  ///< Zero for value noise.
  glm::dvec2 way;       ///< From the corner to the point.
  double contribution;  ///< The gradient times the way, or the corner's value.
  double weight;        ///< What the eases make of it. The weights add up to 1.
};

struct LatticeCell {
  std::array<CellCorner, 4> corners;  ///< In the order of their names above.
  double s, t;                        ///< Eased way along x and y.
  double lower, upper;                ///< Between left and right, along x.
  double value;                       ///< Between lower and upper: the noise.
};

/// Of any kind but `white`.
LatticeCell lattice_cell(const Noise& noise, const glm::dvec2& point);

/// The gradient at a lattice point: there noise is 0 and climbs as its own gradient says, since the ease is flat.
glm::dvec2 lattice_gradient(const Noise& noise, const glm::dvec2& lattice_point);

/// What the noise goes by, whatever its options say.
Ease ease_of(const Noise& noise);
double eased(Ease ease, double t);
double slope_of_eased(Ease ease, double t);
double curvature_of_eased(Ease ease, double t);

}  // namespace sightline::viz
