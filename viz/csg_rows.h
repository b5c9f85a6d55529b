#pragma once

#include "viz/csg_layout.h"
#include "viz/paper.h"

namespace sightline::viz {

/// The tree, a bar for each node's intervals, the transitions with their booleans, and the lines that lead up to them.
void draw_rows(Canvas& canvas, const CsgLayout& layout, const LadderLayout& rows, const Ladder& ladder,
               const LadderSolid& solid);

/// What marks and bars mean, at the foot of the ladder.
void draw_legend(Canvas& canvas, const CsgLayout& layout, const Ladder& ladder);

/// A number as it stands in the picture, which is not the place for all its digits.
std::string short_text(double number);

/// The color of a boundary's material.
Rgb color_of(const LadderSolid& solid, const Boundary& boundary);

/// A part of a ray inside a solid: colored from the surface where it enters to the one where it leaves.
struct BarColors {
  Rgb enter, leave;
};
BarColors bar_colors(const LadderSolid& solid, const Boundary* enter, const Boundary* leave);

}  // namespace sightline::viz
