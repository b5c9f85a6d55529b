#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/command_line.h"
#include "bench/noise/run.h"
#include "bench/peers/noise_peers.h"
#include "bench/subcommand.h"

namespace sightline::bench {
namespace {

constexpr const char* introduction_text =
    R"(Measures noise: nanoseconds a point, at random points and at those of a grid, one by one
and in batches, float and double, beside libnoise and stb_perlin where this build has
them. Then octaves, gradients against differences, and what float loses.

Values are verified before the first time is shown: batches bit for bit against single
points, and improved noise against its reference.
)";

constexpr const char* reading_text = R"(
Examples:
  sightline-bench noise --quick                    a first impression
  sightline-bench noise --rounds 51 --json out/noise.json

Exit code: 0; 1 when a file cannot be written or values are wrong; 2 when the command
line is.
)";

}  // namespace

int run_noise_command(int argc, const char* const* argv) {
  NoisePlan plan;
  CLI::App app{introduction_text, "sightline-bench noise"};
  app.get_formatter()->column_width(30);
  bool is_quick = false;
  auto* const rounds =
      app.add_option("--rounds", plan.rounds, "Rounds of timing everything once, 1 to 1000 (21; quick 5)")
          ->type_name("N")
          ->check(CLI::Range(1, 1000));
  app.add_flag("--quick", is_quick, "Shorter and fewer rounds");
  app.add_option("--json", plan.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_flag("--self-check", plan.is_spoiled, "Makes one value of a batch wrong: the run has to refuse");
  std::string peers = "\nPeers:\n";
  for (const NoisePeer& peer : noise_peers()) {
    peers += "  " + std::string(peer.name) + ": " + std::string(peer.description) +
             (peer.values ? "" : " (not in this build; install " + std::string(peer.package) + ')') + '\n';
  }
  const std::string help = parse_or_help(app, argc, argv, peers + std::string(reading_text));
  if (is_quick) {
    plan.slot_seconds = 0.001;
    if (rounds->count() == 0) plan.rounds = 5;
  }
  return run_and_print(help, plan, run_noise);
}

}  // namespace sightline::bench
