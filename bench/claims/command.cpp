#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/claims/rules.h"
#include "bench/claims/run.h"
#include "bench/command_line.h"
#include "bench/subcommand.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction_text =
    R"(Measures statements of the course about dividing space, solids and noise. Each has an
experiment and a rule, fixed before measuring, that makes a verdict of the figures.)";

constexpr std::string_view reading_text = R"(
Examples:
  sightline-bench claims --quick                           all of them, a first impression
  sightline-bench claims --claim kd_build,kd_search        two of them, all sizes
  sightline-bench claims --html out/claims.html            a page with charts
  sightline-bench claims --quick --json out/claims.json    everything that was measured

Reading:
  holds                 every figure of the rule is on its side of the limit
  holds with a limit    what the statement needs is so; the reason names where it ends
  does not hold         a figure that it needs is surely on the other side
  not resolved          an interval straddles its limit: more --rounds may tell

Exit code: 0, whatever the verdicts; 1 when hits differ or a file cannot be written;
2 when the command line is wrong.
)";

std::string list_text() {
  std::string text;
  for (const Claim& claim : claims()) {
    text += std::string(claim.name) + std::string(23 - claim.name.size(), ' ') + std::string(claim.statement) + '\n';
  }
  return text;
}

/// \throws UsageError. Returns what is to be printed, and nothing else done, when not empty.
std::string parse(int argc, const char* const* argv, ClaimsPlan& plan) {
  CLI::App app{std::string(introduction_text), "sightline-bench claims"};
  app.get_formatter()->column_width(30);
  std::vector<std::string> names;
  bool is_list = false;
  app.add_option("--claim", names, "What to measure (all)")
      ->type_name("NAMES")
      ->allow_extra_args(false);
  auto* const rounds = app.add_option("--rounds", plan.rounds, "Rounds of timing, 1 to 1000 (9; quick 7)")
                           ->type_name("N")
                           ->check(CLI::Range(1, 1000));
  app.add_option("--seed", plan.seed, "Of all that is drawn by chance (1)")->type_name("N")->check(whole_number(), "");
  app.add_option("--data", plan.data_dir, "The folder of scenes")->type_name("DIR");
  app.add_flag("--quick", plan.is_quick, "Smaller scenes, fewer rays and rounds: within a minute");
  app.add_option("--json", plan.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_option("--html", plan.html, "Writes a page that needs nothing else into FILE")->type_name("FILE");
  app.add_flag("--list", is_list, "What there is to measure");
  std::string help = parse_or_help(app, argc, argv, reading_text);
  if (!help.empty()) return help;
  if (is_list) return list_text();
  if (plan.is_quick && rounds->count() == 0) plan.rounds = 7;
  std::vector<std::string> known;
  for (const Claim& claim : claims()) known.emplace_back(claim.name);
  names = split_names(names);
  for (const std::string& name : names) require_known("claim", name, known);
  for (const Claim& claim : claims()) {
    if (names.empty() || std::ranges::find(names, claim.name) != names.end()) plan.claims.push_back(&claim);
  }
  if (plan.html == "-") throw UsageError("--html takes a file; standard output has the table");
  check_json(plan.html);
  return {};
}

}  // namespace

int run_claims_command(int argc, const char* const* argv) {
  ClaimsPlan plan;
  plan.data_dir = SIGHTLINE_DATA_DIR;
  const std::string help = parse(argc, argv, plan);
  TablePrinter tables;
  return run_command(help, plan, [&](Progress& progress) {
    const ClaimsReport report = run_claims(plan, progress, [&](const ClaimsReport& so_far, const ClaimReport& claim) {
      tables.show(so_far, claim_text(claim));
    });
    print('\n' + verdicts_text(report));
    if (!plan.html.empty()) write_text(plan.html, page_text(report));
    return report;
  });
}

}  // namespace sightline::bench
