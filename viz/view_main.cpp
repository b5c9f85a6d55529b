/// sightline-view: how a structure divides a scene, as a window, a picture or data.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "sightline/scene/scenes.h"
#include "viz/build/build_command.h"
#include "viz/cell_export.h"
#include "viz/compare/compare_command.h"
#include "viz/csg_command.h"
#include "viz/graph/graph_command.h"
#include "viz/noise/noise_command.h"
#include "viz/partition_window.h"
#include "viz/picture_command.h"
#include "viz/run_tool.h"
#include "viz/structure.h"
#include "viz/texture/texture_commands.h"
#include "viz/view_options.h"
#include "viz/virtual_screen.h"
#include "viz/walk/walk_command.h"
#include "viz/web/page_command.h"

namespace sightline::viz {
namespace {

constexpr const char* about =
    R"(Draws how a structure divides space, what a ray makes of a solid, how a scene hangs together, and what noise and
textures are made of.

Examples
  sightline-view list
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
    "partitions, walk, compare, build, csg, graph, noise, wood, normals, page, picture or list";

struct Arguments {
  std::string accelerator = "kd-tree", scene = "teapot", out, depth, slice, size = "1200x900",
              data = SIGHTLINE_DATA_DIR;
  std::vector<std::string> settings;
  int threads = 0;
  bool leaves = false;
  std::size_t max_cells = CellFilter{}.max_cells;
  double azimuth = 0, elevation = 0, zoom = 1;
};

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

/// Everything that can be refused is refused before the scene is read, so that nobody waits for an error.
int show_partitions(const Arguments& arguments, const CLI::App& command) {
  const OutputKind kind = output_kind(arguments.out);
  AcceleratorSpec structure = parse_structure(arguments.accelerator, arguments.settings);
  structure.settings.threads = arguments.threads;

  CellFilter filter;
  filter.leaves_only = arguments.leaves;
  filter.max_cells = arguments.max_cells;
  if (!arguments.depth.empty()) {
    const DepthRange range = parse_depth(arguments.depth);
    filter.shallowest = range.shallowest;
    filter.deepest = range.deepest;
  }
  if (!arguments.slice.empty()) filter.slice = parse_slice(arguments.slice);
  require_number("--azimuth", arguments.azimuth);
  require_number("--elevation", arguments.elevation);
  require_number("--zoom", arguments.zoom);
  View view;
  if (command.count("--azimuth")) view.azimuth = arguments.azimuth;
  if (command.count("--elevation")) view.elevation = arguments.elevation;
  view.zoom = arguments.zoom;
  const PictureSize size = parse_size(arguments.size);
  view.width = size.width;
  view.height = size.height;
  if (kind == OutputKind::window && !has_display()) {
    throw ScreenError("no display to open a window on; write a file instead: --out FILE.png, .vtp or .gltf");
  }
  if (kind != OutputKind::window) OutputFile(arguments.out);  // says now whether it can be written
  std::optional<PictureScreen> screen;
  if (kind == OutputKind::png) screen.emplace();

  Progress progress;
  progress.say("reading " + arguments.scene);
  const auto mesh = load_scene(arguments.scene, arguments.data);
  progress.say("building " + structure.label + " of " + with_commas(mesh->size()) + " triangles");
  const auto tracer = make_tracer(structure.accelerator, mesh, structure.settings);
  wake_lazy_cells(*tracer);
  progress.say("drawing " + structure.label);
  if (arguments.depth.empty() && arguments.slice.empty() && !arguments.leaves) suit_filter(*tracer, filter);
  const Caption caption = caption_of(*tracer, arguments.scene);
  const Partition partition = select_cells(*tracer, filter);
  if (partition.cells.empty()) {
    throw std::runtime_error(structure.label + " on " + arguments.scene + ": none of its " +
                             with_commas(partition.total) + " cells (depth 0 to " +
                             std::to_string(partition.total_deepest) + ") match");
  }
  const PartitionPicture picture{*mesh, partition, filter.slice, caption, view};
  switch (kind) {
    case OutputKind::window:
      progress.clear();
      open_partition_window(*tracer, filter, picture);
      return success;
    case OutputKind::png:
      picture.write_png(arguments.out);
      break;
    case OutputKind::vtp:
      write_vtp(arguments.out, partition);
      break;
    case OutputKind::gltf:
      write_gltf(arguments.out, partition, *mesh);
      break;
  }
  progress.clear();
  std::cerr << arguments.out << ": " << summary(partition) << '\n';
  return success;
}

int run(int argc, char** argv) {
  CLI::App app(about, "sightline-view");
  app.require_subcommand(0, 1);
  Arguments arguments;
  bool is_list = false;
  app.add_flag("--list", is_list, "The same as `list`");
  app.add_option("--data", arguments.data, "Folder of scene data")->option_text("DIR");
  CLI::App* listing = app.add_subcommand("list", "The accelerators with their options, and the scenes");
  CLI::App* command = app.add_subcommand("partitions", "The cells of a structure over the mesh");
  CompareCommand compare(app, arguments.data);
  WalkCommand walk(app, arguments.data);
  BuildCommand build(app, arguments.data);
  CsgCommand csg(app);
  GraphCommand graph(app, arguments.data);
  NoiseCommand noise(app);
  WoodCommand wood(app);
  NormalsCommand normals(app);
  PageCommand page(app, arguments.data);
  PictureCommand picture(app);
  command->fallthrough();
  listing->fallthrough();
  command->add_option("--accel", arguments.accelerator, "The structure, see --list; default kd-tree")
      ->option_text("NAME[:OPTION=VALUE,...]");
  command
      ->add_option("--scene", arguments.scene,
                   "A scene of --list, with or without :SIZE, or a mesh file; default teapot")
      ->option_text("SCENE");
  command->add_option("--set", arguments.settings, "An option of the structure; may be repeated")
      ->option_text("ACCEL.OPTION=VALUE")
      ->expected(1)
      ->take_all();
  command->add_option("--threads", arguments.threads, "Threads to build with, to 1024; default 0: all")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
  command->add_option("--depth", arguments.depth, "Depths to show, the root's is 0; default: as many as read well")
      ->option_text("MIN:MAX");
  command->add_flag("--leaves", arguments.leaves, "Leaves only, of all depths");
  command
      ->add_option("--slice", arguments.slice,
                   "The cells that a plane cuts, drawn as sections; the position is a share of the extent")
      ->option_text("AXIS=POSITION");
  command->add_option("--max-cells", arguments.max_cells, "At most so many cells, the largest ones; default 4000")
      ->check(CLI::Range(std::size_t(1), std::size_t(10'000'000)))
      ->option_text("N");
  command->add_option("--size", arguments.size, "Of the picture or window in pixels; default 1200x900")
      ->option_text("WIDTHxHEIGHT");
  command->add_option("--azimuth", arguments.azimuth, "Camera: degrees to the right of the front; default 24")
      ->check(CLI::Range(-360.0, 360.0))
      ->option_text("DEGREES");
  command->add_option("--elevation", arguments.elevation, "Camera: degrees above the horizon; default 20")
      ->check(CLI::Range(-90.0, 90.0))
      ->option_text("DEGREES");
  command->add_option("--zoom", arguments.zoom, "Camera: 1 shows everything, 2 comes twice as close")
      ->check(CLI::Range(0.1, 100.0))
      ->option_text("FACTOR");
  command->add_option("--out", arguments.out, "A .png, .vtp or .gltf file instead of a window")->option_text("FILE");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    const std::string first = argc > 1 ? argv[1] : "-";
    const auto subcommands = app.get_subcommands([](const CLI::App*) { return true; });
    const bool is_known = std::any_of(subcommands.begin(), subcommands.end(),
                                      [&](const CLI::App* subcommand) { return subcommand->get_name() == first; });
    if (first[0] != '-' && !is_known) {
      throw UsageError("unknown subcommand '" + first + "'; expected " + subcommand_names + " (see --help)");
    }
    throw UsageError(std::string(error.what()) + " (see --help)");
  }
  if (is_list || listing->parsed()) return list();
  if (compare.is_chosen()) return compare.run();
  if (walk.is_chosen()) return walk.run();
  if (build.is_chosen()) return build.run();
  if (csg.is_chosen()) return csg.run();
  if (graph.is_chosen()) return graph.run();
  if (noise.is_chosen()) return noise.run();
  if (wood.is_chosen()) return wood.run();
  if (normals.is_chosen()) return normals.run();
  if (page.is_chosen()) return page.run();
  if (picture.is_chosen()) return picture.run();
  if (!command->parsed()) throw UsageError("expected a subcommand: " + subcommand_names + " (see --help)");
  return show_partitions(arguments, *command);
}

}  // namespace
}  // namespace sightline::viz

int main(int argc, char** argv) {
  return sightline::run_tool("sightline-view", [&] { return sightline::viz::run(argc, argv); });
}
