#include "tests/hard_cases/families_report.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace sightline::hard {
namespace {

FamilyLine& line_of(FamilyResult& result, const std::string& name, bool is_naive, bool has_promise) {
  const auto found = std::ranges::find_if(
      result.lines, [&](const FamilyLine& line) { return line.name == name && line.is_naive == is_naive; });
  if (found != result.lines.end()) return *found;
  return result.lines.emplace_back(FamilyLine{name, is_naive, has_promise, {}});
}

void add(FamilyLine& line, std::size_t at, const Tally& tally) {
  line.counts.resize(std::max(line.counts.size(), at + 1));
  FamilyLine::Count& count = line.counts[at];
  count.asked += tally.asked();
  count.wrong += tally.count(Verdict::wrong);
  count.exact += tally.count(Verdict::exact);
}

std::string failure_of(const Trial::Row& row, int k) {
  std::string text = row.who + (row.level ? " at " + std::string(info_of(*row.level).name) : "") +
                     ", k = " + std::to_string(k) + ": " + std::to_string(row.tally.count(Verdict::wrong)) +
                     " wrong of " + std::to_string(row.tally.asked());
  if (const auto& wrong = row.tally.first_wrong()) {
    text += "\n  inputs   " + wrong->inputs + "\n  expected " + wrong->expected + "\n  got      " + wrong->got;
  }
  return text;
}

std::string padded(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string ratio(const FamilyLine::Count& count) {
  if (count.asked == 0) return "-";
  return count.wrong == 0 ? "0" : std::to_string(count.wrong) + "/" + std::to_string(count.asked);
}

}  // namespace

FamilyLine::Count FamilyLine::total() const {
  Count sum;
  for (const Count& count : counts) sum = {sum.asked + count.asked, sum.wrong + count.wrong, sum.exact + count.exact};
  return sum;
}

int FamilyResult::hardest() const {
  return easiest + (lines.empty() ? 0 : static_cast<int>(lines.front().counts.size()) - 1);
}

bool FamilyResult::keeps_promises() const {
  return std::ranges::none_of(lines, [](const FamilyLine& line) { return line.has_promise && line.total().wrong > 0; });
}

FamilyResult begun_result(const Family& family, std::uint64_t count, std::uint64_t seed) {
  return {std::string(family.name),
          std::string(family.help),
          std::string(family.difficulty),
          std::string(family.unit),
          family.easiest,
          count,
          seed,
          {},
          {}};
}

void add_difficulty(FamilyResult& result, int k, const Trial& trial) {
  const auto at = static_cast<std::size_t>(k - result.easiest);
  for (const LevelInfo& info : level_infos) {
    for (const Trial::Row& row : trial.rows()) {
      if (row.level == info.level)
        add(line_of(result, std::string(info.name), false, info.level != Level::fast), at, row.tally);
    }
  }
  for (const Trial::Row& row : trial.rows()) {
    if (!row.level) add(line_of(result, "always", false, true), at, row.tally);
    if (row.level != Level::fast && row.tally.count(Verdict::wrong) > 0) result.failures.push_back(failure_of(row, k));
  }
  for (const Trial::Row& row : trial.naive_rows()) add(line_of(result, row.who, true, false), at, row.tally);
}

FamilyResult run_family(const Family& family, std::uint64_t count, std::uint64_t seed) {
  return run_family(family, count, seed, [](double) {});
}

std::string text_table(const FamilyResult& result) {
  std::string text = result.name + "\n  " + result.help + "\n  " + result.unit + ": " + result.difficulty +
                     "\n  wrong of asked; 0: none\n\n" + padded("k", 4);
  std::vector<std::size_t> widths;
  for (const FamilyLine& line : result.lines) {
    widths.push_back(std::max<std::size_t>(line.name.size(), 11) + 2);
    text += padded(line.name, widths.back());
  }
  for (int k = result.easiest; k <= result.hardest(); ++k) {
    text += "\n" + padded(std::to_string(k), 4);
    for (std::size_t i = 0; i < result.lines.size(); ++i) {
      const auto& counts = result.lines[i].counts;
      const auto at = static_cast<std::size_t>(k - result.easiest);
      text += padded(at < counts.size() ? ratio(counts[at]) : "-", widths[i]);
    }
  }
  text += "\n" + padded("all", 4);
  for (std::size_t i = 0; i < result.lines.size(); ++i) text += padded(ratio(result.lines[i].total()), widths[i]);
  text += "\n";
  for (const std::string& failure : result.failures) text += "\n" + failure + "\n";
  return text;
}

nlohmann::json to_json(const FamilyResult& result) {
  nlohmann::json lines = nlohmann::json::array();
  for (const FamilyLine& line : result.lines) {
    nlohmann::json counts = nlohmann::json::array();
    for (std::size_t i = 0; i < line.counts.size(); ++i) {
      counts.push_back({{"k", result.easiest + static_cast<int>(i)},
                        {"asked", line.counts[i].asked},
                        {"wrong", line.counts[i].wrong},
                        {"exact", line.counts[i].exact}});
    }
    lines.push_back({{"name", line.name}, {"naive", line.is_naive}, {"counts", std::move(counts)}});
  }
  return {{"name", result.name},       {"help", result.help},        {"difficulty", result.difficulty},
          {"unit", result.unit},       {"questions", result.count},  {"seed", result.seed},
          {"lines", std::move(lines)}, {"failures", result.failures}};
}

}  // namespace sightline::hard
