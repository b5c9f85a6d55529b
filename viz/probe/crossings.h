#pragma once
/// Where the line of a ray meets each kind of shape that can be asked about. Each reads the shape, and adds the members
/// of the answer.

#include <nlohmann/json.hpp>

#include "sightline/io/json_value.h"
#include "sightline/math/level.h"
#include "sightline/math/ray.h"

namespace sightline::probe {

/// {c, r}: "roots", "multiplicity", "t_first".
void answer_sphere(const JsonValue&, const Ray<double>&, Level, nlohmann::ordered_json& answer);

/// {R, r}, around c where that is given, and the z axis: the same.
void answer_torus(const JsonValue&, const Ray<double>&, Level, nlohmann::ordered_json& answer);

/// {lo, hi}: "hit", "enter", "exit" of the line, "t_first".
void answer_box(const JsonValue&, const Ray<double>&, Level, nlohmann::ordered_json& answer);

/// {v, f}, closed or not: "t", "tris" of the ray, "t_first".
void answer_mesh(const JsonValue&, const Ray<double>&, Level, nlohmann::ordered_json& answer);

/// A node (scene/solid_file.h): "intervals" of the line, "t_first".
void answer_tree(const JsonValue&, const Ray<double>&, Level, nlohmann::ordered_json& answer);

}  // namespace sightline::probe
