#include "bench/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "bench/contender.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction =
    R"(Measures every structure of the library beside Embree: how fast it is built, how
much memory it takes, and how fast it answers rays.

Every hit is verified before the first time is shown. Where one of our structures
is wrong in a single bit, the run names the ray and ends with exit code 1.
)";

constexpr std::string_view reading = R"(
How to read the table:
  build      Milliseconds from the mesh to a structure that is ready to be asked.
  memory     Bytes a triangle takes: nodes, leaf order, copies of triangles.
  Mrays/s    Million rays a second, one by one on one thread. More is better.
  (0.25x)    That speed over Embree's: a quarter of it. Taken round by round, as
             the median, so that a busy machine disturbs it little.
  nodes      Inner nodes and empty cells that a ray opens: the structure's part.
  candidates Triangles that a ray is tested against: what the structure leaves over.
  Digits     end where the measurement's uncertainty begins.

Examples:
  sightline-bench --quick                      a first impression
  sightline-bench --accel kd-tree,bih --scene dragon:3 --rounds 21
  sightline-bench --accel kd-tree --accel kd-tree:max_leaf_size=16
                                               one structure against itself
  sightline-bench --scene soup:100000 --workload build --threads 1
  sightline-bench --json out/bench.json        with all rounds, for other tools
  sightline-bench -- --benchmark_filter=bih    flags of Google Benchmark

Exit code: 0; 1 when a file cannot be read or written or hits are wrong; 2 when
the command line is.
)";

constexpr std::size_t width = 88;

std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string out, line;
  const auto flush = [&] { out += std::string(indent, ' ') + line + '\n'; };
  for (std::string word; words >> word;) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > width) {
      flush();
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) flush();
  return out;
}

std::string catalogue() {
  std::string text = "\nWorkloads:\n";
  for (const WorkloadInfo& info : workload_infos) {
    text += "  " + std::string(info.name) + '\n' + wrapped(std::string(info.description), 6);
  }
  text += "\nScenes (NAME or NAME:SIZE, or the path of an OBJ, PLY, STL, OFF or glTF file):\n";
  for (const SceneInfo& info : scene_infos()) {
    const std::string sizes = "Sizes " + std::to_string(info.lowest) + " to " + std::to_string(info.highest) +
                              ", normally " + std::to_string(info.default_size) + '.';
    text += "  " + std::string(info.name) + '\n' + wrapped(std::string(info.description), 6) + wrapped(sizes, 6);
  }
  text += "\nAccelerators and their options:\n";
  for (const AcceleratorInfo& info : accelerator_infos()) {
    text += "  " + std::string(info.name) + '\n' + wrapped(std::string(info.description), 6);
    for (const AcceleratorInfo::Option& option : info.options) {
      text += "      " + std::string(option.name) + " = " + option.default_value + "   (" + option.allowed + ")\n" +
              wrapped(std::string(option.help), 10);
    }
  }
  text += "\nPeers (always part of the run):\n";
  text += "  embree\n" + wrapped("Embree 3 as it comes: float tests that may leak between neighbours", 6);
  text += "  embree-robust\n" + wrapped("with RTC_SCENE_FLAG_ROBUST, as watertight as ours promise to be", 6);
  return text;
}

/// \throws std::invalid_argument
std::vector<AcceleratorSpec> parse_structures(const std::vector<std::string>& texts,
                                              const std::vector<std::string>& settings) {
  std::vector<AcceleratorSpec> structures;
  for (const std::string& text : texts) {
    for (AcceleratorSpec& spec : parse_accelerators(text)) structures.push_back(std::move(spec));
  }
  apply_settings(structures, settings);
  for (std::size_t i = 0; i < structures.size(); ++i) {
    check_accelerator(structures[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (structures[j].label == structures[i].label) {
        throw UsageError("--accel names " + structures[i].label + " twice");
      }
    }
  }
  return structures;
}

std::vector<Workload> parse_workloads(const std::vector<std::string>& names) {
  std::vector<Workload> workloads;
  for (const WorkloadInfo& info : workload_infos) {
    if (std::find(names.begin(), names.end(), info.name) != names.end()) workloads.push_back(info.workload);
  }
  for (const std::string& name : names) {
    const bool is_known = std::any_of(workload_infos.begin(), workload_infos.end(),
                                      [&](const WorkloadInfo& info) { return info.name == name; });
    if (!is_known) throw UsageError("unknown workload '" + name + "'; expected some of build, primary, bounce, shadow");
  }
  return workloads;
}

void make_quick(Plan& plan) {
  plan.rays = 30'000;
  plan.rounds = 5;
  plan.slot_seconds = 0.02;
  plan.ray_seconds = 0.8;
  plan.build_seconds = 0.8;
  plan.oracle_tests = 5e7;
  plan.brute_force_tests = 5e6;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  CommandLine line;
  const auto separator = std::find(words.begin(), words.end(), "--");
  if (separator != words.end()) line.google_flags.assign(separator + 1, words.end());
  words.erase(separator, words.end());
  std::reverse(words.begin(), words.end());  // as CLI11 takes them

  Plan& plan = line.plan;
  CLI::App app{std::string(introduction), "sightline-bench"};
  app.get_formatter()->column_width(30);
  std::vector<std::string> accelerators, settings, workloads;
  bool is_quick = false, is_list = false;
  std::size_t rays = plan.rays;
  int rounds = plan.rounds;
  std::string data_dir = SIGHTLINE_DATA_DIR;
  app.add_option("--scene", plan.scenes, "What is traced; repeatable (teapot; dragon:3 if fetched)")
      ->type_name("SPEC")
      ->allow_extra_args(false);
  app.add_option("--accel", accelerators, "Structures, by commas or repeated (all)")
      ->type_name("NAME[:OPTION=VALUE,...]")
      ->allow_extra_args(false);
  app.add_option("--set", settings, "An option of a structure; repeatable")
      ->type_name("ACCEL.OPTION=VALUE")
      ->allow_extra_args(false);
  app.add_option("--workload", workloads, "Some of build,primary,bounce,shadow (all)")
      ->type_name("NAMES")
      ->delimiter(',')
      ->allow_extra_args(false);
  auto* const rays_option = app.add_option("--rays", rays, "Rays of each kind, 1 to 100000000 (100000; quick 30000)")
                                ->type_name("N")
                                ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}).description(""));
  auto* const rounds_option =
      app.add_option("--rounds", rounds, "Rounds of timing everything once, 1 to 1000 (9; quick 5)")
          ->type_name("N")
          ->check(CLI::Range(1, 1000).description(""));
  app.add_option("--threads", plan.threads, "Threads to build with, ours and Embree, to 1024 (0: all)")
      ->type_name("N")
      ->check(CLI::Range(0, 1024).description(""));
  app.add_flag("--quick", is_quick, "Fewer rays and rounds: seconds instead of minutes");
  app.add_option("--json", line.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_option("--data", data_dir, "Folder of the scenes that are read from files")->type_name("DIR");
  app.add_option("--self-check", plan.spoiled, "Makes one hit of NAME wrong: the run has to refuse")->type_name("NAME");
  app.add_flag("--list", is_list, "Lists workloads, scenes, accelerators with their options, and peers");
  try {
    app.parse(words);
  } catch (const CLI::CallForHelp&) {
    line.help = app.help() + std::string(reading) + catalogue();
    return line;
  } catch (const CLI::ParseError& error) {
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    throw UsageError(text);
  }
  if (is_list) {
    line.help = catalogue().substr(1);
    return line;
  }

  for (auto scene = plan.scenes.begin(); scene != plan.scenes.end(); ++scene) {
    if (std::find(plan.scenes.begin(), scene, *scene) != scene) throw UsageError("--scene names " + *scene + " twice");
  }
  if (is_quick) make_quick(plan);
  if (rays_option->count() > 0) plan.rays = rays;
  if (rounds_option->count() > 0) plan.rounds = rounds;
  plan.data_dir = data_dir;
  if (!workloads.empty()) plan.workloads = parse_workloads(workloads);
  if (accelerators.empty()) {
    for (const AcceleratorInfo& info : accelerator_infos()) accelerators.emplace_back(info.name);
  }
  try {
    plan.structures = parse_structures(accelerators, settings);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  const auto is_spoiled = [&](const AcceleratorSpec& choice) { return choice.label == plan.spoiled; };
  if (!plan.spoiled.empty() && std::none_of(plan.structures.begin(), plan.structures.end(), is_spoiled)) {
    throw UsageError("--self-check " + plan.spoiled + ": no such structure in this run");
  }
  return line;
}

}  // namespace sightline::bench
