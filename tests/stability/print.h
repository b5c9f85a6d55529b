#pragma once
/// The report on a terminal.

#include <ostream>
#include <span>
#include <string>

#include "tests/stability/report.h"

namespace sightline::stability {

/// A line a case under the headings of their groups, then the sums. With a level only its column.
void print_matrix(std::ostream& out, const Report& report, const std::optional<Level>& level = std::nullopt);

/// A line a case: its id and what is asked.
void print_list(std::ostream& out, std::span<const HardCase* const> cases);

/// All that there is to say of a case. `again` is how to ask it again.
void print_explanation(std::ostream& out, const CaseReport& report, const std::string& again);

}  // namespace sightline::stability
