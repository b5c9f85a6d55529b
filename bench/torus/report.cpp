#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/json.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"
#include "bench/torus/run.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string share_text(double share) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", share);
  return buffer;
}

std::string error_text(double error) {
  if (error == 0) return "0";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.0e", error);
  return buffer;
}

}  // namespace

std::string head_text(const TorusReport& report) {
  return machine_text(report.machine, " beside Ferrari's closed form") +
         "\nns/ray  one thread's processor time for all real roots of a ray's line\n"
         "times   this one's time over Ferrari's, paired by round\n"
         "wrong   rays with another number of real roots than exact numbers say\n"
         "error   the largest of a point, in radii of the ring, where the number is right\n";
}

std::string table_text(const TorusReportPart& part) {
  TextTable table;
  table.add_column("", "r/R = " + share_text(part.minor) + ", " + part.name);
  table.add_column("time", "ns/ray");
  table.add_column("time", "interval");
  table.add_column("times Ferrari", "times");
  table.add_column("times Ferrari", "interval");
  table.add_column("roots", "wrong");
  table.add_column("roots", "error");
  const double nanoseconds = 1'000'000'000 / static_cast<double>(part.rays);
  for (const TorusRow& row : part.rows) {
    const Estimate time = scaled(row.seconds, nanoseconds);
    const bool is_peer = row.name == ferrari_name;
    table.add_row({row.name, measured_text(time), interval_text(time, 3), is_peer ? "" : measured_text(row.ratio) + 'x',
                   is_peer ? "" : interval_text(row.ratio, 3), count_text(row.wrong_counts),
                   error_text(row.worst_error)});
  }
  return part.name + ": " + part.description + ", " + plural(part.rays, "ray") + ", " + plural(part.roots, "root") +
         "\n\n" + table.text();
}

std::string json_text(const TorusReport& report) {
  Json parts = Json::array();
  for (const TorusReportPart& part : report.parts) {
    Json rows = Json::array();
    for (const TorusRow& row : part.rows) {
      rows.push_back({{"name", row.name},
                      {"seconds", json_of(row.seconds)},
                      {"time_over_ferrari", json_of(row.ratio)},
                      {"wrong_counts", row.wrong_counts},
                      {"worst_error", row.worst_error},
                      {"round_seconds", json_of_rounds(row.round_seconds)}});
    }
    parts.push_back({{"minor_over_major", part.minor},
                     {"rays", part.name},
                     {"description", part.description},
                     {"ray_count", part.rays},
                     {"root_count", part.roots},
                     {"rows", rows}});
  }
  const Json json{{"machine", json_of(report.machine)}, {"rounds", report.plan.rounds}, {"parts", parts}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
