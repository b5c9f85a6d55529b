#include <nlohmann/json.hpp>

#include "bench/json.h"
#include "bench/render/run.h"
#include "bench/solids/povray.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const RenderPictureReport& picture) {
  Json rows = Json::array();
  for (const RenderRow& row : picture.rows) {
    rows.push_back({{"name", row.name},
                    {"seconds", json_of(row.seconds)},
                    {"time_over_plan", json_of(row.over_plan)},
                    {"povray_time_over_this", json_of(row.povray_over)},
                    {"povray_elapsed_over_this", json_of(row.povray_elapsed)},
                    {"round_seconds", json_of_rounds(row.round_seconds)}});
  }
  return {{"name", picture.name},
          {"description", picture.description},
          {"integrator", picture.integrator},
          {"pixels", picture.pixels},
          {"shadow_rays", picture.shadow_rays},
          {"differing_from_povray", picture.differing_from_povray ? Json(*picture.differing_from_povray) : Json()},
          {"rows", rows}};
}

}  // namespace

std::string head_text(const RenderBenchReport& report) {
  std::string text =
      machine_text(report.machine, report.povray_version.empty() ? "" : " beside POV-Ray " + report.povray_version);
  if (report.povray_version.empty() && report.plan.has_povray) {
    text += "Without POV-Ray, which 'apt-get install povray' gets.\n";
  } else if (!report.povray_version.empty()) {
    text +=
        "POV-Ray: " + std::string(povray_options) + " -F; the times of its tracing thread are those that it tells.\n";
  }
  return text +
         "\nns/pixel  one thread's processor time: a ray, its surface, a ray to the lamp\n"
         "time      over that of the plan, paired by round\n"
         "speed     POV-Ray's time over this one's, paired by round: of the processor, and on the wall\n";
}

std::string table_text(const RenderBenchReport& report, const RenderPictureReport& picture) {
  const bool has_povray = picture.differing_from_povray.has_value();
  TextTable table;
  table.add_column("", picture.name);
  table.add_column("", "ns/pixel");
  table.add_column("time", "over plan's");
  table.add_column("time", "interval");
  if (has_povray) {
    table.add_column("speed", "xPOV-Ray");
    table.add_column("speed", "interval");
    table.add_column("speed", "on the wall");
  }
  const double nanoseconds = 1'000'000'000 / static_cast<double>(picture.pixels);
  for (const RenderRow& row : picture.rows) {
    const bool is_ours = row.name != povray_line;
    std::vector<std::string> cells{row.name, row.seconds ? measured_text(scaled(*row.seconds, nanoseconds)) : "-",
                                   is_ours && row.over_plan ? number_text(row.over_plan->median, 4) : "",
                                   is_ours && row.over_plan ? interval_text(*row.over_plan, 4) : ""};
    if (has_povray) {
      cells.push_back(row.povray_over ? measured_text(*row.povray_over) + 'x' : "");
      cells.push_back(row.povray_over ? interval_text(*row.povray_over, 3) : "");
      cells.push_back(row.povray_elapsed ? measured_text(*row.povray_elapsed, 2) + 'x' : "");
    }
    table.add_row(std::move(cells));
  }
  std::string text = picture.name + ": " + picture.description + ", " + std::to_string(report.plan.width) + " x " +
                     std::to_string(report.plan.height) + " pixels, " +
                     number_text(static_cast<double>(picture.shadow_rays) / static_cast<double>(picture.pixels), 3) +
                     " rays to the lamp a pixel, integrator \"" + picture.integrator + "\"\n\n" + table.text();
  if (has_povray) {
    text += "\nPixels that POV-Ray sees otherwise: " + count_text(*picture.differing_from_povray) + ".\n";
  }
  return text;
}

std::string json_text(const RenderBenchReport& report) {
  Json pictures = Json::array();
  for (const RenderPictureReport& picture : report.pictures) pictures.push_back(json_of(picture));
  const Json json{{"machine", json_of(report.machine)},
                  {"povray", report.povray_version.empty() ? Json(nullptr) : Json(report.povray_version)},
                  {"width", report.plan.width},
                  {"height", report.plan.height},
                  {"rounds", report.plan.rounds},
                  {"pictures", pictures}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
