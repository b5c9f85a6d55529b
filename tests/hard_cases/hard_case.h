#pragma once
/// Hard cases of numerics: inputs that are exact, a truth that shares no code with the library, and what answers.
///
/// One table (hard_cases.h), one runner (Trial): tests, `./sightline stability` and its pages all read the same.

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "sightline/math/level.h"
#include "tests/hard_cases/sketch.h"
#include "tests/hard_cases/tally.h"

namespace sightline::hard {

/// Where the truth comes from.
enum class Oracle { rationals, sturm_chains, more_digits, closed_form, brute_force, metamorphic };

/// What a run of a case has found.
class Trial {
 public:
  /// Answers of `who` (a structure by its name, or a routine) at `level`; nothing where levels mean nothing to it.
  struct Row {
    std::string who;
    std::optional<Level> level;
    Tally tally;
  };

  /// `share` of the questions of a whole run; at least one of each kind is asked.
  explicit Trial(double share = 1) : share_(share) {}

  /// How many of `whole` random questions to ask.
  std::uint64_t count(std::uint64_t whole) const {
    const auto some = static_cast<std::uint64_t>(share_ * static_cast<double>(whole));
    return some > 0 ? some : 1;
  }

  /// The tally to add to. References stay.
  Tally& of(std::string_view who, std::optional<Level> level = std::nullopt) { return tally_in(rows_, who, level); }
  /// That of code as it is often written, which the case was collected for: it is expected to fail, and shows that the
  /// questions are hard.
  Tally& naive(std::string_view who) { return tally_in(naive_, who, std::nullopt); }

  const std::deque<Row>& rows() const { return rows_; }
  const std::deque<Row>& naive_rows() const { return naive_; }

 private:
  static Tally& tally_in(std::deque<Row>& rows, std::string_view who, std::optional<Level> level) {
    for (Row& row : rows) {
      if (row.who == who && row.level == level) return row.tally;
    }
    return rows.emplace_back(Row{std::string(who), level, {}}).tally;
  }

  double share_;
  std::deque<Row> rows_, naive_;
};

/// A row of the catalogue.
struct HardCase {
  std::string_view id;
  std::string_view group;   ///< As the catalogue's headings, in lower case.
  std::string_view inputs;  ///< As exactly as one line can say.
  std::string_view expected;
  std::string_view why;  ///< Why code fails that does not know better: a sentence or two to learn from.
  Oracle oracle;
  std::string_view reference = {};  ///< Papers and programs where it was met.
  bool is_policy = false;           ///< More than one answer is right: what is asked for is ours, always the same.
  void (*run)(Trial&);
  Sketch (*draw)();
};

}  // namespace sightline::hard
