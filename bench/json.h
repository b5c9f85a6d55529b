#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/growth.h"
#include "bench/report.h"

namespace sightline::bench {

/// The whole report; README.md documents the schema.
std::string json_text(const Report& report, std::span<const GrowthLine> growth = {});

/// Parts that other reports have as well; of what was not measured null.
nlohmann::ordered_json json_of(const Machine& machine);
nlohmann::ordered_json json_of(const std::optional<Estimate>& value);
/// Seconds of each round, null where one was left out.
nlohmann::ordered_json json_of_rounds(std::span<const double> seconds);

}  // namespace sightline::bench
