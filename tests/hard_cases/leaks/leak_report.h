#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tests/hard_cases/leaks/leak_hunt.h"

namespace sightline::hard {

/// A row a structure; below it the first leak of each that has one.
std::string text_table(const LeakReport& report);

nlohmann::json to_json(const LeakReport& report);

}  // namespace sightline::hard
