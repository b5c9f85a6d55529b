#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/accuracy/error_sum.h"
#include "bench/accuracy/run.h"
#include "bench/json.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double nanoseconds = 1'000'000'000;

std::string wrong_text(double wrong) { return std::isnan(wrong) ? "" : number_text(wrong, 3); }

std::string standing_text(const PanelReport& panel, const ChoiceReport& choice) {
  const Standing& standing = choice.standing;
  const auto& other = panel.choices[standing.by].name;
  switch (standing.place) {
    case Place::on_front:
      return "front";
    case Place::dominated:
      return measured_text(standing.ratio) + "x " + other;
    case Place::not_resolved:
      return "not resolved: " + other;
    case Place::unknown:
      break;
  }
  return "";
}

std::string panel_text(const PanelReport& panel) {
  TextTable table;
  table.add_column("", panel.name);
  table.add_column("error", "maximum");
  table.add_column("error", "RMS");
  table.add_column(panel.wrong_name, "per million");
  const bool has_counts =
      std::ranges::any_of(panel.choices, [](const ChoiceReport& c) { return c.errors.decisions > 0; });
  if (has_counts) {
    table.add_column(panel.wrong_name, "of");
    table.add_column(panel.wrong_name, "interval");
  }
  table.add_column("time", "ns/" + panel.unit);
  table.add_column("time", "interval");
  table.add_column("", "standing");
  std::vector<std::string> extras;
  for (const auto& [name, value] : panel.choices[0].extras) extras.push_back(name);
  for (const std::string& name : extras) table.add_column("besides", name);
  for (const ChoiceReport& choice : panel.choices) {
    const Estimate time = scaled(choice.seconds, nanoseconds);
    std::vector<std::string> row{choice.name, error_text(choice.errors.maximum), error_text(choice.errors.rms),
                                 wrong_text(choice.errors.wrong_per_million)};
    if (has_counts) {
      const std::size_t decisions = choice.errors.decisions;
      row.insert(row.end(), {decisions == 0 ? "" : count_text(decisions), wrong_interval(choice.errors)});
    }
    row.insert(row.end(), {measured_text(time), interval_text(time, 3), standing_text(panel, choice)});
    for (const auto& [name, value] : choice.extras) row.push_back(number_text(value, 4));
    row.resize((has_counts ? 9 : 7) + extras.size());
    table.add_row(row);
  }
  return panel.description + (panel.error_unit.empty() ? "" : "; errors " + panel.error_unit) + "; front by " +
         kind_name(panel) + "\n\n" + table.text() + "A/A " + measured_text(panel.same) + "x, " +
         interval_text(panel.same, 3) + '\n';
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Per million.
Json wrong_interval_json(const Errors& errors) {
  if (errors.decisions == 0) return nullptr;
  const Estimate share = estimate_of_share(errors.wrong, errors.decisions);
  return {ErrorSum::million * share.low, ErrorSum::million * share.high};
}

Json json_of(const PanelReport& panel) {
  Json choices = Json::array();
  for (const ChoiceReport& choice : panel.choices) {
    const Standing& standing = choice.standing;
    const bool has_other = standing.place == Place::dominated || standing.place == Place::not_resolved;
    Json extras = Json::object();
    for (const auto& [name, value] : choice.extras) extras[name] = number(value);
    choices.push_back({{"name", choice.name},
                       {"maximum_error", number(choice.errors.maximum)},
                       {"rms_error", number(choice.errors.rms)},
                       {"wrong_per_million", number(choice.errors.wrong_per_million)},
                       {"wrong_interval", wrong_interval_json(choice.errors)},
                       {"decisions", choice.errors.decisions},
                       {"seconds", json_of(std::optional(choice.seconds))},
                       {"place", name_of(standing.place)},
                       {"beside", has_other ? Json(panel.choices[standing.by].name) : Json(nullptr)},
                       {"time_over_that", has_other ? json_of(std::optional(standing.ratio)) : Json(nullptr)},
                       {"extras", extras},
                       {"round_seconds", json_of_rounds(choice.round_seconds)}});
  }
  return {{"name", panel.name},
          {"description", panel.description},
          {"unit", panel.unit},
          {"error_unit", panel.error_unit},
          {"front_by", kind_name(panel)},
          {"wrong_name", panel.wrong_name},
          {"same_over_same", json_of(std::optional(panel.same))},
          {"choices", choices}};
}

}  // namespace

std::string kind_name(const PanelReport& panel) {
  if (panel.kind == ErrorKind::wrong) return panel.wrong_name;
  return panel.kind == ErrorKind::maximum ? "maximum error" : "RMS error";
}

std::string wrong_interval(const Errors& errors) {
  if (errors.decisions == 0) return "";
  const Estimate share = estimate_of_share(errors.wrong, errors.decisions);
  return number_text(ErrorSum::million * share.low, 2) + " to " + number_text(ErrorSum::million * share.high, 2);
}

std::string error_text(double error) {
  if (std::isnan(error)) return "";
  if (error == 0) return "0";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1e", error);
  return buffer;
}

std::string head_text(const AccuracyReport& report) {
  return machine_text(report.machine) +
         "\nerror     against an oracle of exact or very wide numbers, computed outside of the timing\n"
         "time      one thread's processor time of one, median of " +
         plural(static_cast<std::size_t>(report.plan.rounds), "round") + " with its interval" +
         (report.plan.rounds < least_rounds ? ": too few for one of 95 %, so that nothing is resolved" : "") +
         "\nwrong     of so many questions; the interval holds the true share with 95 %\n"
         "standing  front: nothing as accurate is faster; 2x NAME: NAME is as accurate, and this takes twice its "
         "time;\n"
         "          not resolved: NAME is as accurate, and the rounds do not tell which is faster\n"
         "A/A       the first line timed twice: an interval that leaves 1 out says how much to believe\n";
}

std::string table_text(const AxisReport& axis) {
  std::string text = axis.name + ": " + axis.question + '\n';
  for (const PanelReport& panel : axis.panels) text += '\n' + panel_text(panel);
  return text;
}

std::string json_text(const AccuracyReport& report) {
  Json axes = Json::array();
  for (const AxisReport& axis : report.axes) {
    Json panels = Json::array();
    for (const PanelReport& panel : axis.panels) panels.push_back(json_of(panel));
    axes.push_back({{"name", axis.name}, {"question", axis.question}, {"panels", panels}});
  }
  const Json json{{"schema", "sightline-accuracy 1"},
                  {"date", report.machine.date},
                  {"machine", json_of(report.machine)},
                  {"seed", report.plan.seed},
                  {"quick", report.plan.is_quick},
                  {"rounds", report.plan.rounds},
                  {"axes", axes}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace sightline::bench
