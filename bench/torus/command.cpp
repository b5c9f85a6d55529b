#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/command_line.h"
#include "bench/subcommand.h"
#include "bench/torus/run.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction_text =
    R"(Measures where lines meet a torus: all real roots at each level, beside Ferrari's closed
form in double, which most tracers take. Rays whose number of roots is wrong are counted.)";

constexpr std::string_view reading_text = R"(
Examples:
  sightline-bench torus --quick                    a first impression
  sightline-bench torus --minor 0.25 --precision exact --rounds 51

Exit code: 0; 1 when a file cannot be written or roots are wrong; 2 when the command
line is.
)";

/// \throws UsageError. Returns what is to be printed, and nothing else done, when not empty.
std::string parse(int argc, const char* const* argv, TorusPlan& plan) {
  CLI::App app{std::string(introduction_text), "sightline-bench torus"};
  app.get_formatter()->column_width(30);
  std::vector<std::string> levels;
  std::vector<double> minors;
  bool is_quick = false;
  app.add_option("--minor", minors, "Radii of the tube over the ring's, 0.0001 to 1 (0.5,0.005)")
      ->type_name("SHARES")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--precision", levels, "Levels side by side (fast,watertight,precise,exact)")
      ->type_name("LEVELS")
      ->delimiter(',')
      ->allow_extra_args(false);
  auto* const rays = app.add_option("--rays", plan.rays, "Of each set, 10 to 1,000,000 (20,000; quick 4000)")
                         ->type_name("N")
                         ->check(CLI::Range(10, 1'000'000));
  auto* const rounds =
      app.add_option("--rounds", plan.rounds, "Rounds of asking everything once, 1 to 1000 (21; quick 5)")
          ->type_name("N")
          ->check(CLI::Range(1, 1000));
  app.add_flag("--quick", is_quick, "Fewer rays and rounds");
  app.add_option("--json", plan.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_option("--self-check", plan.spoiled, "Makes line NAME lose a root: the run has to refuse")->type_name("NAME");
  std::string help = parse_or_help(app, argc, argv, reading_text);
  if (!help.empty()) return help;
  if (is_quick && rays->count() == 0) plan.rays = 4000;
  if (is_quick && rounds->count() == 0) plan.rounds = 5;
  for (const double minor : minors) {
    if (!(minor >= 0.0001 && minor <= 1))
      throw UsageError("--minor " + std::to_string(minor) + ": expected 0.0001 to 1");
  }
  if (!minors.empty()) plan.minors = minors;
  if (!levels.empty()) plan.levels = parse_levels(levels);
  if (!plan.spoiled.empty()) {
    std::vector<std::string> names;
    for (const Level level : plan.levels) {
      if (level == Level::precise || level == Level::exact) names.emplace_back(info_of(level).name);
    }
    require_known("line", plan.spoiled, names);
  }
  return {};
}

}  // namespace

int run_torus_command(int argc, const char* const* argv) {
  TorusPlan plan;
  const std::string help = parse(argc, argv, plan);
  TablePrinter tables;
  return run_command(help, plan, [&](Progress& progress) {
    return run_torus(plan, progress, [&](const TorusReport& so_far, const TorusReportPart& part) {
      tables.show(so_far, table_text(part));
    });
  });
}

}  // namespace sightline::bench
