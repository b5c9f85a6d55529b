#include <nlohmann/json.hpp>

#include "bench/json.h"
#include "bench/render/scaling.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Of a time: more is faster, so its limits change places.
Estimate per(double amount, const Estimate& seconds) {
  return {amount / seconds.median, amount / seconds.high, amount / seconds.low, seconds.confidence};
}

std::optional<Estimate> rays_per_second(const ScalingSceneReport& scene, const ThreadsRow& row) {
  if (!row.seconds) return std::nullopt;
  return per(static_cast<double>(scene.rays), *row.seconds);
}

/// The speed-up beside that of as many more threads.
std::optional<Estimate> efficiency(const ScalingSceneReport& scene, const ThreadsRow& row) {
  if (!row.speed_up) return std::nullopt;
  return scaled(*row.speed_up, static_cast<double>(scene.rows.front().threads) / row.threads);
}

Json json_of(const ScalingSceneReport& scene) {
  Json rows = Json::array();
  for (const ThreadsRow& row : scene.rows) {
    rows.push_back({{"threads", row.threads},
                    {"seconds", bench::json_of(row.seconds)},
                    {"rays_per_second", bench::json_of(rays_per_second(scene, row))},
                    {"speed_up", bench::json_of(row.speed_up)},
                    {"efficiency", bench::json_of(efficiency(scene, row))},
                    {"round_seconds", json_of_rounds(row.round_seconds)}});
  }
  return {{"name", scene.name},
          {"integrator", scene.integrator},
          {"build_seconds", scene.build_seconds},
          {"rays", scene.rays},
          {"rows", rows}};
}

}  // namespace

std::string text_of(const ScalingReport& report) {
  TextTable table;
  table.add_column("", "");
  table.add_column("", "integrator");
  table.add_column("", "build s");
  table.add_column("", "rays a pixel");
  table.add_column("", "threads");
  table.add_column("", "seconds");
  table.add_column("", "million rays/s");
  const std::string first = "over " + plural(static_cast<std::size_t>(report.plan.threads.front()), "thread");
  table.add_column(first, "speed-up");
  table.add_column(first, "interval");
  table.add_column(first, "efficiency");
  const double pixels = static_cast<double>(report.plan.width) * report.plan.height;
  for (const ScalingSceneReport& scene : report.scenes) {
    for (const ThreadsRow& row : scene.rows) {
      const bool is_first = &row == &scene.rows.front();
      std::vector<std::string> cells(4);
      if (is_first) {
        cells = {scene.name, scene.integrator, number_text(scene.build_seconds, 2),
                 number_text(static_cast<double>(scene.rays) / pixels, 3)};
      }
      cells.push_back(std::to_string(row.threads));
      cells.push_back(row.seconds ? measured_text(*row.seconds) : "-");
      const auto rate = rays_per_second(scene, row);
      cells.push_back(rate ? measured_text(scaled(*rate, 1e-6)) : "-");
      if (!is_first && row.speed_up) {
        cells.push_back(measured_text(*row.speed_up));
        cells.push_back(interval_text(*row.speed_up, 3));
        cells.push_back(measured_text(*efficiency(scene, row)));
      }
      table.add_row(std::move(cells));
    }
  }
  return machine_text(report.machine) + "\nWhole pictures of " + std::to_string(report.plan.width) + " x " +
         std::to_string(report.plan.height) + " pixels, " + std::to_string(report.plan.samples) +
         " samples of each, by the clock on the wall, from a blank film to the exposed one;\nthe same bits for any " +
         "number of threads. Median of " + std::to_string(report.plan.rounds) + " rounds, speeds paired by round.\n\n" +
         table.text();
}

std::string json_text(const ScalingReport& report) {
  Json scenes = Json::array();
  for (const ScalingSceneReport& scene : report.scenes) scenes.push_back(json_of(scene));
  const Json json{{"machine", bench::json_of(report.machine)},
                  {"width", report.plan.width},
                  {"height", report.plan.height},
                  {"samples", report.plan.samples},
                  {"rounds", report.plan.rounds},
                  {"scenes", scenes}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
