#pragma once

#include <span>
#include <string>

#include "bench/growth.h"
#include "bench/report.h"

namespace sightline::bench {

/// The whole report; README.md documents the schema.
std::string json_text(const Report& report, std::span<const GrowthLine> growth = {});
/// The part of it about the machine.
std::string json_text(const Machine& machine);

}  // namespace sightline::bench
