#include "tests/stability/print.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "tests/stability/text.h"

namespace sightline::stability {
namespace {

constexpr std::size_t line_width = 100;
constexpr std::string_view gap = "  ";

/// Columns of text, all to the left. A row of one cell is a heading and widens nothing.
class Table {
 public:
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  void print(std::ostream& out) const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()));
      for (std::size_t c = 0; row.size() > 1 && c < row.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
    }
    for (const auto& row : rows_) {
      std::string line;
      for (std::size_t c = 0; c < row.size(); ++c) {
        line += row[c] + std::string(widths[c] > width_of(row[c]) ? widths[c] - width_of(row[c]) : 0, ' ');
        line += gap;
      }
      line.erase(line.find_last_not_of(' ') + 1);
      out << line << '\n';
    }
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

bool is_shown(std::size_t column, const std::optional<Level>& level) { return !level || column == column_of(level); }

void print_summary(std::ostream& out, const Report& report, const std::optional<Level>& level) {
  const Summary summary = summary_of(report);
  Table table;
  table.add({"cases by verdict", "exact", "bound", "WRONG", "–"});
  for (std::size_t column = 0; column < column_count; ++column) {
    if (!is_shown(column, level)) continue;
    const Summary::Column& own = summary.columns[column];
    std::vector<std::string> row{std::string(gap) + std::string(column_name(column))};
    for (const std::size_t count : own.cases) row.push_back(std::to_string(count));
    row.push_back(std::to_string(own.not_applicable));
    table.add(std::move(row));
  }
  table.print(out);
  out << '\n' << plural(summary.cases, "case") << ", of which " << plural(summary.policies, "policy");
  if (report.share < 1) out << "; " << percent_text(report.share) << " of their questions";
  out << ".\n";
  if (is_shown(column_of(Level::watertight), level)) out << default_text(summary) << '\n';
  if (summary.failed > 0) out << plural(summary.failed, "case") << " could not be asked to the end.\n";
}

/// The first line after `title`, the others below it.
void print_text(std::ostream& out, std::string_view title, std::string_view text) {
  constexpr std::size_t indent = 12;
  std::string head(title);
  head.resize(indent, ' ');
  for (const std::string& line : wrapped(text, line_width - indent)) {
    out << head << line << '\n';
    head.assign(indent, ' ');
  }
}

/// Who answered how, by levels where there are any, and then examples.
void print_answers(std::ostream& out, std::span<const Answers> all, bool has_levels) {
  const std::vector<Line> lines = lines_of(all);
  const auto is_used = [&](std::size_t column) {
    return std::ranges::any_of(lines, [&](const Line& line) { return line.at[column] != nullptr; });
  };
  Table table;
  std::vector<std::string> headings{std::string(gap) + "by"};
  for (std::size_t column = 0; column < column_count; ++column) {
    if (is_used(column)) headings.emplace_back(has_levels ? column_name(column) : "");
  }
  headings.emplace_back("questions");
  table.add(std::move(headings));
  for (const Line& line : lines) {
    std::vector<std::string> row{std::string(gap) + std::string(line.who)};
    std::uint64_t asked = 0;
    for (std::size_t column = 0; column < column_count; ++column) {
      if (!is_used(column)) continue;
      row.push_back(line.at[column] ? answers_text(*line.at[column]) : "–");
      if (line.at[column]) asked = std::max(asked, line.at[column]->tally.asked());
    }
    row.push_back(std::to_string(asked));
    table.add(std::move(row));
  }
  table.print(out);
  for (const Question& question : questions_of(all)) {
    out << '\n';
    print_text(out, "  for", question.inputs);
    print_text(out, "  true", question.expected);
    for (const Question::Reply& reply : question.replies) {
      print_text(out, reply.is_wrong ? "  WRONG" : "  got", reply.got + " (" + who_text(reply.by) + ")");
    }
  }
}

}  // namespace

void print_matrix(std::ostream& out, const Report& report, const std::optional<Level>& level) {
  Table table;
  std::vector<std::string> headings{"case"};
  for (std::size_t column = 0; column < column_count; ++column) {
    if (is_shown(column, level)) headings.emplace_back(column_name(column));
  }
  headings.insert(headings.end(), {"naive", ""});
  table.add(std::move(headings));
  std::string_view group;
  for (const CaseReport& one : report.cases) {
    if (one.hard_case->group != group) table.add({std::string(group = one.hard_case->group)});
    std::vector<std::string> row{std::string(gap) + std::string(one.hard_case->id)};
    for (std::size_t column = 0; column < column_count; ++column) {
      if (is_shown(column, level)) row.push_back(cell_text(cell_of(one, column)));
    }
    row.insert(row.end(), {naive_text(one), remarks_text(one)});
    table.add(std::move(row));
  }
  table.print(out);
  out << '\n';
  print_summary(out, report, level);
}

void print_list(std::ostream& out, std::span<const HardCase* const> cases) {
  Table table;
  std::string_view group;
  for (const HardCase* one : cases) {
    if (one->group != group) table.add({std::string(group = one->group)});
    table.add(
        {std::string(gap) + std::string(one->id), std::string(one->inputs) + (one->is_policy ? " (policy)" : "")});
  }
  table.print(out);
}

void print_explanation(std::ostream& out, const CaseReport& report, const std::string& again) {
  const HardCase& own = *report.hard_case;
  out << own.id << " (" << own.group << (own.is_policy ? ", a policy: more than one answer is right" : "") << ")\n\n";
  print_text(out, "inputs", own.inputs);
  print_text(out, "expected", own.expected);
  print_text(out, "why", own.why);
  print_text(out, "oracle", oracle_text(own.oracle));
  print_text(out, "reference", own.reference);
  if (!report.error.empty()) print_text(out, "FAILED", report.error);
  out << "\nanswers\n";
  print_answers(out, report.answers, true);
  if (!report.naive.empty()) {
    out << "\nnaive code\n";
    print_answers(out, report.naive, false);
  }
  out << '\n';
  print_text(out, "again", again);
}

}  // namespace sightline::stability
