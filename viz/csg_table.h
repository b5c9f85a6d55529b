#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "viz/csg_ladder.h"

namespace sightline::viz {

/// The shortest text that is read back as the same number; "inf" and "-inf" for infinities.
std::string exact_text(double number);

/// The ladder in lines for people and for simple programs: the intervals of each node, the transitions of each
/// operation, the hit. Numbers are as exact_text writes them. `name` is the solid's.
std::string ladder_table(const Ladder& ladder, const LadderSolid& solid, const std::string& name);

/// The same as JSON; infinities are the strings "inf" and "-inf".
nlohmann::ordered_json ladder_json(const Ladder& ladder, const LadderSolid& solid, const std::string& name);

}  // namespace sightline::viz
