#include "bench/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "bench/contender.h"
#include "bench/growth.h"
#include "bench/help.h"
#include "bench/peers/peers.h"
#include "bench/stage.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

/// What an entry itself, or --set, says of its quality stays; a structure may have none.
void set_quality(AcceleratorSpec& spec, const std::string& quality) {
  constexpr std::string_view name = "quality";
  for (const AcceleratorInfo& info : accelerator_infos()) {
    if (info.name != spec.accelerator) continue;
    const auto has_choice = [&](const auto& option) { return option.name == name; };
    if (std::none_of(info.options.begin(), info.options.end(), has_choice)) return;
    auto& options = spec.settings.options;
    if (std::any_of(options.begin(), options.end(), has_choice)) return;
    options.push_back({std::string(name), quality});
  }
}

/// \throws UsageError where a run asks for what none of its contenders does.
void check_contenders(const Plan& plan) {
  std::vector<std::string> names, streams;
  for (const AcceleratorSpec& spec : plan.structures) {
    for (const Asking& asking : askings_of(plan, spec)) names.push_back(name_of(spec.label, asking));
  }
  if (plan.is_stream) {
    const auto is_stream = [](const std::string& name) { return name.ends_with(name_of("", {.is_stream = true})); };
    for (const AcceleratorInfo& info : accelerator_infos()) {
      if (info.can_stream) streams.emplace_back(info.name);
    }
    if (std::none_of(names.begin(), names.end(), is_stream)) {
      throw UsageError("--stream: no structure of this run takes many rays at once; these do: " + joined(streams));
    }
  }
  if (!plan.spoiled.empty() && std::find(names.begin(), names.end(), plan.spoiled) == names.end()) {
    throw UsageError("--self-check " + plan.spoiled + ": not in this run; expected one of " + joined(names));
  }
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

std::string peer_names() {
  std::string names = "all, none";
  for (const PeerInfo& info : peer_infos()) names += ", " + std::string(info.name);
  return names;
}

/// In their own order, the reference in front. "all" are those of this build, "none" is without a ratio.
std::vector<std::string> parse_peers(const std::vector<std::string>& names) {
  const auto is_named = [&](std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& name : names) {
    if (name == "all" || name == "none") continue;
    const auto infos = peer_infos();
    const auto info = std::find_if(infos.begin(), infos.end(), [&](const PeerInfo& i) { return i.name == name; });
    if (info == infos.end()) throw UsageError("unknown peer '" + name + "'; expected some of " + peer_names());
    if (!info->make) {
      throw UsageError("peer " + name + " is not in this build; install " + std::string(info->package) +
                       ", then configure anew");
    }
  }
  if (is_named("none")) {
    if (names.size() > 1) throw UsageError("--peer none stands alone");
    return {};
  }
  std::vector<std::string> peers;
  for (const PeerInfo& info : peer_infos()) {
    if (info.make && (info.name == reference_peer || is_named("all") || is_named(info.name)))
      peers.emplace_back(info.name);
  }
  return peers;
}

constexpr std::size_t short_run_rays = 30'000;

void make_quick(Plan& plan) {
  plan.rays = short_run_rays;
  plan.rounds = 5;
  plan.slot_seconds = 0.02;
  plan.ray_seconds = 0.8;
  plan.build_seconds = 0.8;
  plan.oracle_tests = 5e7;
  plan.few_tests = 5e6;
}

/// In words of its own: those of CLI11 call 1e5 out of a range that it is in.
CLI::Validator whole_number(std::size_t low, std::size_t high) {
  const std::string range = std::to_string(low) + " to " + std::to_string(high);
  const auto check = [=](const std::string& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_number = error == std::errc() && end == text.data() + text.size();
    if (is_number && number >= low && number <= high) return std::string();
    return "expected a whole number from " + range + ", found '" + text + "'";
  };
  return CLI::Validator(check, "");
}

/// \throws UsageError naming the first word that is no option, in the order of the command line.
[[noreturn]] void refuse_extras(std::vector<std::string> words) {
  const std::string& first = words.front();
  if (first.starts_with("-")) throw UsageError("unknown option " + first + "; --help lists them");
  throw UsageError("unexpected '" + first + "'; what is traced comes after --scene, structures after --accel");
}

/// Many scenes, each measured less: the sizes of one another's neighbours are what steadies the exponent.
void make_growing(Plan& plan, bool is_quick) {
  if (!is_growth_family(plan.growth)) {
    throw UsageError("--growth " + plan.growth + ": expected soup or terrain");
  }
  if (!plan.scenes.empty()) throw UsageError("--growth makes its own scenes; it does not go with --scene");
  plan.growth_limit = is_quick ? 30'000 : 300'000;
  plan.rays = is_quick ? 3'000 : 20'000;
  plan.rounds = is_quick ? 3 : 5;
  plan.slot_seconds = is_quick ? 0.005 : 0.02;
  plan.ray_seconds = is_quick ? 0.1 : 0.5;
  plan.build_seconds = is_quick ? 0.1 : 1;
  plan.oracle_tests = is_quick ? 1e7 : 5e7;
  plan.few_tests = is_quick ? 1e6 : 5e6;
}

}  // namespace

std::vector<Level> parse_triangle_levels(const std::vector<std::string>& names) {
  for (auto name = names.begin(); name != names.end(); ++name) {
    const auto is_named = [&](Level level) { return info_of(level).name == *name; };
    if (std::none_of(triangle_levels.begin(), triangle_levels.end(), is_named)) {
      throw UsageError("unknown level '" + *name + "'; expected fast, watertight, or fast,watertight for both");
    }
    if (std::find(names.begin(), name, *name) != name) throw UsageError("--precision names " + *name + " twice");
  }
  std::vector<Level> levels;
  for (const Level level : {Level::watertight, Level::fast}) {
    if (std::find(names.begin(), names.end(), info_of(level).name) != names.end()) levels.push_back(level);
  }
  return levels;
}

std::vector<AcceleratorSpec> parse_structures(const std::vector<std::string>& texts,
                                              const std::vector<std::string>& settings, const std::string& quality) {
  std::vector<AcceleratorSpec> structures;
  for (const std::string& text : texts) {
    for (AcceleratorSpec& spec : parse_accelerators(text)) structures.push_back(std::move(spec));
  }
  apply_settings(structures, settings);
  if (!quality.empty()) {
    if (std::find(quality_names.begin(), quality_names.end(), quality) == quality_names.end()) {
      throw UsageError("unknown quality '" + quality + "'; expected fast, balanced or best");
    }
    for (AcceleratorSpec& spec : structures) set_quality(spec, quality);
  }
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

CommandLine parse_command_line(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  CommandLine line;
  const auto separator = std::find(words.begin(), words.end(), "--");
  if (separator != words.end()) line.google_flags.assign(separator + 1, words.end());
  words.erase(separator, words.end());
  std::reverse(words.begin(), words.end());  // as CLI11 takes them

  Plan& plan = line.plan;
  CLI::App app{std::string(introduction()), "sightline-bench"};
  app.get_formatter()->column_width(30);
  std::vector<std::string> accelerators, settings, workloads, peers, levels;
  std::size_t growth_limit = plan.growth_limit;
  bool is_quick = false, is_list = false;
  std::string quality;
  std::size_t rays = plan.rays;
  int rounds = plan.rounds;
  std::string data_dir = SIGHTLINE_DATA_DIR;
  app.add_option("--scene", plan.scenes, "What is traced; repeatable (teapot, dragon:3 if fetched, sticks)")
      ->type_name("SPEC")
      ->allow_extra_args(false);
  app.add_option("--accel", accelerators, "Structures, by commas or repeated (all)")
      ->type_name("NAME[:OPTION=VALUE,...]")
      ->allow_extra_args(false);
  app.add_option("--set", settings, "An option of a structure; repeatable")
      ->type_name("ACCEL.OPTION=VALUE")
      ->allow_extra_args(false);
  app.add_option("--quality", quality, "Of every structure that has a choice: fast, balanced or best (balanced)")
      ->type_name("QUALITY");
  app.add_option("--precision", levels,
                 "How accurate our queries are: fast, watertight, or both side by side (watertight)")
      ->type_name("LEVELS")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_flag("--stream", plan.is_stream, "Beside single rays, hands all over together, where a structure can");
  app.add_option("--workload", workloads, "Some of build,primary,bounce,shadow (all)")
      ->type_name("NAMES")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--peer", peers, "Libraries beside ours, or all, none (embree,embree-robust)")
      ->type_name("NAMES")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--growth", plan.growth, "Instead of scenes: soup or terrain at growing sizes, and the exponents")
      ->type_name("FAMILY");
  auto* const limit_option =
      app.add_option("--growth-to", growth_limit, "Triangles to grow to, 3000 to 10000000 (300000; quick 30000)")
          ->type_name("N")
          ->check(whole_number(least_growth_limit, most_growth_limit));
  auto* const rays_option =
      app.add_option("--rays", rays,
                     "Rays of each kind, 1 to 100000000 (100000; quick or without scenes 30000; of sticks a tenth)")
          ->type_name("N")
          ->check(whole_number(1, 100'000'000));
  auto* const rounds_option =
      app.add_option("--rounds", rounds, "Rounds of timing everything once, 1 to 1000 (9; quick 5)")
          ->type_name("N")
          ->check(whole_number(1, 1000));
  app.add_option("--threads", plan.threads, "Threads to build with, ours and Embree, to 1024 (0: all)")
      ->type_name("N")
      ->check(whole_number(0, 1024));
  app.add_flag("--quick", is_quick, "Fewer rays and rounds: seconds instead of minutes");
  app.add_option("--json", line.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_option("--data", data_dir, "Folder of the scenes that are read from files")->type_name("DIR");
  app.add_option("--self-check", plan.spoiled, "Makes one hit of NAME wrong: the run has to refuse")->type_name("NAME");
  app.add_flag("--list", is_list, "Lists workloads, scenes, accelerators with their options, and peers");
  try {
    app.parse(words);
  } catch (const CLI::CallForHelp&) {
    line.help = app.help() + std::string(reading()) + catalogue();
    return line;
  } catch (const CLI::ExtrasError&) {
    refuse_extras(app.remaining());
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
  if (plan.scenes.empty()) {
    plan.rays = short_run_rays;
    plan.slot_seconds = 0.02;
    plan.ray_seconds = 2;
    plan.build_seconds = 3;
  }
  if (is_quick) make_quick(plan);
  if (!plan.growth.empty()) make_growing(plan, is_quick);
  if (limit_option->count() > 0) {
    if (plan.growth.empty()) throw UsageError("--growth-to goes with --growth");
    plan.growth_limit = growth_limit;
  }
  if (rays_option->count() > 0) {
    plan.rays = rays;
    plan.slow_scene.clear();
  }
  if (rounds_option->count() > 0) plan.rounds = rounds;
  plan.data_dir = data_dir;
  if (!levels.empty()) plan.levels = parse_triangle_levels(levels);
  if (!peers.empty()) plan.peers = parse_peers(peers);
  if (!workloads.empty()) plan.workloads = parse_workloads(workloads);
  if (accelerators.empty()) {
    for (const AcceleratorInfo& info : accelerator_infos()) accelerators.emplace_back(info.name);
  }
  try {
    plan.structures = parse_structures(accelerators, settings, quality);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  if (!plan.growth.empty() && !line.google_flags.empty()) throw UsageError("--growth takes no flags after --");
  check_contenders(plan);
  check_json(line.json);
  return line;
}

}  // namespace sightline::bench
