#include <nlohmann/json.hpp>

#include "bench/json.h"
#include "bench/moving/run.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {

using Json = nlohmann::ordered_json;

std::string text_of(const MovingReport& report) {
  const MovingPlan& plan = report.plan;
  std::string text =
      machine_text(report.machine) + '\n' + plural(static_cast<std::size_t>(plan.frames), "frame") + " of " +
      plural(report.instances, "sphere") + ", each level turning; " + plural(report.triangles, "triangle") +
      ", pictures of " + std::to_string(plan.width) + 'x' + std::to_string(plan.height) +
      ", all equal\nturning the nodes and placing their meshes: " + number_text(1000 * report.update_seconds, 2) +
      " ms a frame\n\n" +
      "build, refit  ms a frame for the structure over the spheres, by all threads\n"
      "times         building over refitting, paired by frame\n"
      "trace         ms a frame, one thread, after building and after refitting\n"
      "cheaper       frames that were built where the choice is left to what was measured, and all its\n"
      "              time over that of building every frame\n\n";
  TextTable table;
  for (const auto& [group, heading] : std::initializer_list<std::pair<const char*, const char*>>{{"", "over spheres"},
                                                                                                 {"", "build"},
                                                                                                 {"", "refit"},
                                                                                                 {"", "times"},
                                                                                                 {"trace", "built"},
                                                                                                 {"trace", "refitted"},
                                                                                                 {"cheaper", "built"},
                                                                                                 {"cheaper", "time"}}) {
    table.add_column(group, heading);
  }
  for (const MovingRow& row : report.rows) {
    table.add_row({row.name, measured_text(scaled(row.build, 1000)), measured_text(scaled(row.refit, 1000)),
                   measured_text(row.ratio) + 'x', measured_text(scaled(row.built_trace, 1000)),
                   measured_text(scaled(row.refitted_trace, 1000)), std::to_string(row.builds_when_cheaper),
                   number_text(row.cheaper_seconds / row.rebuild_seconds, 2)});
  }
  return text + table.text();
}

std::string json_text(const MovingReport& report) {
  Json rows = Json::array();
  for (const MovingRow& row : report.rows) {
    rows.push_back({{"name", row.name},
                    {"build_seconds", json_of(row.build)},
                    {"refit_seconds", json_of(row.refit)},
                    {"build_over_refit", json_of(row.ratio)},
                    {"built_trace_seconds", json_of(row.built_trace)},
                    {"refitted_trace_seconds", json_of(row.refitted_trace)},
                    {"builds_when_cheaper", row.builds_when_cheaper},
                    {"cheaper_seconds", row.cheaper_seconds},
                    {"rebuild_seconds", row.rebuild_seconds},
                    {"frame_build_seconds", json_of_rounds(row.build_seconds)},
                    {"frame_refit_seconds", json_of_rounds(row.refit_seconds)}});
  }
  const Json json{{"machine", json_of(report.machine)},
                  {"levels", report.plan.levels},
                  {"frames", report.plan.frames},
                  {"instances", report.instances},
                  {"triangles", report.triangles},
                  {"update_seconds", report.update_seconds},
                  {"rows", rows}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
