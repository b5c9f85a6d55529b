#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "bench/command_line.h"
#include "bench/solids/run.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"
#include "sightline/query/tracer.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction_text =
    R"(Measures solids: how long pictures of a widget, of 64 widgets, and of a box less 1 to
256 spheres take, beside POV-Ray where that is installed (apt-get install povray).

Pictures are verified before the first time is shown: all levels and lines against
brute force without any switch, and POV-Ray's against ours, pixel by pixel.
)";

constexpr std::string_view reading_text = R"(
Examples:
  sightline-bench solids --quick                   a first impression
  sightline-bench solids --precision fast,watertight,precise,exact
  sightline-bench solids --ablation --scene widget what each switch spares
  sightline-bench solids --accel kd-tree --set solid.index_from=64

Exit code: 0; 1 when a file cannot be written or pictures are wrong; 2 when the
command line is.
)";

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const SolidScene& scene : solid_scenes(4, 3)) names.push_back(scene.name);
  return names;
}

std::string option_list() {
  std::string text = "\nOptions of solids, for --set:\n";
  for (const auto& field : SolidOptions::fields()) {
    text += "  solid." + std::string(field.name) + "\n      " + std::string(field.help) + '\n';
  }
  return text;
}

void apply_setting(SolidOptions& options, const std::string& text) {
  constexpr std::string_view prefix = "solid.";
  const std::size_t sign = text.find('=');
  if (!text.starts_with(prefix) || sign == std::string::npos)
    throw UsageError("--set " + text + ": expected solid.OPTION=VALUE");
  set_option("solid", options, text.substr(prefix.size(), sign - prefix.size()), text.substr(sign + 1));
}

/// \throws UsageError, std::invalid_argument. Returns what is to be printed, and nothing else done, when not empty.
std::string parse(int argc, const char* const* argv, SolidPlan& plan) {
  CLI::App app{std::string(introduction_text), "sightline-bench solids"};
  app.get_formatter()->column_width(30);
  std::vector<std::string> levels, settings;
  std::string peer = "povray";
  bool is_quick = false;
  app.add_option("--scene", plan.scenes, "Some of the scenes, repeatable (all): " + joined(scene_names()))
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--precision", levels, "Levels side by side: fast, watertight, precise, exact (watertight)")
      ->type_name("LEVELS")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_flag("--single", plan.has_single, "Beside them, rays one by one instead of in packets");
  app.add_flag("--ablation", plan.is_ablation, "Beside them, each switch of solids off in turn, and all");
  app.add_option("--set", settings, "An option of solids; repeatable")
      ->type_name("solid.OPTION=VALUE")
      ->allow_extra_args(false);
  app.add_option("--accel", plan.accelerator,
                 "Structure over solids and operands (bih over solids, box-tree over operands)")
      ->type_name("NAME");
  app.add_option("--peer", peer, "povray, or none (povray, where it is installed)")->type_name("NAME");
  auto* const rounds =
      app.add_option("--rounds", plan.rounds, "Rounds of painting everything once, 1 to 1000 (9; quick 3)")
          ->type_name("N")
          ->check(CLI::Range(1, 1000));
  app.add_flag("--quick", is_quick, "Pictures of a quarter of the size, fewer rounds");
  app.add_option("--json", plan.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_option("--self-check", plan.spoiled, "Makes one pixel of line NAME wrong: the run has to refuse")
      ->type_name("NAME");
  std::string help = parse_or_help(app, argc, argv, option_list() + std::string(reading_text));
  if (!help.empty()) return help;
  if (is_quick) {
    plan.width /= 2, plan.height /= 2;
    if (rounds->count() == 0) plan.rounds = 3;
    plan.row_seconds = 2;
    plan.reference_step = 32;
  }
  for (const std::string& name : plan.scenes) require_known("scene", name, scene_names());
  require_known("peer", peer, {"povray", "none"});
  plan.has_povray = peer == "povray";
  if (!plan.accelerator.empty()) {
    std::vector<std::string> names;
    for (const AcceleratorInfo& info : accelerator_infos()) names.emplace_back(info.name);
    require_known("accelerator", plan.accelerator, names);
  }
  if (!levels.empty()) plan.levels = parse_levels(levels);
  try {
    for (const std::string& text : settings) apply_setting(plan.options, text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  if (!plan.spoiled.empty()) {
    std::vector<std::string> names;
    for (const SolidAsking& asking : askings_of(plan)) names.push_back(asking.name);
    require_known("line", plan.spoiled, names);
  }
  return {};
}

}  // namespace

int run_solids_command(int argc, const char* const* argv) {
  SolidPlan plan;
  const std::string help = parse(argc, argv, plan);
  TablePrinter tables;
  return run_command(help, plan, [&](Progress& progress) {
    SolidReport report = run_solids(plan, progress, [&](const SolidReport& so_far, const SolidSceneReport& scene) {
      tables.show(so_far, table_text(so_far, scene));
    });
    const std::string growth = growth_text(report);
    if (!growth.empty()) print('\n' + growth);
    return report;
  });
}

}  // namespace sightline::bench
