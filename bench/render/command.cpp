#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/command_line.h"
#include "bench/render/instructions.h"
#include "bench/render/ladder.h"
#include "bench/render/pictures.h"
#include "bench/render/run.h"
#include "bench/render/scaling.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction_text =
    R"(Measures what rendering costs that simulates only what a scene calls for: beside a renderer
that was stripped by hand, beside the integrator that knows every effect, and beside POV-Ray
where that is installed (apt-get install povray). Or else:
  --ladder         what each effect costs, beside the same scene without it
  --threads 1,2    rays a second of whole pictures, and what more threads bring
  --instructions   those that rendering takes, as valgrind counts them

Pictures are verified before a time is shown: ours are the same to the last bit.)";

constexpr std::string_view reading_text = R"(
Examples:
  sightline-bench render --quick                   a first impression
  sightline-bench render --scene wood --textures point
  sightline-bench render --ladder --json out/ladder.json
  sightline-bench render --threads 1,2 --scene cornell --scene teapot:8
  sightline-bench render --instructions            of a build with SIGHTLINE_NATIVE=OFF

Exit code: 0; 1 when a file cannot be written, pictures are wrong, or valgrind does
not run; 2 when the command line is.
)";

/// What the command line asks for: one of the plans.
struct Asked {
  enum class What { lines, ladder, scaling, instructions } what = What::lines;
  RenderPlanOfBench lines;
  LadderPlan ladder;
  ScalingPlan scaling;
};

/// Options as they are given, for whichever plan.
struct Given {
  std::vector<std::string> scenes;
  std::vector<int> threads;
  std::string level, peer, textures = "filtered", only, json, spoiled;
  int rounds = 0;
  bool is_quick = false, is_ladder = false, counts_instructions = false;
};

template <class Plan>
void set_common(const Given& given, int quick_rounds, Plan& plan) {
  if (given.is_quick) plan.width /= 2, plan.height /= 2, plan.rounds = quick_rounds;
  if (given.rounds > 0) plan.rounds = given.rounds;
  if (!given.level.empty()) plan.level = parse_levels({given.level}).front();
  plan.json = given.json;
  plan.spoiled = given.spoiled;
}

/// Of the pictures beside a stripped renderer. \throws UsageError
RenderPlanOfBench lines_of(const Given& given) {
  RenderPlanOfBench plan;
  set_common(given, 5, plan);
  std::vector<std::string> known;
  for (const RenderPicture& picture : render_pictures()) known.push_back(picture.name);
  for (const std::string& scene : given.scenes) require_known("scene", scene, known);
  plan.scenes = given.scenes;
  plan.is_quick = given.is_quick;
  require_known("way of textures", given.textures, {"filtered", "point"});
  plan.filters_textures = given.textures == "filtered";
  if (!given.peer.empty()) require_known("peer", given.peer, {"povray", "none"});
  plan.has_povray = given.peer != "none";
  plan.only = given.only;
  const std::vector<std::string> lines{std::string(plan_line), std::string(again_line), std::string(stripped_line),
                                       std::string(anew_line), std::string(all_line)};
  if (!plan.only.empty()) require_known("line", plan.only, lines);
  if (!plan.spoiled.empty()) require_known("line", plan.spoiled, lines);
  return plan;
}

/// \throws UsageError
LadderPlan ladder_of(const Given& given) {
  LadderPlan plan;
  set_common(given, 5, plan);
  plan.data_dir = SIGHTLINE_DATA_DIR;
  std::vector<std::string> names;
  for (const Rung& rung : make_ladder(plan.data_dir)) names.push_back(rung.name);
  if (!plan.spoiled.empty()) require_known("rung", plan.spoiled, names);
  return plan;
}

/// \throws UsageError
ScalingPlan scaling_of(const Given& given) {
  ScalingPlan plan;
  set_common(given, 3, plan);
  plan.data_dir = SIGHTLINE_DATA_DIR;
  plan.scenes = given.scenes.empty() ? scaling_scenes() : given.scenes;
  std::vector<std::string> names;
  for (const int threads : given.threads) {
    if (threads < 1 || threads > most_threads()) {
      throw UsageError("--threads: expected numbers from 1 to " + std::to_string(most_threads()) +
                       ", as many as there are here, found " + std::to_string(threads));
    }
    if (std::find(plan.threads.begin(), plan.threads.end(), threads) != plan.threads.end())
      throw UsageError("--threads names " + std::to_string(threads) + " twice");
    plan.threads.push_back(threads);
    names.push_back(std::to_string(threads));
  }
  if (!plan.spoiled.empty()) require_known("number of threads", plan.spoiled, names);
  return plan;
}

/// \throws UsageError. Returns what is to be printed, and nothing else done, when not empty.
std::string parse(int argc, const char* const* argv, Asked& asked) {
  CLI::App app{std::string(introduction_text), "sightline-bench render"};
  app.get_formatter()->column_width(30);
  Given given;
  auto* const ladder = app.add_flag("--ladder", given.is_ladder, "What each effect costs");
  auto* const threads = app.add_option("--threads", given.threads,
                                       "Whole pictures by so many threads, the first compared with the others")
                            ->type_name("N[,N...]")
                            ->delimiter(',')
                            ->allow_extra_args(false);
  auto* const instructions = app.add_flag("--instructions", given.counts_instructions, "Instructions of rendering");
  auto* const scene = app.add_option("--scene", given.scenes,
                                     "Some of the scenes, repeatable (all): widget, wood; with --threads those of "
                                     "data/scenes, such as cornell, or any other (" +
                                         joined(scaling_scenes()) + ')')
                          ->type_name("NAME ...")
                          ->allow_extra_args(false);
  app.add_option("--precision", given.level, "The level of solids (watertight)")->type_name("LEVEL");
  auto* const textures =
      app.add_option("--textures", given.textures, "filtered as wide as a pixel, or at a point, as POV-Ray has them")
          ->type_name("HOW");
  auto* const peer =
      app.add_option("--peer", given.peer, "povray, or none (povray, where it is installed)")->type_name("NAME");
  auto* const rounds = app.add_option("--rounds", given.rounds,
                                      "Rounds of rendering everything once, 1 to 10,000 (201, quick 5; ladder 31, "
                                      "quick 5; threads 7, quick 3)")
                           ->type_name("N")
                           ->check(CLI::Range(1, 10'000));
  app.add_flag("--quick", given.is_quick, "Pictures of a quarter of the size, fewer rounds");
  auto* const only =
      app.add_option("--only", given.only, "Renders line NAME once, and nothing else")->type_name("NAME");
  app.add_option("--json", given.json, "Writes everything that was measured into FILE")->type_name("FILE");
  auto* const self_check =
      app.add_option("--self-check", given.spoiled, "Makes one pixel of line NAME wrong: the run has to refuse")
          ->type_name("NAME");
  ladder->excludes(threads, instructions, scene, textures, peer, only);
  threads->excludes(instructions, textures, peer, only);
  instructions->excludes(peer, only, rounds, self_check);
  std::string help = parse_or_help(app, argc, argv, reading_text);
  if (!help.empty()) return help;
  if (given.is_ladder) {
    asked.what = Asked::What::ladder;
    asked.ladder = ladder_of(given);
  } else if (threads->count() > 0) {
    asked.what = Asked::What::scaling;
    asked.scaling = scaling_of(given);
  } else {
    asked.what = given.counts_instructions ? Asked::What::instructions : Asked::What::lines;
    asked.lines = lines_of(given);
  }
  return {};
}

}  // namespace

int run_render_command(int argc, const char* const* argv) {
  Asked asked;
  const std::string help = parse(argc, argv, asked);
  if (asked.what == Asked::What::ladder) return run_and_print(help, asked.ladder, run_ladder);
  if (asked.what == Asked::What::scaling) {
    try {
      return run_and_print(help, asked.scaling, run_scaling);
    } catch (const std::invalid_argument& error) {  // a scene of no such name
      throw UsageError(error.what());
    }
  }
  if (asked.what == Asked::What::instructions) return run_and_print(help, asked.lines, count_instructions);
  TablePrinter tables;
  return run_command(help, asked.lines, [&](Progress& progress) {
    return run_render(asked.lines, progress, [&](const RenderBenchReport& so_far, const RenderPictureReport& picture) {
      tables.show(so_far, table_text(so_far, picture));
    });
  });
}

}  // namespace sightline::bench
