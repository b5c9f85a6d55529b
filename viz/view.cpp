/// sightline-view: how a structure divides a scene, as a window, a picture or data.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "sightline/scene/scenes.h"
#include "viz/build/build_command.h"
#include "viz/compare/compare_command.h"
#include "viz/csg_command.h"
#include "viz/drawing/drawing_command.h"
#include "viz/graph/graph_command.h"
#include "viz/noise/noise_command.h"
#include "viz/pages/window_command.h"
#include "viz/partition_command.h"
#include "viz/picture_command.h"
#include "viz/run_tool.h"
#include "viz/texture/texture_commands.h"
#include "viz/walk/walk_command.h"
#include "viz/web/page_command.h"

namespace sightline::viz {
namespace {

constexpr const char* about =
    R"(Draws how a structure divides space, what a ray makes of a solid, how a scene hangs together, and what noise and
textures are made of.

Examples
  sightline-view list
  sightline-view
      opens one window whose pages are partitions, walk, build, heat, compare, csg, noise and graph: see window --help
  sightline-view --scene dragon:3 --accel bih --page walk --out walk.png
      a page's picture; needs no display
  sightline-view partitions
      opens a window on the teapot's kd-tree: drag to turn, wheel to come closer, Up and Down for the depth
  sightline-view partitions --accel kd-tree --scene dragon:3 --out kd.png
      writes a picture; needs no display
  sightline-view partitions --accel box-tree --scene dragon:3 --depth 5:7 --out boxes.png
      only the boxes of the depths 5, 6 and 7
  sightline-view partitions --accel bsp-tree --scene teapot --slice z=0.5 --out cut.png
      the cells that the middle plane cuts, and their sections
  sightline-view partitions --accel kd-tree --scene teapot --leaves --set kd-tree.max_leaf_size=16 --out leaves.vtp
      the leaves of a coarser tree as data, for ParaView
  sightline-view compare --out walks.png
      structures side by side on the same ray: see compare --help
  sightline-view walk --accel box-tree --scene teapot --out walk.png
      a ray's way through a structure, step by step: see walk --help
  sightline-view csg --solid widget --out widget.png
      a ray's interval ladder through a solid: see csg --help
  sightline-view build --accel kd-tree --scene teapot --step 3 --out step.png
      what a builder weighed at a node, and what it took: see build --help
  sightline-view graph --scene levels:4 --select left/left --drag=-0.9,0.7,0 --out bubble.png
      a scene's tree, and an event that bubbles up in it: see graph --help
  sightline-view noise --kind perlin --out noise.png
      noise from its lattice to its spectrum: see noise --help
  sightline-view wood --tune --out tuning.png
      the course's wood, and what its knobs do: see wood --help
  sightline-view normals --out normals.png
      dents that are seen and are not there: see normals --help
  sightline-view page --accel kd-tree,bih --html page.html
      cells, walks and charts as a page for any browser: see page --help

Exit status: 0 done, 1 failure, 2 wrong usage.)";

const std::string subcommand_names =
    "window, partitions, walk, build, heat, compare, csg, graph, noise, wood, normals, page, picture or list";

int list() {
  std::cout << "accelerators\n";
  for (const AcceleratorInfo& info : accelerator_infos()) {
    std::printf("  %-15s %s\n", std::string(info.name).c_str(), std::string(info.description).c_str());
    for (const auto& option : info.options) {
      std::printf("      --set %s.%s=%s: %s (%s)\n", std::string(info.name).c_str(), std::string(option.name).c_str(),
                  option.default_value.c_str(), std::string(option.help).c_str(), option.allowed.c_str());
    }
  }
  std::printf("scenes\n");
  for (const SceneInfo& info : scene_infos()) {
    std::printf("  %-15s %s\n", (std::string(info.name) + ":" + std::to_string(info.default_size)).c_str(),
                std::string(info.description).c_str());
  }
  std::printf("  %-15s %s\n", "FILE", "a mesh: OBJ, PLY, STL, OFF or glTF");
  return success;
}

/// Without a subcommand, all pages in one window.
std::vector<std::string> with_subcommand(std::vector<std::string> words) {
  auto at = words.begin();
  while (at != words.end() && (*at == "--data" || at->starts_with("--data="))) {
    at += *at == "--data" && at + 1 != words.end() ? 2 : 1;
  }
  const bool is_help = at != words.end() && (*at == "--help" || *at == "-h" || *at == "--list");
  if (!is_help && (at == words.end() || at->starts_with('-'))) words.insert(at, "window");
  return words;
}

}  // namespace

int run_view(const std::vector<std::string>& given, const std::string& data_folder, WindowFrame* frame) {
  const std::vector<std::string> words = with_subcommand(given);
  CLI::App app(about, "sightline-view");
  app.require_subcommand(0, 1);
  bool is_list = false;
  std::string data = data_folder;
  app.add_flag("--list", is_list, "The same as `list`");
  app.add_option("--data", data, "Folder of scene data")->option_text("DIR");
  CLI::App* listing = app.add_subcommand("list", "The accelerators with their options, and the scenes");
  WindowCommand window(app, data, [&](const std::vector<std::string>& page, WindowFrame* shown) {
    return run_view(page, data_folder, shown);
  });
  PartitionCommand partitions(app, data);
  CompareCommand compare(app, data);
  WalkCommand walk(app, data);
  BuildCommand build(app, data);
  CompareCommand heat(app, data, true);
  CsgCommand csg(app);
  GraphCommand graph(app, data);
  NoiseCommand noise(app);
  WoodCommand wood(app);
  NormalsCommand normals(app);
  PageCommand page(app, data);
  PictureCommand picture(app);
  DrawingCommand drawing(app);
  listing->fallthrough();
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // it takes them from the back
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    const std::string first = words.empty() ? "-" : words.front();
    const auto subcommands = app.get_subcommands([](const CLI::App*) { return true; });
    const bool is_known = std::any_of(subcommands.begin(), subcommands.end(),
                                      [&](const CLI::App* subcommand) { return subcommand->get_name() == first; });
    if (first[0] != '-' && !is_known) {
      throw UsageError("unknown subcommand '" + first + "'; expected " + subcommand_names + " (see --help)");
    }
    throw UsageError(std::string(error.what()) + " (see --help)");
  }
  if (is_list || listing->parsed()) return list();
  if (window.is_chosen()) return window.run();
  if (partitions.is_chosen()) return partitions.run(frame);
  if (compare.is_chosen()) return compare.run(frame);
  if (heat.is_chosen()) return heat.run(frame);
  if (walk.is_chosen()) return walk.run(frame);
  if (build.is_chosen()) return build.run(frame);
  if (csg.is_chosen()) return csg.run(frame);
  if (graph.is_chosen()) return graph.run(frame);
  if (noise.is_chosen()) return noise.run(frame);
  if (wood.is_chosen()) return wood.run();
  if (normals.is_chosen()) return normals.run();
  if (page.is_chosen()) return page.run();
  if (picture.is_chosen()) return picture.run();
  if (drawing.is_chosen()) return drawing.run();
  throw UsageError("expected a subcommand: " + subcommand_names + " (see --help)");
}

}  // namespace sightline::viz
