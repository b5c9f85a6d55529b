#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "bench/accuracy/run.h"
#include "bench/command_line.h"
#include "bench/subcommand.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction_text =
    R"(Measures every choice that trades accuracy for time: how far off it is, and what it takes.
Errors are taken against exact or very wide numbers, outside of the timing.)";

constexpr std::string_view reading_text = R"(
Examples:
  sightline-accuracy --quick                       all axes, a first impression
  sightline-accuracy --axis triangle,box           two of them
  sightline-accuracy --html out/accuracy.html      a page to look at

Exit code: 0; 1 when a file cannot be written; 2 when the command line is wrong.
)";

std::string list_text() {
  std::string text;
  for (const Axis& axis : accuracy_axes()) {
    text += std::string(axis.name) + std::string(15 - axis.name.size(), ' ') + std::string(axis.question) + '\n';
  }
  return text;
}

/// \throws UsageError. Returns what is to be printed, and nothing else done, when not empty.
std::string parse(int argc, const char* const* argv, AccuracyPlan& plan) {
  CLI::App app{std::string(introduction_text), "sightline-accuracy"};
  app.get_formatter()->column_width(30);
  std::vector<std::string> names;
  bool is_list = false;
  app.add_option("--axis", names, "What to measure (all)")->type_name("NAMES")->allow_extra_args(false);
  auto* const rounds = app.add_option("--rounds", plan.rounds, "Rounds of timing, 1 to 1000 (21; quick 9)")
                           ->type_name("N")
                           ->check(CLI::Range(1, 1000));
  app.add_option("--seed", plan.seed, "Of all that is drawn by chance (1)")->type_name("N")->check(whole_number(), "");
  app.add_option("--data", plan.data_dir, "The folder of scenes")->type_name("DIR");
  app.add_flag("--quick", plan.is_quick, "Fewer questions and rounds");
  app.add_option("--json", plan.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_option("--html", plan.html, "Writes a page that needs nothing else into FILE")->type_name("FILE");
  app.add_option("--charts", plan.charts, "Draws a chart of each front into DIR, as PNG and SVG")->type_name("DIR");
  app.add_flag("--list", is_list, "What there is to measure");
  std::string help = parse_or_help(app, argc, argv, reading_text);
  if (!help.empty()) return help;
  if (is_list) return list_text();
  if (plan.is_quick && rounds->count() == 0) plan.rounds = 9;
  if (plan.is_quick) plan.slot_seconds = 0.002;
  std::vector<std::string> known;
  for (const Axis& axis : accuracy_axes()) known.emplace_back(axis.name);
  names = split_names(names);
  for (const std::string& name : names) require_known("axis", name, known);
  for (const Axis& axis : accuracy_axes()) {
    if (names.empty() || std::ranges::find(names, axis.name) != names.end()) plan.axes.push_back(&axis);
  }
  return {};
}

/// Refuses now what could not be written at the end.
void require_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) throw std::runtime_error(folder + ": cannot be made a folder");
}

int run(int argc, const char* const* argv, const DrawCharts& draw) {
  AccuracyPlan plan;
  plan.data_dir = SIGHTLINE_DATA_DIR;
  const std::string help = parse(argc, argv, plan);
  if (!help.empty()) {
    print(help);
    return 0;
  }
  if (plan.html == "-") throw UsageError("--html takes a file; standard output has the table");
  if (!std::filesystem::is_directory(plan.data_dir)) {
    throw std::runtime_error(plan.data_dir + ": expected a folder of scenes, found " +
                             (std::filesystem::exists(plan.data_dir) ? "a file" : "nothing"));
  }
  if (!plan.charts.empty() && !draw) throw UsageError("--charts: this build draws none");
  check_json(plan.json);
  check_json(plan.html);
  if (!plan.charts.empty()) require_folder(plan.charts);
  Progress progress;
  TablePrinter tables;
  const AccuracyReport report = run_accuracy(plan, progress, [&](const AccuracyReport& so_far, const AxisReport& axis) {
    tables.show(so_far, table_text(axis));
  });
  if (!plan.json.empty()) write_text(plan.json, json_text(report));
  if (!plan.html.empty()) write_text(plan.html, page_text(report));
  if (!plan.charts.empty()) draw(report, plan.charts);
  return 0;
}

}  // namespace

int run_accuracy_command(int argc, const char* const* argv, const DrawCharts& draw) {
  try {
    return run(argc, argv, draw);
  } catch (const UsageError& error) {
    std::fprintf(stderr, "sightline-accuracy: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sightline-accuracy: %s\n", error.what());
    return 1;
  }
}

}  // namespace sightline::bench
