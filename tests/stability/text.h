#pragma once
/// What people read: words and numbers, the same on the terminal and on the page.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/stability/report.h"

namespace sightline::stability {

/// "exact", "bound" or "WRONG".
std::string_view verdict_text(Verdict verdict);
/// "exact", "WRONG 12/20000", or "–" where it does not apply.
std::string cell_text(const std::optional<Cell>& cell);
/// "8.4%" of 0.084: two digits, and neither 0% nor 100% of what is not.
std::string percent_text(double rate);
/// "–" where there is no naive code.
std::string naive_text(const CaseReport& report);
/// What the columns do not say: that it is a policy, that it failed, who is worse than the rest of the line.
std::string remarks_text(const CaseReport& report);
/// "1.2e-16", "0", "inf".
std::string error_text(double error);
/// "exact", "bound 1.9e-16", "WRONG 12/20000": of one structure or routine, with the worst relative error.
std::string answers_text(const Answers& answers);
/// "kd-tree, grid at fast, exact; normal at fast".
std::string who_text(std::span<const Answers* const> by);
std::string_view oracle_text(hard::Oracle oracle);
/// Whether the default is wrong anywhere, in a sentence or two.
std::string default_text(const Summary& summary);
/// "12 cases", "1 case".
std::string plural(std::size_t count, std::string_view word);
std::string joined(const std::vector<std::string_view>& words, std::string_view between = ", ");

/// Code points, which are columns of a terminal as far as these texts go.
std::size_t width_of(std::string_view text);
/// Lines of at most `width` columns, broken at blanks; a longer word has a line of its own.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);
/// As it stands in HTML and SVG: markup escaped, and control characters, which XML forbids, as "?".
std::string escaped(std::string_view text);

}  // namespace sightline::stability
