#include <CLI/CLI.hpp>
#include <stdexcept>

#include "bench/command_line.h"
#include "bench/moving/run.h"
#include "bench/subcommand.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction_text =
    R"(Plays a scene that moves, the course's renderLevel with all levels turning, and measures the structure over
its spheres: refitted to where they stand, built anew, or whichever has been cheaper. All frames are
held against each other, hit by hit.)";

constexpr std::string_view reading_text = R"(
Examples:
  sightline-bench moving --quick                   a first impression
  sightline-bench moving --accel box-tree --levels 14 --json out/moving.json

Exit code: 0; 1 when a file cannot be written or pictures differ; 2 when the command line is.
)";

/// Those that can be refitted.
constexpr const char* default_uppers[] = {"box-tree", "wide-tree", "bih"};

/// \throws UsageError. Returns what is to be printed, and nothing else done, when not empty.
std::string parse(int argc, const char* const* argv, MovingPlan& plan) {
  CLI::App app{std::string(introduction_text), "sightline-bench moving"};
  app.get_formatter()->column_width(34);
  std::vector<std::string> uppers, settings;
  bool is_quick = false;
  auto* const levels = app.add_option("--levels", plan.levels, "2^N - 1 spheres, N from 2 to 16 (12; quick 8)")
                           ->type_name("N")
                           ->check(CLI::Range(2, 16));
  auto* const frames = app.add_option("--frames", plan.frames, "From 2 to 10,000 (200; quick 20)")
                           ->type_name("N")
                           ->check(CLI::Range(2, 10'000));
  app.add_option("--accel", uppers, "Structures over the spheres (those that can be refitted: box-tree,wide-tree,bih)")
      ->type_name("NAME[:OPTION=VALUE,...]")
      ->allow_extra_args(false);
  app.add_option("--set", settings, "An option of such a structure; may be repeated")
      ->type_name("ACCEL.OPTION=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--quick", is_quick, "Fewer spheres and frames");
  app.add_option("--json", plan.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_option("--self-check", plan.spoiled, "Makes one hit of NAME wrong: the run has to refuse")->type_name("NAME");
  std::string help = parse_or_help(app, argc, argv, reading_text);
  if (!help.empty()) return help;
  if (is_quick && levels->count() == 0) plan.levels = 8;
  if (is_quick && frames->count() == 0) plan.frames = 20;
  if (uppers.empty()) uppers.assign(std::begin(default_uppers), std::end(default_uppers));
  try {
    plan.uppers = parse_structures(uppers, settings);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  std::vector<std::string> names;
  for (const AcceleratorSpec& spec : plan.uppers) {
    require_known("structure that can be refitted", spec.accelerator,
                  {std::begin(default_uppers), std::end(default_uppers)});
    names.push_back(spec.label);
  }
  if (!plan.spoiled.empty()) require_known("line", plan.spoiled, names);
  return {};
}

}  // namespace

int run_moving_command(int argc, const char* const* argv) {
  MovingPlan plan;
  const std::string help = parse(argc, argv, plan);
  return run_and_print(help, plan, run_moving);
}

}  // namespace sightline::bench
