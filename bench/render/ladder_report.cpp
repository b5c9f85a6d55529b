#include <nlohmann/json.hpp>

#include "bench/json.h"
#include "bench/render/ladder.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"
#include "sightline/render/ray_count.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Rays of one column.
struct RayKind {
  std::string_view name;
  std::uint64_t (*count)(const RenderCounters&);
};
constexpr RayKind ray_kinds[]{
    {"camera", [](const RenderCounters& c) { return c.camera_rays; }},
    {"to lamps", [](const RenderCounters& c) { return c[Effect::hard_shadow] + c[Effect::soft_shadow]; }},
    {"specular", [](const RenderCounters& c) { return c[Effect::mirror] + c[Effect::glossy] + c[Effect::refraction]; }},
    {"scattered", [](const RenderCounters& c) { return c[Effect::interreflection]; }},
    {"around", [](const RenderCounters& c) { return c[Effect::ambient_occlusion] + c[Effect::environment]; }},
};

std::string added_text(const RungReport& row, double nanoseconds) {
  if (!row.added) return "";
  return row.is_resolved() ? measured_text(scaled(*row.added, nanoseconds)) : "not resolved";
}

/// Of each ray or evaluation of the effect.
std::string each_text(const RungReport& row) {
  if (!row.is_resolved() || !row.rung.effect || row.counters[*row.rung.effect] == 0) return "";
  return measured_text(scaled(*row.added, 1e9 / static_cast<double>(row.counters[*row.rung.effect])), 2);
}

Json json_of(const RungReport& row, double pixels) {
  Json counts = Json::object(), adds = Json::array();
  counts["camera rays"] = static_cast<double>(row.counters.camera_rays) / pixels;
  for (std::size_t i = 0; i < effect_count; ++i) {
    const std::string name(effect_names[i]);
    if (row.counters.counts[i] > 0) counts[name] = static_cast<double>(row.counters.counts[i]) / pixels;
    if (row.rung.adds.has(static_cast<Effect>(i))) adds.push_back(name);
  }
  return {{"name", row.rung.name},
          {"over", row.rung.over.empty() ? Json() : Json(row.rung.over)},
          {"adds", adds},
          {"what", row.rung.what},
          {"samples", row.rung.samples},
          {"integrator", row.integrator},
          {"rays_per_pixel", static_cast<double>(rays_of(row.counters)) / pixels},
          {"counts_per_pixel", counts},
          {"seconds", bench::json_of(row.seconds)},
          {"time_over_below", bench::json_of(row.over)},
          {"seconds_added", bench::json_of(row.added)},
          {"resolved", row.over ? Json(row.is_resolved()) : Json()},
          {"round_seconds", json_of_rounds(row.round_seconds)}};
}

}  // namespace

std::string text_of(const LadderReport& report) {
  TextTable table;
  table.add_column("", "");
  table.add_column("", "on top of");
  for (const RayKind& kind : ray_kinds) table.add_column("rays a pixel", std::string(kind.name));
  table.add_column("ns a pixel", "all");
  table.add_column("ns a pixel", "added");
  table.add_column("time over that below", "times");
  table.add_column("time over that below", "interval");
  table.add_column("", "ns each");
  for (const RungReport& row : report.rungs) {
    std::vector<std::string> cells{row.rung.name, row.rung.over};
    for (const RayKind& kind : ray_kinds) {
      const auto count = static_cast<double>(kind.count(row.counters));
      cells.push_back(count == 0 ? "" : number_text(count / report.pixels(), 3));
    }
    const double nanoseconds = 1e9 / report.pixels();
    cells.push_back(row.seconds ? measured_text(scaled(*row.seconds, nanoseconds)) : "-");
    cells.push_back(added_text(row, nanoseconds));
    cells.push_back(row.over ? number_text(row.over->median, 4) : "");
    cells.push_back(row.over ? interval_text(*row.over, 4) : "");
    cells.push_back(each_text(row));
    table.add_row(std::move(cells));
  }
  std::string text = machine_text(report.machine) +
                     "\nEach effect beside the same scene without it: " + std::to_string(report.plan.width) + " x " +
                     std::to_string(report.plan.height) + " pixels, one thread's processor time, paired by round (" +
                     std::to_string(report.plan.rounds) +
                     ")\nspecular   mirrored, spread and refracted; around: to occluders and to the sky\n"
                     "added      to the time of the scene below; not resolved where the interval has 1 in it\n"
                     "ns each    added, for each ray or evaluation of the effect\n\n" +
                     table.text() + '\n';
  for (const RungReport& row : report.rungs)
    text += row.rung.name + ": " + row.rung.what + ", integrator \"" + row.integrator + "\"\n";
  return text;
}

std::string json_text(const LadderReport& report) {
  Json rungs = Json::array();
  for (const RungReport& row : report.rungs) rungs.push_back(json_of(row, report.pixels()));
  const Json json{{"machine", bench::json_of(report.machine)},
                  {"width", report.plan.width},
                  {"height", report.plan.height},
                  {"rounds", report.plan.rounds},
                  {"rungs", rungs}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
