#include <nlohmann/json.hpp>

#include "bench/json.h"
#include "bench/solids/povray.h"
#include "bench/solids/run.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const SolidRow& row) {
  Json json{{"name", row.name},
            {"seconds", json_of(row.seconds)},
            {"elapsed_seconds", json_of(row.elapsed)},
            {"povray_time_over_this", json_of(row.ratio)},
            {"povray_elapsed_over_this", json_of(row.elapsed_ratio)},
            {"round_seconds", json_of_rounds(row.round_seconds)},
            {"round_elapsed_seconds", json_of_rounds(row.round_elapsed)}};
  if (!row.stats) return json;
  const PaintStats& stats = *row.stats;
  json["rays"] = stats.rays;
  json["nodes"] = stats.solids.nodes;
  json["pruned_nodes"] = stats.solids.pruned_nodes;
  json["primitives"] = stats.solids.primitives;
  json["transitions"] = stats.solids.transitions;
  return json;
}

Json json_of(const SolidSceneReport& scene) {
  Json rows = Json::array();
  for (const SolidRow& row : scene.rows) rows.push_back(json_of(row));
  Json difference;
  if (scene.from_povray) {
    difference = {{"coverage_pixels", scene.from_povray->coverage}, {"shade_pixels", scene.from_povray->shade}};
  }
  return {{"name", scene.name},
          {"description", scene.description},
          {"solids", scene.solids},
          {"pixels", scene.pixels},
          {"hit_share", scene.hit_share},
          {"accelerator", scene.accelerator},
          {"difference_from_povray", difference},
          {"rows", rows}};
}

std::string per_ray(std::uint64_t count, std::uint64_t rays) {
  return number_text(static_cast<double>(count) / static_cast<double>(rays), 3);
}

}  // namespace

std::string head_text(const SolidReport& report) {
  std::string text =
      machine_text(report.machine, report.povray_version.empty() ? "" : " beside POV-Ray " + report.povray_version);
  if (report.povray_version.empty()) {
    text += report.plan.has_povray ? "Without POV-Ray, which 'apt-get install povray' gets.\n" : "";
  } else {
    text +=
        "POV-Ray: " + std::string(povray_options) + " -F; the times of its tracing thread are those that it tells.\n";
  }
  return text +
         "\nns/pixel  one thread's processor time: a ray, its normal, a shadow ray, shading\n"
         "speed     POV-Ray's time over this one's, paired by round: of the processor, and on the wall\n"
         "per ray   nodes evaluated and pruned, primitives solved, transitions looked at\n";
}

std::string table_text(const SolidReport& report, const SolidSceneReport& scene) {
  TextTable table;
  table.add_column("", scene.name);
  table.add_column("time", "ns/pixel");
  table.add_column("time", "interval");
  if (scene.from_povray) {
    table.add_column("speed", "xPOV-Ray");
    table.add_column("speed", "interval");
    table.add_column("speed", "on the wall");
  }
  for (const char* name : {"nodes", "pruned", "primitives", "transitions"}) table.add_column("per ray", name);
  const double nanoseconds = 1'000'000'000 / static_cast<double>(scene.pixels);
  for (const SolidRow& row : scene.rows) {
    const auto time = row.seconds ? std::optional(scaled(*row.seconds, nanoseconds)) : std::nullopt;
    std::vector<std::string> cells{row.name, time ? measured_text(*time) : "-", time ? interval_text(*time, 3) : ""};
    if (scene.from_povray) {
      cells.push_back(row.ratio ? measured_text(*row.ratio) + 'x' : "");
      cells.push_back(row.ratio ? interval_text(*row.ratio, 3) : "");
      cells.push_back(row.elapsed_ratio ? measured_text(*row.elapsed_ratio, 2) + 'x' : "");
    }
    if (row.stats) {
      const SolidStats& solids = row.stats->solids;
      for (const std::uint64_t count : {solids.nodes, solids.pruned_nodes, solids.primitives, solids.transitions}) {
        cells.push_back(per_ray(count, row.stats->rays));
      }
    }
    table.add_row(std::move(cells));
  }
  const double rays = static_cast<double>(scene.rows.front().stats->rays) / static_cast<double>(scene.pixels);
  std::string text = scene.name + ": " + scene.description + ", " + std::to_string(report.plan.width) + " x " +
                     std::to_string(report.plan.height) + " pixels, " + number_text(100 * scene.hit_share, 2) +
                     " % covered, " + number_text(rays, 3) + " rays a pixel, " + plural(scene.solids, "solid") +
                     " in " + scene.accelerator + "\n\n" + table.text() + '\n';
  if (scene.from_povray) {
    text += "Pixels that POV-Ray sees otherwise: " + count_text(scene.from_povray->coverage) + " of coverage, " +
            count_text(scene.from_povray->shade) + " by more than 1/256 of shade.\n";
  }
  return text;
}

std::string growth_text(const SolidReport& report) {
  TextTable table;
  table.add_column("", "time against N spheres taken from a box");
  table.add_column("", "exponent");
  table.add_column("", "of one, ms");
  const auto growth = growth_of(report);
  if (growth.empty()) return {};
  for (const SolidGrowth& line : growth) {
    const std::string error = line.fit.standard_error ? " +- " + number_text(*line.fit.standard_error, 1) : "";
    table.add_row({line.name, number_text(line.fit.exponent, 2) + error, number_text(1000 * line.fit.factor, 3)});
  }
  return table.text();
}

std::string json_text(const SolidReport& report) {
  Json scenes = Json::array(), growth = Json::array();
  for (const SolidSceneReport& scene : report.scenes) scenes.push_back(json_of(scene));
  for (const SolidGrowth& line : growth_of(report)) {
    growth.push_back({{"name", line.name},
                      {"exponent", line.fit.exponent},
                      {"standard_error", line.fit.standard_error ? Json(*line.fit.standard_error) : Json(nullptr)},
                      {"seconds_of_one", line.fit.factor}});
  }
  const Json json{{"machine", json_of(report.machine)},
                  {"povray", report.povray_version.empty() ? Json(nullptr) : Json(report.povray_version)},
                  {"width", report.plan.width},
                  {"height", report.plan.height},
                  {"rounds", report.plan.rounds},
                  {"scenes", scenes},
                  {"growth", growth}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
