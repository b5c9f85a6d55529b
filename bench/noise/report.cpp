#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/json.h"
#include "bench/noise/run.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string power_text(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", number);
  return text;
}

/// The tables' names in the order of their rows.
std::vector<std::string> tables_of(const NoiseReport& report) {
  std::vector<std::string> tables;
  for (const NoiseRow& row : report.rows) {
    if (tables.empty() || tables.back() != row.table) tables.push_back(row.table);
  }
  return tables;
}

std::string table_text(const NoiseReport& report, const std::string& name) {
  TextTable table;
  bool has_ratio = false, has_error = false;
  for (const NoiseRow& row : report.rows) {
    if (row.table != name) continue;
    has_ratio |= row.ratio.has_value();
    has_error |= row.error > 0;
  }
  table.add_column("", name);
  table.add_column("time", "ns/point");
  table.add_column("time", "interval");
  if (has_ratio) {
    table.add_column("speed", "xlibnoise");
    table.add_column("speed", "interval");
  }
  if (has_error) table.add_column("", "largest error");
  for (const NoiseRow& row : report.rows) {
    if (row.table != name) continue;
    const Estimate time = scaled(row.seconds, 1'000'000'000);
    std::vector<std::string> cells{row.name, measured_text(time), interval_text(time, 3)};
    if (has_ratio) {
      cells.push_back(row.ratio ? measured_text(*row.ratio) + 'x' : "");
      cells.push_back(row.ratio ? interval_text(*row.ratio, 3) : "");
    }
    if (has_error) cells.push_back(power_text(row.error));
    table.add_row(std::move(cells));
  }
  return table.text();
}

}  // namespace

std::string text_of(const NoiseReport& report) {
  std::string text = machine_text(report.machine);
  for (const std::string& package : report.missing) {
    text += "Without a peer, for which 'apt-get install " + package + "' and configuring anew.\n";
  }
  text += "\nns/point  one thread's processor time, " + count_text(report.plan.points) +
          " points a pass, median of the rounds\n"
          "speed     libnoise's time over this one's, paired by round\n"
          "scalar    one call a point; batch: points as lists of x, y and z, as its users have them where they can\n";
  for (const std::string& name : tables_of(report)) text += '\n' + table_text(report, name);
  TextTable accuracy;
  accuracy.add_column("", "fast (float) against precise (double)");
  accuracy.add_column("", "near");
  accuracy.add_column("error", "largest");
  accuracy.add_column("error", "rms");
  for (const NoiseAccuracy& line : report.accuracy) {
    accuracy.add_row({line.name, number_text(line.distance, 1), power_text(line.largest), power_text(line.rms)});
  }
  return text + '\n' + accuracy.text();
}

std::string json_text(const NoiseReport& report) {
  Json rows = Json::array(), accuracy = Json::array();
  for (const NoiseRow& row : report.rows) {
    rows.push_back({{"table", row.table},
                    {"name", row.name},
                    {"is_peer", row.is_peer},
                    {"seconds_a_point", json_of(std::optional(row.seconds))},
                    {"libnoise_time_over_this", json_of(row.ratio)},
                    {"largest_error", row.error},
                    {"round_seconds", json_of_rounds(row.round_seconds)}});
  }
  for (const NoiseAccuracy& line : report.accuracy) {
    accuracy.push_back(
        {{"name", line.name}, {"distance", line.distance}, {"largest_error", line.largest}, {"rms_error", line.rms}});
  }
  const Json json{{"machine", json_of(report.machine)},
                  {"points", report.plan.points},
                  {"rounds", report.plan.rounds},
                  {"rows", rows},
                  {"float_against_double", accuracy}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
