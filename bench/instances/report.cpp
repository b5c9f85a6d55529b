#include <nlohmann/json.hpp>

#include "bench/instances/run.h"
#include "bench/json.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string megabytes(std::size_t bytes) {
  return bytes == 0 ? "?" : number_text(static_cast<double>(bytes) / 1'000'000, 3);
}

}  // namespace

std::string text_of(const InstanceReport& report) {
  const InstancePlan& plan = report.plan;
  std::string text = machine_text(report.machine, " beside Embree " + report.machine.embree_version);
  text += "\n" + count_text(plan.count) + " instances of " + plan.scene + ", " +
          plural(report.mesh_triangles, "triangle") + " each; its mesh and " + plan.lower.label + " take " +
          megabytes(report.mesh_bytes) + " MB, once\n";
  for (std::size_t s = 0; s < report.sets.size(); ++s) {
    text += report.sets[s] + ": " + plural(report.ray_counts[s], "ray") + ' ' + report.descriptions[s] + ", " +
            count_text(report.hit_counts[s]) + " of which hit\n";
  }
  text +=
      "\nMB beyond the mesh: what placements and structure are, what the process holds while it traces, and the most\n"
      "that it held while it built; for Embree without our placements. us/ray and the speed over Embree's, in\n"
      "brackets, of one thread, paired by round.\n\n";
  TextTable table;
  table.add_column("", "over instances");
  table.add_column("build", "s");
  for (const char* heading : {"are", "resident", "peak"}) table.add_column("MB beyond the mesh", heading);
  for (const std::string& set : report.sets) {
    table.add_column(set, "us/ray");
    table.add_column(set, "");
  }
  for (const InstanceRow& row : report.rows) {
    std::vector<std::string> cells{row.name, number_text(row.build_seconds, 2), megabytes(row.bytes),
                                   megabytes(row.resident), megabytes(row.peak)};
    for (std::size_t s = 0; s < report.sets.size(); ++s) {
      const InstanceRow::Times& times = row.times[s];
      cells.push_back(measured_text(scaled(times.seconds, 1'000'000 / static_cast<double>(report.ray_counts[s]))));
      cells.push_back(times.ratio ? '(' + measured_text(*times.ratio) + "x)" : "");
    }
    table.add_row(std::move(cells));
  }
  text += table.text();
  const InstanceRow& embree = report.rows.back();
  for (std::size_t s = 0; s < report.sets.size(); ++s) {
    if (embree.times[s].differing_hits == 0) continue;
    text += "embree ends at another triangle for " + plural(embree.times[s].differing_hits, report.sets[s] + " ray") +
            ": it rounds rays to float in each instance\n";
  }
  return text;
}

std::string json_text(const InstanceReport& report) {
  Json rows = Json::array();
  for (const InstanceRow& row : report.rows) {
    Json sets = Json::object();
    for (std::size_t s = 0; s < report.sets.size(); ++s) {
      const InstanceRow::Times& times = row.times[s];
      sets[report.sets[s]] = {{"seconds", json_of(times.seconds)},
                              {"speed_over_embree", json_of(times.ratio)},
                              {"differing_hits", times.differing_hits},
                              {"round_seconds", json_of_rounds(times.round_seconds)}};
    }
    rows.push_back({{"name", row.name},
                    {"is_peer", row.is_peer},
                    {"build_seconds", row.build_seconds},
                    {"bytes", row.bytes},
                    {"resident_bytes", row.resident},
                    {"peak_bytes", row.peak},
                    {"rays", sets}});
  }
  Json sets = Json::array();
  for (std::size_t s = 0; s < report.sets.size(); ++s) {
    sets.push_back({{"name", report.sets[s]},
                    {"description", report.descriptions[s]},
                    {"rays", report.ray_counts[s]},
                    {"hits", report.hit_counts[s]}});
  }
  const Json json{{"machine", json_of(report.machine)},
                  {"scene", report.plan.scene},
                  {"instances", report.plan.count},
                  {"lower", report.plan.lower.label},
                  {"precision", std::string(info_of(report.plan.level).name)},
                  {"rounds", report.plan.rounds},
                  {"mesh_triangles", report.mesh_triangles},
                  {"mesh_bytes", report.mesh_bytes},
                  {"placement_bytes", report.placement_bytes},
                  {"ray_sets", sets},
                  {"rows", rows}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
