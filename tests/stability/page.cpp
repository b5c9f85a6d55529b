#include "tests/stability/page.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "tests/stability/names.h"
#include "tests/stability/sketch_svg.h"
#include "tests/stability/text.h"

namespace sightline::stability {
namespace {

constexpr std::string_view lead =
    "Ray tracing is easy to write and hard to get right: inputs where numbers cancel, overflow, tie or become NaN. "
    "Each "
    "line is such a case; each column is what the library answers at one of its levels of precision, compared with a "
    "truth that shares no code with it. Open a line to see why it is hard, in words and drawn, and what code gives "
    "that "
    "does not know better.";

std::string tag(std::string_view name, std::string_view attributes, std::string_view inside) {
  std::string text = "<" + std::string(name);
  if (!attributes.empty()) text.append(" ").append(attributes);
  return text.append(">").append(inside).append("</").append(name).append(">");
}

/// Of a cell. Being wrong where nothing is promised looks less loud.
std::string_view class_of(Verdict verdict, std::size_t column) {
  if (verdict == Verdict::wrong) return is_promised(column) ? "wrong" : "fast";
  return verdict == Verdict::exact ? "exact" : "bound";
}

std::string matrix_cell(const std::optional<Cell>& cell, std::size_t column) {
  std::string inside(cell ? verdict_text(cell->verdict) : "–");
  if (cell && cell->verdict == Verdict::wrong) {
    inside += "<small>" + std::to_string(cell->wrong) + "/" + std::to_string(cell->asked) + "</small>";
  }
  return tag("td", "class=" + std::string(cell ? class_of(cell->verdict, column) : "none"), inside);
}

// ---- Of one case

std::string definition(std::string_view term, std::string_view text) {
  return text.empty() ? "" : tag("dt", "", term) + tag("dd", "", escaped(text));
}

/// Who answered how, by levels where there are any.
std::string answers_table(std::span<const Answers> all, bool has_levels) {
  const std::vector<Line> lines = lines_of(all);
  const auto is_used = [&](std::size_t column) {
    return std::ranges::any_of(lines, [&](const Line& line) { return line.at[column] != nullptr; });
  };
  std::string text = "<div class=scroll><table class=answers><thead><tr><th>by", asked;
  for (std::size_t column = 0; column < column_count; ++column) {
    if (is_used(column)) text += tag("th", "", has_levels ? column_name(column) : "");
  }
  text += "<th>questions</tr></thead><tbody>\n";
  for (const Line& line : lines) {
    text += "<tr>" + tag("th", "scope=row", escaped(line.who));
    for (std::size_t column = 0; column < column_count; ++column) {
      const Answers* own = line.at[column];
      if (own) asked = std::to_string(own->tally.asked());
      if (!is_used(column)) continue;
      const std::string_view kind =
          own ? class_of(own->tally.verdict(), has_levels ? column : column_of(Level::fast)) : "none";
      text += tag("td", "class=" + std::string(kind), own ? answers_text(*own) : "–");
    }
    text += tag("td", "", asked) + "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string questions_list(std::span<const Answers> all) {
  std::string text;
  for (const Question& question : questions_of(all)) {
    text += "<dl class=question>" + definition("for", question.inputs) + definition("true", question.expected);
    for (const Question::Reply& reply : question.replies) {
      text += tag("dt", reply.is_wrong ? "class=bad" : "", reply.is_wrong ? "WRONG" : "got") +
              tag("dd", "", escaped(reply.got) + " <small>" + escaped(who_text(reply.by)) + "</small>");
    }
    text += "</dl>\n";
  }
  return text;
}

std::string detail_of(const CaseReport& report) {
  const HardCase& own = *report.hard_case;
  std::string text = "<div class=told><dl>";
  text += definition("inputs", own.inputs) + definition("expected", own.expected) + definition("why", own.why);
  text += definition("oracle", oracle_text(own.oracle)) + definition("reference", own.reference);
  text += definition("remarks", remarks_text(report));
  text += tag("dt", "", "again") + tag("dd", "", tag("code", "", "./sightline stability --explain " + escaped(own.id)));
  const hard::Sketch sketch = own.draw();
  text +=
      "</dl>" + tag("figure", "", svg_of(sketch, false) + tag("figcaption", "", escaped(sketch.caption))) + "</div>\n";
  text +=
      tag("h2", "", "What the library answers") + answers_table(report.answers, true) + questions_list(report.answers);
  if (report.naive.empty()) return text;
  return text + tag("h2", "", "What naive code answers") + answers_table(report.naive, false) +
         questions_list(report.naive);
}

/// What the filter by verdicts goes by.
std::string marks_of(const CaseReport& report) {
  std::vector<std::string_view> marks;
  bool is_all_exact = report.error.empty(), has_bound = false, has_fast_wrong = false;
  for (std::size_t column = 0; column < column_count; ++column) {
    const std::optional<Cell> cell = cell_of(report, column);
    if (!cell) continue;
    is_all_exact = is_all_exact && cell->verdict == Verdict::exact;
    has_bound = has_bound || cell->verdict == Verdict::within_bound;
    has_fast_wrong = has_fast_wrong || (!is_promised(column) && cell->verdict == Verdict::wrong);
  }
  if (is_all_exact) marks.push_back("exact");
  if (has_bound) marks.push_back("bound");
  if (has_fast_wrong) marks.push_back("fast");
  if (!keeps_promises(report)) marks.push_back("broken");
  if (report.hard_case->is_policy) marks.push_back("policy");
  if (!dissenters(report).empty()) marks.push_back("dissent");
  return joined(marks, " ");
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return c < 0x80 ? char(std::tolower(c)) : char(c); });
  return text;
}

std::string case_rows(const CaseReport& report) {
  const HardCase& own = *report.hard_case;
  const std::string id = escaped(own.id);
  std::string find;
  for (const std::string_view text : {own.id, own.group, own.inputs, own.expected, own.why, own.reference}) {
    find.append(text).append(" ");
  }
  std::string text = "<tr class=row id=\"" + id + "\" data-group=\"" + escaped(own.group) + "\" data-marks=\"" +
                     marks_of(report) + "\" data-find=\"" + escaped(lower(find + remarks_text(report))) +
                     "\"><th scope=row><button type=button aria-expanded=false aria-controls=\"" + id + "-detail\">" +
                     id + "</button></th>";
  for (std::size_t column = 0; column < column_count; ++column) text += matrix_cell(cell_of(report, column), column);
  text += tag("td", "class=plain", naive_text(report)) +
          tag("td", report.error.empty() ? "class=\"plain remarks\"" : "class=\"wrong remarks\"",
              escaped(remarks_text(report)));
  return text + "</tr>\n<tr class=detail id=\"" + id +
         "-detail\" hidden><td colspan=" + std::to_string(column_count + 3) + "><div class=case>" + detail_of(report) +
         "</div></td></tr>\n";
}

// ---- Around them

std::string legend() {
  return R"(<dl class=legend>
<dt><span class="chip exact">exact</span><dd>the true decision, and every number the true one, rounded to nearest
<dt><span class="chip bound">bound</span><dd>the true decision, and numbers as near the true ones as that level promises
<dt><span class="chip fast">WRONG</span><dd>anything else, with how many of how many, at <b>fast</b>: float throughout, promises nothing here
<dt><span class="chip wrong">WRONG</span><dd>the same where something is promised: at every other level, and where there is none
<dt>–<dd>the column does not apply; <b>always</b> is what has no levels
<dt>naive<dd>how often code as it is often written is wrong of the same questions
</dl>
)";
}

std::string sums(const Summary& summary) {
  std::string text = "<table class=sums><thead><tr><th>cases<th>exact<th>bound<th>WRONG<th>–</tr></thead><tbody>\n";
  for (std::size_t column = 0; column < column_count; ++column) {
    text += "<tr>" + tag("th", "scope=row", column_name(column));
    for (const std::size_t count : summary.columns[column].cases) text += tag("td", "", std::to_string(count));
    text += tag("td", "", std::to_string(summary.columns[column].not_applicable)) + "</tr>\n";
  }
  return text + "</tbody></table>\n";
}

std::string filters(const std::vector<std::string_view>& groups) {
  std::string text =
      "<form class=filters onsubmit=\"return false\"><label>text<input id=text type=search placeholder=\"any words\" "
      "autocomplete=off></label><label>group<select id=group><option value=\"\">all</option>";
  for (const std::string_view group : groups) text += "<option>" + escaped(group) + "</option>";
  return text +
         "</select></label><label>verdict<select id=verdict><option value=\"\">all</option>"
         "<option value=broken>WRONG where promised</option><option value=fast>WRONG at fast</option>"
         "<option value=bound>bound somewhere</option><option value=exact>exact everywhere</option>"
         "<option value=dissent>some worse than most</option><option value=policy>policies</option></select></label>"
         "<button id=clear type=button>clear</button><span id=count aria-live=polite></span></form>\n";
}

std::string matrix(const Report& report) {
  std::string text = "<div class=matrix-scroll><table class=matrix><thead><tr><th>case";
  for (std::size_t column = 0; column < column_count; ++column) text += "<th>" + std::string(column_name(column));
  text += "<th>naive<th></tr></thead>\n";
  std::string_view group;
  for (const CaseReport& one : report.cases) {
    if (one.hard_case->group != group) {
      text += std::string(group.empty() ? "" : "</tbody>\n") +
              "<tbody><tr class=group><th scope=rowgroup colspan=" + std::to_string(column_count + 3) + ">" +
              escaped(one.hard_case->group) + "</th></tr>\n";
      group = one.hard_case->group;
    }
    text += case_rows(one);
  }
  return text + (group.empty() ? "" : "</tbody>") + "</table></div>\n";
}

std::string made_with(const Report& report, const Provenance& own) {
  std::string text = "Sightline " + own.version + ", " + own.date + ". " + own.processor + ", " + own.system + ". " +
                     own.compiler + ", " + own.build_type + ": " + own.flags + ". ";
  text += percent_text(report.share) + " of the questions, from fixed seeds.";
  return tag("footer", "class=note", escaped(text));
}

}  // namespace

std::string page_of(const Report& report, const Provenance& provenance) {
  const Summary summary = summary_of(report);
  std::vector<std::string_view> groups;
  for (const CaseReport& one : report.cases) {
    if (std::ranges::find(groups, one.hard_case->group) == groups.end()) groups.push_back(one.hard_case->group);
  }
  return "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport content=\"width=device-width, "
         "initial-scale=1\">\n<link rel=icon href=\"data:,\"><title>Sightline: hard cases</title>\n<style>" +
         std::string(page_style) +
         "</style>\n<noscript><style>.detail[hidden] { display: table-row; "
         "}</style></noscript></head>\n<body><header>" +
         tag("h1", "", "Hard cases") + tag("p", "", lead) +
         tag("p", std::string("class=\"verdict ") + (keeps_promises(report) ? "good\"" : "bad\""),
             escaped(default_text(summary))) +
         sums(summary) + legend() + "</header>\n<main>" + filters(groups) + matrix(report) + "</main>\n" +
         made_with(report, provenance) + "\n<script>" + std::string(page_script) + "</script></body></html>\n";
}

}  // namespace sightline::stability
