#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/claims/rules.h"
#include "bench/claims/run.h"
#include "bench/json.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t page_width = 100, label_width = 12;

/// Words in lines of at most page_width, all but the first set in by label_width.
std::string labelled(const std::string& label, std::string_view text) {
  std::string out = label + std::string(label_width - label.size(), ' ');
  std::size_t used = label_width;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (used > label_width && used + 1 + end > page_width) {
      out += '\n' + std::string(label_width, ' ');
      used = label_width;
    }
    if (used > label_width) out += ' ', ++used;
    out += text.substr(0, end);
    used += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out + '\n';
}

bool is_exact(const Estimate& value) { return value.low == value.high; }

std::string unit_text(const std::string& unit) { return unit.empty() || unit == "x" ? unit : ' ' + unit; }

TextTable figure_table(const Finding& finding) {
  TextTable table;
  for (const char* heading : {"figure", "value", "interval"}) table.add_column("", heading);
  for (const Figure& figure : finding.figures) {
    const Estimate& value = figure.value;
    const bool has_interval = !is_exact(value) && std::isfinite(value.low);
    const std::string text = has_interval && value.median < 999.5 ? measured_text(value) : digits_text(value.median);
    table.add_row({figure.name, text + unit_text(figure.unit),
                   is_exact(value) ? "exact"
                   : has_interval  ? digits_text(value.low) + " to " + digits_text(value.high)
                                   : "unknown"});
  }
  return table;
}

TextTable growth_table(const Finding& finding) {
  TextTable table;
  for (const char* heading : {"growth", "from", "to", "exponent", "standard error"}) table.add_column("", heading);
  for (const Growth& growth : finding.growths) {
    if (growth.x.empty()) continue;
    const auto at = [&](std::size_t i) {
      return digits_text(growth.y[i]) + unit_text(growth.y_unit) + " at " + digits_text(growth.x[i]);
    };
    const bool has_error = growth.fit && growth.fit->standard_error;
    table.add_row({growth.name, at(0), at(growth.x.size() - 1), growth.fit ? number_text(growth.fit->exponent) : "",
                   has_error ? number_text(*growth.fit->standard_error, 2) : ""});
  }
  return table;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const Growth& growth) {
  Json fit = nullptr;
  if (growth.fit) {
    fit = {{"exponent", number(growth.fit->exponent)},
           {"factor", number(growth.fit->factor)},
           {"standard_error", growth.fit->standard_error ? number(*growth.fit->standard_error) : Json(nullptr)}};
  }
  return {{"name", growth.name}, {"x_unit", growth.x_unit}, {"y_unit", growth.y_unit}, {"x", growth.x}, {"y", growth.y},
          {"fit", fit},          {"chart", growth.chart}};
}

Json json_of(const ClaimReport& report) {
  Json figures = Json::array(), growths = Json::array();
  for (const Figure& figure : report.finding.figures) {
    figures.push_back({{"name", figure.name},
                       {"unit", figure.unit},
                       {"median", number(figure.value.median)},
                       {"low", number(figure.value.low)},
                       {"high", number(figure.value.high)},
                       {"confidence", figure.value.confidence}});
  }
  for (const Growth& growth : report.finding.growths) growths.push_back(json_of(growth));
  return {{"name", report.claim->name},
          {"statement", report.claim->statement},
          {"experiment", report.claim->experiment},
          {"rule", report.claim->rule},
          {"verdict", name_of(report.finding.verdict)},
          {"reason", report.finding.reason},
          {"figures", figures},
          {"growths", growths}};
}

}  // namespace

std::string head_text(const ClaimsReport& report) {
  return machine_text(report.machine) + "\nfigure    ratios and times: medians of " +
         plural(static_cast<std::size_t>(report.plan.rounds), "round") +
         " in which all take turns, with intervals that hold\n"
         "          the true median with 95 %; processor time of one thread; counts are exact\n"
         "growth    the power of size that a quantity grows as, by least squares in logarithms\n"
         "verdict   what the rule, fixed before measuring, makes of the figures' intervals\n";
}

std::string claim_text(const ClaimReport& report) {
  const Finding& finding = report.finding;
  std::string text = std::string(report.claim->name) + '\n' + labelled("statement", report.claim->statement) +
                     labelled("experiment", report.claim->experiment) + labelled("rule", report.claim->rule);
  if (!finding.figures.empty()) text += figure_table(finding).text();
  if (!finding.growths.empty()) text += growth_table(finding).text();
  return text + labelled("verdict", std::string(name_of(finding.verdict)) + ": " + finding.reason);
}

std::string verdicts_text(const ClaimsReport& report) {
  std::string text;
  for (const ClaimReport& claim : report.claims) {
    const std::string name(claim.claim->name);
    text += name + std::string(23 - std::min<std::size_t>(22, name.size()), ' ') +
            std::string(name_of(claim.finding.verdict)) + std::string(20 - name_of(claim.finding.verdict).size(), ' ') +
            std::string(claim.claim->statement) + '\n';
  }
  return text;
}

std::string json_text(const ClaimsReport& report) {
  Json claims = Json::array();
  for (const ClaimReport& claim : report.claims) claims.push_back(json_of(claim));
  const Json json{{"schema", "sightline-claims 1"},
                  {"date", report.machine.date},
                  {"machine", json_of(report.machine)},
                  {"seed", report.plan.seed},
                  {"quick", report.plan.is_quick},
                  {"rounds", report.plan.rounds},
                  {"claims", claims}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace sightline::bench
