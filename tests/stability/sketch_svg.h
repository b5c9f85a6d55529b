#pragma once
/// Drawings of hard cases as SVG.

#include <string>
#include <string_view>

#include "tests/hard_cases/sketch.h"

namespace sightline::stability {

/// How a role looks. Roles differ in strokes and marks as well as in color (Okabe and Ito, "Color Universal Design",
/// 2008).
struct RoleLook {
  hard::Role role;
  std::string_view name;   ///< Its class in the SVG, by which a page may give it another color.
  std::string_view title;  ///< In the legend.
  std::string_view color;
  double width;
  std::string_view dashes;  ///< As stroke-dasharray; empty for a whole line.
};
const RoleLook& look_of(hard::Role role);

/// A whole SVG: the parts, the roles that they have, and below, where asked for, the caption. What is not finite is
/// left out. Lines of a ray end in an arrow. Labels stay in the frame and out of each other's way as far as there is
/// room.
std::string svg_of(const hard::Sketch& sketch, bool has_caption = true);

}  // namespace sightline::stability
