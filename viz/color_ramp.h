#pragma once

#include <array>

namespace sightline::viz {

/// A color as screens take it, each component from 0 to 1.
using Rgb = std::array<double, 3>;

/// Even to the eye from 0 (dark violet) over blue and green to 1 (yellow, or amber where it is not to be light):
/// lightness rises in step with `share` while the hue turns, so that the order reads in gray and to the color-blind as
/// well. `share` is held within [0, 1].
Rgb ramp(double share, double darkest = 0.30, double lightest = 0.76);

/// From -1 (blue) over 0 (near white) to 1 (orange), as light at -x as at x; of NaN gray. `x` is held within [-1, 1].
Rgb diverging(double x);

/// What light a screen's component stands for, and back; both within [0, 1].
double linear_from_srgb(double component);
double srgb_from_linear(double light);

/// "#rrggbb".
std::array<char, 8> css_color(const Rgb& color);

}  // namespace sightline::viz
