#include <nlohmann/json.hpp>

#include "bench/graph/run.h"
#include "bench/json.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double nanoseconds = 1'000'000'000;

std::string_view title_of(const std::string& family) {
  if (family == "worlds") return "Where leaves are in the world, by their depth: ns a leaf";
  if (family == "rays") return "Bounds against rays: ns a test";
  if (family == "views") return "Bounds against cameras' pyramids: ns a test";
  return "Bounds after a change: ns until the root's are up to date";
}

std::string fact_text(const std::string& heading, double value) {
  if (heading == "in vain") return number_text(value, 2) + " %";
  if (heading == "volume") return number_text(value, 3) + 'x';
  return count_text(static_cast<std::size_t>(value));
}

}  // namespace

std::string text_of(const GraphReport& report) {
  std::string text = machine_text(report.machine);
  text +=
      "\ntimes    as fast as the table's first line, paired by round\n"
      "volume   of the bounds over that of what they hold\n"
      "in vain  share of the bounds met whose thing is not hit, or not seen\n"
      "nodes    whose bounds were computed\n";
  std::string family;
  for (std::size_t i = 0; i < report.rows.size();) {
    const GraphRow& first = report.rows[i];
    if (first.family != family) text += '\n' + std::string(title_of(first.family)) + '\n';
    family = first.family;
    TextTable table;
    table.add_column("", first.table);
    table.add_column("time", "ns");
    table.add_column("time", "interval");
    table.add_column("speed", "times");
    for (const auto& [heading, value] : first.facts) table.add_column("counted", heading);
    for (; i < report.rows.size() && report.rows[i].table == first.table && report.rows[i].family == family; ++i) {
      const GraphRow& row = report.rows[i];
      const Estimate time = scaled(row.seconds, nanoseconds);
      std::vector<std::string> cells{row.name, measured_text(time), interval_text(time, 3),
                                     measured_text(row.ratio) + 'x'};
      for (const auto& [heading, value] : row.facts) cells.push_back(fact_text(heading, value));
      table.add_row(std::move(cells));
    }
    text += '\n' + table.text();
  }
  return text;
}

std::string json_text(const GraphReport& report) {
  Json rows = Json::array();
  for (const GraphRow& row : report.rows) {
    Json facts = Json::object();
    for (const auto& [heading, value] : row.facts) facts[heading] = value;
    rows.push_back({{"family", row.family},
                    {"table", row.table},
                    {"name", row.name},
                    {"seconds", json_of(row.seconds)},
                    {"speed_over_first", json_of(row.ratio)},
                    {"facts", facts},
                    {"round_seconds", json_of_rounds(row.round_seconds)}});
  }
  const Json json{{"machine", json_of(report.machine)}, {"rounds", report.plan.rounds}, {"rows", rows}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
