/// sightline-bench: the structures of the registry and Embree, timed side by side. See README.md.

#include <cstdio>
#include <exception>
#include <string_view>

#include "bench/bars.h"
#include "bench/claims/run.h"
#include "bench/command_line.h"
#include "bench/graph/run.h"
#include "bench/growth.h"
#include "bench/instances/run.h"
#include "bench/json.h"
#include "bench/moving/run.h"
#include "bench/noise/run.h"
#include "bench/render/run.h"
#include "bench/rounds.h"
#include "bench/solids/run.h"
#include "bench/subcommand.h"
#include "bench/summary.h"
#include "bench/table.h"
#include "bench/torus/run.h"
#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

struct NamedMesh {
  std::string name;
  std::shared_ptr<const TriangleMesh> mesh;
};

std::vector<NamedMesh> load_scenes(const Plan& plan, Progress& progress) {
  std::vector<NamedMesh> meshes;
  for (const std::string& scene : plan.scenes) {
    progress.say("loading " + scene);
    try {
      meshes.push_back({scene, load_scene(scene, plan.data_dir)});
    } catch (const std::invalid_argument& error) {
      throw UsageError(error.what());
    }
  }
  if (!meshes.empty()) return meshes;
  meshes.push_back({"teapot", load_scene("teapot", plan.data_dir)});
  try {
    meshes.push_back({"dragon:3", load_scene("dragon:3", plan.data_dir)});
  } catch (const FileError&) {
    std::fputs("sightline-bench: without the dragon, which data/fetch gets\n", stderr);
  }
  meshes.push_back({"sticks", load_scene("sticks", plan.data_dir)});
  return meshes;
}

int run(const CommandLine& line) {
  try {
    set_google_flags(line.google_flags);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }

  Progress progress;
  Report report{this_machine(), line.plan, {}};
  if (!line.plan.growth.empty()) {
    report.scenes = run_growth(line.plan, progress);
    print(head_text(report.machine, line.plan) + '\n' + growth_text(report.scenes, line.plan));
    if (!line.json.empty()) write_text(line.json, json_text(report, growth_of(report.scenes)));
    return 0;
  }
  const std::vector<NamedMesh> meshes = load_scenes(line.plan, progress);
  const Contenders contenders = make_contenders(line.plan);
  std::vector<Stage> stages;
  stages.reserve(meshes.size());
  for (const auto& [name, mesh] : meshes) stages.emplace_back(line.plan, name, mesh, contenders, progress);

  bool is_first = true;
  const std::size_t count = run_rounds(stages, line.plan, progress, [&](const SceneReport& scene) {
    if (is_first) print(head_text(report.machine, line.plan));
    is_first = false;
    print('\n' + table_text(scene, line.plan));
  });
  progress.clear();
  if (count == 0) return 0;  // Google Benchmark was asked to list only, or for nothing that there is
  for (const Stage& stage : stages) report.scenes.push_back(stage.report());
  if (report.scenes.size() > 1) print('\n' + summary_text(report.scenes, line.plan));
  const std::string bars = bars_text(report.scenes, line.plan);
  if (!bars.empty()) print('\n' + bars);
  if (line.json.empty()) return 0;
  write_text(line.json, json_text(report));
  return 0;
}

struct Subcommand {
  std::string_view name;
  int (*run)(int argc, const char* const* argv);
};
constexpr Subcommand subcommands[] = {{"solids", run_solids_command},       {"torus", run_torus_command},
                                      {"noise", run_noise_command},         {"graph", run_graph_command},
                                      {"instances", run_instances_command}, {"moving", run_moving_command},
                                      {"render", run_render_command},       {"claims", run_claims_command}};

}  // namespace
}  // namespace sightline::bench

int main(int argc, char** argv) {
  using namespace sightline::bench;
  try {
    for (const Subcommand& subcommand : subcommands) {
      if (argc > 1 && subcommand.name == argv[1]) return subcommand.run(argc - 1, argv + 1);
    }
    const CommandLine line = parse_command_line(argc, argv);
    if (!line.help.empty()) {
      print(line.help);
      return 0;
    }
    return run(line);
  } catch (const UsageError& error) {
    std::fprintf(stderr, "sightline-bench: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sightline-bench: %s\n", error.what());
    return 1;
  }
}
