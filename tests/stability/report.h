#pragma once
/// What was found of hard cases, before it is shown in one way or another.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/io/progress.h"
#include "tests/hard_cases/hard_case.h"

namespace sightline::stability {

using hard::HardCase, hard::Verdict;
using Answers = hard::Trial::Row;

struct CaseReport {
  const HardCase* hard_case = nullptr;
  std::vector<Answers> answers;
  std::vector<Answers> naive;
  std::string error;  ///< Of a case that could not be asked to its end. Then what it found counts for nothing.
  double seconds = 0;
};

struct Report {
  double share = 1;
  std::vector<CaseReport> cases;
  double seconds = 0;
};

/// Asks `share` of all questions, several cases at once.
Report ask(std::span<const HardCase* const> cases, double share, Progress& progress);

/// Which answers are of interest; what is left open is not limited.
struct Limits {
  std::optional<Level> level;
  std::vector<std::string> structures;
};
/// Leaves out other answers, and cases that have none of these.
void limit(Report& report, const Limits& limits);

// ---- The matrix: a line a case, a column a level, and the last one for what has none

inline constexpr std::size_t column_count = level_infos.size() + 1;
inline constexpr std::size_t always = level_infos.size();

constexpr std::size_t column_of(const std::optional<Level>& level) {
  return level ? static_cast<std::size_t>(*level) : always;
}
std::string_view column_name(std::size_t column);
/// Whether `wrong` must not stand there: `fast` alone promises nothing of hard cases.
constexpr bool is_promised(std::size_t column) { return column != static_cast<std::size_t>(Level::fast); }

/// All answers of a case in a column: the worst verdict, and how many are wrong.
struct Cell {
  Verdict verdict = Verdict::exact;
  std::uint64_t wrong = 0, asked = 0;
};
/// Nothing where the column does not apply.
std::optional<Cell> cell_of(const CaseReport& report, std::size_t column);
bool keeps_promises(const CaseReport& report);
bool keeps_promises(const Report& report);

/// The largest share of wrong answers that naive code gave; nothing where there is no such code.
std::optional<double> naive_rate(const CaseReport& report);

/// Those whose verdict is worse than that of most in their column; of as many, the better verdict is that of most.
std::vector<const Answers*> dissenters(const CaseReport& report);

/// The answers of one structure or routine, by columns; null where it was not asked.
struct Line {
  std::string_view who;
  std::array<const Answers*, column_count> at = {};
};
std::vector<Line> lines_of(std::span<const Answers> answers);

/// One question that was kept as an example, and what was answered by whom.
struct Question {
  struct Reply {
    std::string got;
    bool is_wrong = false;
    std::vector<const Answers*> by;
  };
  std::string inputs, expected;
  std::vector<Reply> replies;
};
/// The example of each, the first wrong one where there is one; the same questions and replies stand once.
std::vector<Question> questions_of(std::span<const Answers> answers);

// ---- Sums

struct Summary {
  struct Column {
    std::array<std::size_t, 3> cases = {};  ///< By verdict.
    std::size_t not_applicable = 0;
  };
  std::array<Column, column_count> columns;
  std::size_t cases = 0, policies = 0, failed = 0;
  std::size_t at_default = 0;  ///< Cases, with policies, whose default is told of: at watertight, or without levels.
  std::vector<std::string_view> wrong_at_default;  ///< Outside policies.
  std::vector<std::string_view> wrong_policies;    ///< Likewise, of policies.
};
Summary summary_of(const Report& report);

}  // namespace sightline::stability
