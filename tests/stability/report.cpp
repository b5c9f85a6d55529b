#include "tests/stability/report.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <exception>

namespace sightline::stability {
namespace {

/// Rounding and denormals as they were: what one case turns on for its naive code no other may meet.
class KeptFloatingPoint {
 public:
  KeptFloatingPoint() { std::fegetenv(&environment_); }
  ~KeptFloatingPoint() { std::fesetenv(&environment_); }
  KeptFloatingPoint(const KeptFloatingPoint&) = delete;
  KeptFloatingPoint& operator=(const KeptFloatingPoint&) = delete;

 private:
  std::fenv_t environment_;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

CaseReport ask(const HardCase& hard_case, double share) {
  const KeptFloatingPoint kept;
  const auto start = std::chrono::steady_clock::now();
  CaseReport report{&hard_case, {}, {}, {}, 0};
  hard::Trial trial(share);
  try {
    tbb::this_task_arena::isolate([&] { hard_case.run(trial); });  // while it waits it takes up no other case
    report.answers.assign(trial.rows().begin(), trial.rows().end());
    report.naive.assign(trial.naive_rows().begin(), trial.naive_rows().end());
    if (report.answers.empty()) report.error = "asks nothing";
  } catch (const std::exception& error) {
    report.error = error.what();
  }
  report.seconds = seconds_since(start);
  return report;
}

}  // namespace

Report ask(std::span<const HardCase* const> cases, double share, Progress& progress) {
  Report report{share, std::vector<CaseReport>(cases.size()), 0};
  const auto start = std::chrono::steady_clock::now();
  std::atomic<std::size_t> done = 0;
  const auto tell = [&] {
    const std::size_t count = done;
    progress.say("asking hard cases", std::to_string(count) + " of " + std::to_string(cases.size()),
                 static_cast<double>(count) / static_cast<double>(cases.size()));
  };
  if (!cases.empty()) tell();
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, cases.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          report.cases[i] = ask(*cases[i], share);
          ++done;
          tell();
        }
      },
      tbb::simple_partitioner());
  progress.clear();
  report.seconds = seconds_since(start);
  return report;
}

void limit(Report& report, const Limits& limits) {
  if (!limits.level && limits.structures.empty()) return;
  for (CaseReport& one : report.cases) {
    std::erase_if(one.answers, [&](const Answers& answers) {
      const bool is_level = !limits.level || answers.level == limits.level;
      const auto& names = limits.structures;
      return !is_level || !(names.empty() || std::ranges::find(names, answers.who) != names.end());
    });
  }
  std::erase_if(report.cases, [](const CaseReport& one) { return one.answers.empty() && one.error.empty(); });
}

// ---- The matrix

std::string_view column_name(std::size_t column) {
  return column == always ? std::string_view("always") : level_infos[column].name;
}

std::optional<Cell> cell_of(const CaseReport& report, std::size_t column) {
  std::optional<Cell> cell;
  for (const Answers& answers : report.answers) {
    if (column_of(answers.level) != column) continue;
    if (!cell) cell.emplace();
    cell->verdict = std::max(cell->verdict, answers.tally.verdict());
    cell->wrong += answers.tally.count(Verdict::wrong);
    cell->asked += answers.tally.asked();
  }
  return cell;
}

bool keeps_promises(const CaseReport& report) {
  if (!report.error.empty()) return false;
  return std::ranges::none_of(report.answers, [](const Answers& answers) {
    return is_promised(column_of(answers.level)) && answers.tally.verdict() == Verdict::wrong;
  });
}

bool keeps_promises(const Report& report) {
  return std::ranges::all_of(report.cases, [](const CaseReport& one) { return keeps_promises(one); });
}

std::optional<double> naive_rate(const CaseReport& report) {
  std::optional<double> rate;
  for (const Answers& answers : report.naive) {
    if (answers.tally.asked() == 0) continue;
    const double own =
        static_cast<double>(answers.tally.count(Verdict::wrong)) / static_cast<double>(answers.tally.asked());
    rate = std::max(rate.value_or(0), own);
  }
  return rate;
}

std::vector<const Answers*> dissenters(const CaseReport& report) {
  std::vector<const Answers*> found;
  for (std::size_t column = 0; column < column_count; ++column) {
    std::array<int, 3> votes = {};
    for (const Answers& answers : report.answers) {
      if (column_of(answers.level) == column) ++votes[static_cast<std::size_t>(answers.tally.verdict())];
    }
    const auto most = static_cast<Verdict>(std::ranges::max_element(votes) - votes.begin());
    for (const Answers& answers : report.answers) {
      if (column_of(answers.level) == column && answers.tally.verdict() > most) found.push_back(&answers);
    }
  }
  return found;
}

std::vector<Line> lines_of(std::span<const Answers> answers) {
  std::vector<Line> lines;
  for (const Answers& one : answers) {
    auto line = std::ranges::find(lines, one.who, &Line::who);
    if (line == lines.end()) line = lines.insert(lines.end(), Line{one.who, {}});
    line->at[column_of(one.level)] = &one;
  }
  return lines;
}

std::vector<Question> questions_of(std::span<const Answers> answers) {
  std::vector<Question> questions;
  for (const Answers& one : answers) {
    const bool is_wrong = one.tally.first_wrong().has_value();
    const auto& example = is_wrong ? one.tally.first_wrong() : one.tally.first();
    if (!example) continue;
    auto question = std::ranges::find_if(questions, [&](const Question& each) {
      return each.inputs == example->inputs && each.expected == example->expected;
    });
    if (question == questions.end()) {
      question = questions.insert(questions.end(), Question{example->inputs, example->expected, {}});
    }
    auto& replies = question->replies;
    auto reply = std::ranges::find_if(
        replies, [&](const Question::Reply& each) { return each.got == example->got && each.is_wrong == is_wrong; });
    if (reply == replies.end()) reply = replies.insert(replies.end(), {example->got, is_wrong, {}});
    reply->by.push_back(&one);
  }
  return questions;
}

// ---- Sums

Summary summary_of(const Report& report) {
  Summary summary;
  for (const CaseReport& one : report.cases) {
    ++summary.cases;
    summary.policies += one.hard_case->is_policy;
    summary.failed += !one.error.empty();
    bool is_at_default = !one.error.empty(), is_wrong = is_at_default;
    for (std::size_t column = 0; column < column_count; ++column) {
      const std::optional<Cell> cell = cell_of(one, column);
      if (!cell) {
        ++summary.columns[column].not_applicable;
        continue;
      }
      ++summary.columns[column].cases[static_cast<std::size_t>(cell->verdict)];
      if (column != always && column != column_of(Level::watertight)) continue;
      is_at_default = true;
      is_wrong = is_wrong || cell->verdict == Verdict::wrong;
    }
    summary.at_default += is_at_default;
    if (is_wrong) {
      (one.hard_case->is_policy ? summary.wrong_policies : summary.wrong_at_default).push_back(one.hard_case->id);
    }
  }
  return summary;
}

}  // namespace sightline::stability
