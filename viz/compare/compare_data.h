#pragma once
/// A comparison's figures for other programs.

#include <nlohmann/json.hpp>
#include <string>

#include "viz/compare/compare_look.h"
#include "viz/compare/findings.h"

namespace sightline::viz {

/// All figures of the ray and of the pixels; `findings` has both. Times are in none.
nlohmann::ordered_json comparison_json(std::span<const Compared> compared, const CompareFindings& findings,
                                       const CompareLook& look, const CompareSource& source);

/// The histograms: a line a bin, of every structure and kind of work.
std::string histogram_csv(std::span<const Compared> compared, const CompareFindings& findings);

/// The walks' figures, a line a structure, for people.
std::string comparison_table(std::span<const Compared> compared, const CompareFindings& findings);

}  // namespace sightline::viz
