#pragma once

#include <string>

#include "bench/report.h"

namespace sightline::bench {

/// The whole report; README.md documents the schema.
std::string json_text(const Report& report);

}  // namespace sightline::bench
