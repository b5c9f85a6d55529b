#pragma once

#include <nlohmann/json.hpp>

#include "viz/web/web_model.h"

namespace sightline::viz {

/// Walks with more steps leave out candidates that the ray does not cross; their number stands with the step after.
inline constexpr std::size_t web_steps = 20'000;

/// What the page's script reads. Arrays of numbers are little-endian bytes in base64, of the type that stands in the
/// name: "t_f32", "cell_u32". Cells are `kind_u8` (box, sphere, cylinder, polyhedron), `depth_u16`, `leaf_u8`,
/// `count_u32` (candidates), `node_u32` and, one after the other, their `shape_f32`:
///   box         lo, hi
///   sphere      center, radius
///   cylinder    center, axis of unit length, radius, half of its length
///   polyhedron  vertices, faces, the vertices' places, of each face its number of corners and these
/// Steps have `flags_u8`: 1 for a candidate that is crossed, 2 for one that becomes the nearest hit, 4 where an empty
/// part of the cell is passed. Walks have cells and, of each, the steps at which it was put aside (`since_u32`) and
/// taken up (`until_u32`); equal where it never was.
nlohmann::json web_data(const WebModel& model);

}  // namespace sightline::viz
