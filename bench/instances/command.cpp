#include <CLI/CLI.hpp>
#include <stdexcept>

#include "bench/command_line.h"
#include "bench/instances/run.h"
#include "bench/subcommand.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction_text =
    R"(Measures two levels: many instances of one mesh under each structure, beside Embree's
instances. Hits are those of the flattened mesh, and verified before a time is shown.)";

constexpr std::string_view reading_text = R"(
Examples:
  sightline-bench instances --quick                          a first impression
  sightline-bench instances --accel wide-tree,kd-tree --lower bih
  sightline-bench instances --scene dragon:3 --count 10000 --json out/instances.json

Exit code: 0; 1 when a file cannot be read or written or hits are wrong; 2 when the
command line is.
)";

/// \throws UsageError. Returns what is to be printed, and nothing else done, when not empty.
std::string parse(int argc, const char* const* argv, InstancePlan& plan) {
  CLI::App app{std::string(introduction_text), "sightline-bench instances"};
  app.get_formatter()->column_width(34);
  std::vector<std::string> uppers, settings, levels;
  std::string lower = "box-tree";
  bool is_quick = false;
  plan.data_dir = SIGHTLINE_DATA_DIR;
  app.add_option("--scene", plan.scene, "The mesh, a scene's name or a file (teapot)")->type_name("SCENE");
  auto* const count = app.add_option("--count", plan.count, "Instances, 1 to 10,000,000 (1,000,000; quick 10,000)")
                          ->type_name("N")
                          ->check(CLI::Range(1, 10'000'000));
  app.add_option("--accel", uppers, "Structures over the instances, by commas or repeated (all but brute-force)")
      ->type_name("NAME[:OPTION=VALUE,...]")
      ->allow_extra_args(false);
  app.add_option("--set", settings, "An option of such a structure; may be repeated")
      ->type_name("ACCEL.OPTION=VALUE")
      ->allow_extra_args(false);
  app.add_option("--lower", lower, "The structure of the mesh (box-tree)")->type_name("NAME[:OPTION=VALUE,...]");
  app.add_option("--precision", levels, "fast or watertight (watertight)")->type_name("LEVEL")->delimiter(',');
  auto* const rays = app.add_option("--rays", plan.rays, "Of each set, 100 to 10,000,000 (20,000; quick 4000)")
                         ->type_name("N")
                         ->check(CLI::Range(100, 10'000'000));
  auto* const rounds =
      app.add_option("--rounds", plan.rounds, "Rounds of tracing everything once, 1 to 1000 (11; quick 3)")
          ->type_name("N")
          ->check(CLI::Range(1, 1000));
  app.add_flag("--quick", is_quick, "Fewer instances, rays and rounds");
  app.add_option("--json", plan.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_option("--data", plan.data_dir, "Folder of the scenes that are read from files")->type_name("DIR");
  app.add_option("--self-check", plan.spoiled, "Makes one hit of NAME wrong: the run has to refuse")->type_name("NAME");
  std::string help = parse_or_help(app, argc, argv, reading_text);
  if (!help.empty()) return help;
  if (is_quick && count->count() == 0) plan.count = 10'000;
  if (is_quick && rays->count() == 0) plan.rays = 4000;
  if (is_quick && rounds->count() == 0) plan.rounds = 3;
  if (uppers.empty()) {
    for (const AcceleratorInfo& info : accelerator_infos()) {
      if (info.name != "brute-force") uppers.emplace_back(info.name);
    }
  }
  if (!levels.empty()) {
    const std::vector<Level> parsed = parse_triangle_levels(levels);
    if (parsed.size() > 1) throw UsageError("--precision: expected one level");
    plan.level = parsed[0];
  }
  try {
    plan.uppers = parse_structures(uppers, settings);
    const auto lowers = parse_structures({lower}, {});
    if (lowers.size() != 1) throw UsageError("--lower: expected one structure");
    plan.lower = lowers[0];
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  if (!plan.spoiled.empty()) {
    std::vector<std::string> names;
    for (const AcceleratorSpec& spec : plan.uppers) names.push_back(spec.label);
    require_known("line", plan.spoiled, names);
  }
  return {};
}

}  // namespace

int run_instances_command(int argc, const char* const* argv) {
  InstancePlan plan;
  const std::string help = parse(argc, argv, plan);
  try {
    return run_and_print(help, plan, run_instances);
  } catch (const std::invalid_argument& error) {  // a scene of no such name
    throw UsageError(error.what());
  }
}

}  // namespace sightline::bench
