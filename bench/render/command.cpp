#include <CLI/CLI.hpp>

#include "bench/command_line.h"
#include "bench/render/pictures.h"
#include "bench/render/run.h"
#include "bench/solids/povray.h"
#include "bench/subcommand.h"
#include "sightline/io/output_file.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction_text =
    R"(Measures what rendering costs that simulates only what a scene calls for: beside a renderer
that was stripped by hand, beside the integrator that knows every effect, and beside POV-Ray
where that is installed (apt-get install povray).

Pictures are verified before a time is shown: ours are the same to the last bit.)";

constexpr std::string_view reading_text = R"(
Examples:
  sightline-bench render --quick                   a first impression
  sightline-bench render --scene wood --textures point
  valgrind --tool=callgrind build/bin/sightline-bench render --scene widget --only stripped
                                                   how many instructions (SIGHTLINE_NATIVE=OFF)

Exit code: 0; 1 when a file cannot be written or pictures are wrong; 2 when the
command line is.
)";

/// \throws UsageError. Returns what is to be printed, and nothing else done, when not empty.
std::string parse(int argc, const char* const* argv, RenderPlanOfBench& plan) {
  CLI::App app{std::string(introduction_text), "sightline-bench render"};
  app.get_formatter()->column_width(30);
  std::vector<std::string> known;
  for (const RenderPicture& picture : render_pictures()) known.push_back(picture.name);
  std::string level, peer, textures = "filtered";
  bool is_quick = false;
  app.add_option("--scene", plan.scenes, "Some of the scenes, repeatable (all): widget, wood")
      ->type_name("NAME ...")
      ->allow_extra_args(false);
  app.add_option("--precision", level, "The level of solids (watertight)")->type_name("LEVEL");
  app.add_option("--textures", textures, "filtered as wide as a pixel, or at a point, as POV-Ray has them (filtered)")
      ->type_name("HOW");
  app.add_option("--peer", peer, "povray, or none (povray, where it is installed)")->type_name("NAME");
  auto* const rounds =
      app.add_option("--rounds", plan.rounds, "Rounds of rendering everything once, 1 to 10,000 (201; quick 5)")
          ->type_name("N")
          ->check(CLI::Range(1, 10'000));
  app.add_flag("--quick", is_quick, "Pictures of a quarter of the size, fewer rounds");
  app.add_option("--only", plan.only, "Renders line NAME once, and nothing else")->type_name("NAME");
  app.add_option("--json", plan.json, "Writes everything that was measured into FILE")->type_name("FILE");
  app.add_option("--self-check", plan.spoiled, "Makes one pixel of line NAME wrong: the run has to refuse")
      ->type_name("NAME");
  std::string help = parse_or_help(app, argc, argv, reading_text);
  if (!help.empty()) return help;
  if (is_quick) plan.width = 400, plan.height = 300;
  if (is_quick && rounds->count() == 0) plan.rounds = 5;
  for (const std::string& scene : plan.scenes) require_known("scene", scene, known);
  if (!level.empty()) plan.level = parse_levels({level}).front();
  require_known("way of textures", textures, {"filtered", "point"});
  plan.filters_textures = textures == "filtered";
  if (!peer.empty()) require_known("peer", peer, {"povray", "none"});
  plan.has_povray = peer != "none";
  const std::vector<std::string> lines{std::string(plan_line), std::string(again_line), std::string(stripped_line),
                                       std::string(anew_line), std::string(all_line)};
  if (!plan.only.empty()) require_known("line", plan.only, lines);
  if (!plan.spoiled.empty()) require_known("line", plan.spoiled, lines);
  return {};
}

}  // namespace

int run_render_command(int argc, const char* const* argv) {
  RenderPlanOfBench plan;
  const std::string help = parse(argc, argv, plan);
  if (!help.empty()) {
    print(help);
    return 0;
  }
  check_json(plan.json);
  Progress progress;
  bool is_first = true;
  const RenderBenchReport report =
      run_render(plan, progress, [&](const RenderBenchReport& so_far, const RenderPictureReport& picture) {
        if (is_first) print(head_text(so_far));
        is_first = false;
        print('\n' + table_text(so_far, picture));
      });
  if (!plan.json.empty()) write_text(plan.json, json_text(report));
  return 0;
}

}  // namespace sightline::bench
