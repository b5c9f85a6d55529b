#pragma once
/// Transforms and colors, as scene files say them.

#include <functional>
#include <string>

#include "sightline/io/json_value.h"
#include "sightline/math/transform.h"
#include "sightline/texture/color.h"

namespace sightline {

/// Of an array of steps, each of one member:
///   {"translate": [x, y, z]}                        {"scale": size or [x, y, z]}
///   {"rotate": {"axis": [x, y, z], "degrees": angle}}                counter-clockwise as seen from the axis' tip
///   {"matrix": [12 or 16 numbers]}                  by rows, of which a fourth is 0 0 0 1
///   {"look_at": {"eye": [3], "target": [3], "up": [3]}}              to the eye, -z toward the target, y upward
/// The product of the steps from left to right: the last one is done first, within all that stand before it, as
/// MatrixStack does them.
/// \throws FileError for a step that is singular, and where the product is; `node` tells the node's path.
Transform transform_of(const JsonValue&, const std::function<std::string()>& node);

/// [red, green, blue], linear and at least 0, or "#rrggbb", encoded as sRGB.
Color color_of(const JsonValue&);

}  // namespace sightline
