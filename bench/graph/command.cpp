#include <CLI/CLI.hpp>

#include "bench/command_line.h"
#include "bench/graph/run.h"
#include "bench/subcommand.h"

namespace sightline::bench {
namespace {

constexpr const char* introduction_text =
    R"(Measures scene graphs: cached places in the world beside products computed anew; boxes, spheres
and cylinders as bounds, what a test costs and how often it is in vain; and one change beside
all bounds anew, in graphs of up to 100,000 nodes.

Places, bounds and tests are verified before the first time is shown.
)";

constexpr const char* reading_text = R"(
Examples:
  sightline-bench graph --quick                    a first impression
  sightline-bench graph --rounds 31 --json out/graph.json

Exit code: 0; 1 when a file cannot be written or bounds are wrong; 2 when the command
line is.
)";

}  // namespace

int run_graph_command(int argc, const char* const* argv) {
  GraphPlan plan;
  CLI::App app{introduction_text, "sightline-bench graph"};
  app.get_formatter()->column_width(30);
  bool is_quick = false;
  auto* const rounds =
      app.add_option("--rounds", plan.rounds, "Rounds of timing everything once, 1 to 1000 (9; quick 3)")
          ->type_name("N")
          ->check(CLI::Range(1, 1000));
  app.add_flag("--quick", is_quick, "Smaller, shorter and fewer rounds");
  app.add_option("--json", plan.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_flag("--self-check", plan.is_spoiled, "Takes hits for misses: the run has to refuse");
  const std::string help = parse_or_help(app, argc, argv, reading_text);
  if (is_quick) {
    plan.depths = {1, 16, 256};
    plan.sizes = {1'000, 10'000};
    plan.slot_seconds = 0.002;
    if (rounds->count() == 0) plan.rounds = 3;
  }
  return run_and_print(help, plan, run_graph);
}

}  // namespace sightline::bench
