#include "tests/stability/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace sightline::stability {
namespace {

std::string digits(double value, const char* format) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

}  // namespace

std::string_view verdict_text(Verdict verdict) {
  constexpr std::array<std::string_view, 3> texts{"exact", "bound", "WRONG"};
  return texts[static_cast<std::size_t>(verdict)];
}

std::string cell_text(const std::optional<Cell>& cell) {
  if (!cell) return "–";
  std::string text(verdict_text(cell->verdict));
  if (cell->verdict == Verdict::wrong) text += ' ' + std::to_string(cell->wrong) + '/' + std::to_string(cell->asked);
  return text;
}

std::string percent_text(double rate) {
  const double percent = 100 * rate;
  if (percent == 0 || percent == 100) return digits(percent, "%.0f%%");
  if (percent < 10) return digits(percent, "%.2g%%");
  return digits(std::min(percent, 99.0), "%.0f%%");
}

std::string naive_text(const CaseReport& report) {
  const std::optional<double> rate = naive_rate(report);
  return rate ? percent_text(*rate) : "–";
}

std::string remarks_text(const CaseReport& report) {
  std::string text = report.hard_case->is_policy ? "policy" : "";
  const auto add = [&](const std::string& remark) { text += (text.empty() ? "" : "; ") + remark; };
  if (!report.error.empty()) add("FAILED: " + report.error);
  for (const Answers* answers : dissenters(report)) {
    std::string remark = answers->who;
    if (answers->level) remark += ' ' + std::string(info_of(*answers->level).name);
    const Cell own{answers->tally.verdict(), answers->tally.count(Verdict::wrong), answers->tally.asked()};
    add(remark + ": " + cell_text(own));
  }
  return text;
}

std::string error_text(double error) { return error == 0 ? "0" : digits(error, "%.2g"); }

std::string answers_text(const Answers& answers) {
  const hard::Tally& tally = answers.tally;
  std::string text = cell_text(Cell{tally.verdict(), tally.count(Verdict::wrong), tally.asked()});
  if (tally.verdict() == Verdict::within_bound && tally.worst_error() != 0)
    text += ' ' + error_text(tally.worst_error());
  return text;
}

std::string who_text(std::span<const Answers* const> by) {
  using Words = std::vector<std::string_view>;
  std::vector<std::pair<std::string_view, Words>> levels;  // of each
  for (const Answers* one : by) {
    auto own = std::ranges::find(levels, one->who, &std::pair<std::string_view, Words>::first);
    if (own == levels.end()) own = levels.insert(levels.end(), {one->who, {}});
    if (one->level) own->second.push_back(info_of(*one->level).name);
  }
  std::string text;
  while (!levels.empty()) {
    const Words at = levels.front().second;
    Words who;
    for (const auto& [name, own] : levels) {
      if (own == at) who.push_back(name);
    }
    std::erase_if(levels, [&](const auto& one) { return one.second == at; });
    text += (text.empty() ? "" : "; ") + joined(who) + (at.empty() ? "" : " at " + joined(at));
  }
  return text;
}

std::string_view oracle_text(hard::Oracle oracle) {
  switch (oracle) {
    case hard::Oracle::rationals:
      return "exact rational arithmetic";
    case hard::Oracle::sturm_chains:
      return "real algebraic numbers: Sturm chains over the rationals";
    case hard::Oracle::more_digits:
      return "the same in at least fifty digits";
    case hard::Oracle::closed_form:
      return "a closed form";
    case hard::Oracle::brute_force:
      return "brute force, decided exactly";
    case hard::Oracle::metamorphic:
      return "another question that must have the same answer";
  }
  return "unknown";
}

std::string default_text(const Summary& summary) {
  std::string text = "The default, watertight, ";
  if (summary.wrong_at_default.empty()) {
    text +=
        summary.at_default == 0 ? "is asked nothing." : "is wrong nowhere: " + plural(summary.at_default, "case") + ".";
  } else {
    text += "is wrong in " + plural(summary.wrong_at_default.size(), "case") + " of " +
            std::to_string(summary.at_default) + ": " + joined(summary.wrong_at_default) + ".";
  }
  if (!summary.wrong_policies.empty()) {
    text +=
        " It breaks " + plural(summary.wrong_policies.size(), "policy") + ": " + joined(summary.wrong_policies) + ".";
  }
  return text;
}

std::string plural(std::size_t count, std::string_view word) {
  std::string text = std::to_string(count) + ' ' + std::string(word);
  if (count == 1) return text;
  if (text.ends_with('y')) return text.substr(0, text.size() - 1) + "ies";
  return text + 's';
}

std::string joined(const std::vector<std::string_view>& words, std::string_view between) {
  std::string text;
  for (const std::string_view word : words) text.append(text.empty() ? "" : between).append(word);
  return text;
}

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", start), text.size());
    const std::string_view word = text.substr(start, end - start);
    start = end + 1;
    if (word.empty()) continue;
    if (!line.empty() && width_of(line) + 1 + width_of(word) > width) {
      lines.push_back(std::move(line));
      line.clear();
    }
    line.append(line.empty() ? "" : " ").append(word);
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f ? '?' : c;
    }
  }
  return result;
}

}  // namespace sightline::stability
