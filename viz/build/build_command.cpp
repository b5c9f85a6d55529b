#include "viz/build/build_command.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "sightline/scene/scenes.h"
#include "viz/build/build_chart.h"
#include "viz/build/build_window.h"
#include "viz/command_text.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {
namespace {

constexpr const char* about =
    R"(How a structure is built, node by node: what was weighed, what it would have cost, and what was taken.

On the left the node with what it holds, the planes that were weighed (colored by cost), the one that was taken, and
the children that came of it; on the right cost against the plane's position, a curve an axis, beside what a leaf would
cost. Costs are those of the builder's own cost model. What the builder weighed is evaluated again by the library's
functions, and held against the tree that it built.

Steps are the nodes that are divided, breadth first: 0 is the root, 1 and 2 its children where these are divided, and so
on; children from below to above. Leaves have no step, but a number, as all nodes have: --node, as it is shown.

Examples
  sightline-view build
      opens a window on the root of the teapot's kd-tree: Right for the next node, Down for the child, H for all keys
  sightline-view build --accel box-tree --scene dragon:4 --step 3 --out step.png
  sightline-view build --accel bsp-tree --scene teapot --step 20 --out costs.svg
      the chart alone; .csv and .json list the candidates, and need no display
  sightline-view build --accel kd-tree --scene teapot --frames steps
      steps/step-0000.png and so on, the first 50)";

enum class Kind { window, png, svg, json, csv };

Kind kind_of(const std::string& path) {
  if (path.empty()) return Kind::window;
  const std::string extension = extension_of(path);
  if (extension == ".png") return Kind::png;
  if (extension == ".svg") return Kind::svg;
  if (extension == ".json") return Kind::json;
  if (extension == ".csv") return Kind::csv;
  refuse("--out", path, "a name that ends in .png (picture), .svg (chart), .json or .csv (candidates)");
}

void write_frames(const BuildStory& story, const BuildLook& look, const std::string& folder, std::size_t first,
                  std::size_t most, Progress& progress) {
  std::filesystem::create_directories(folder);
  const std::size_t end = std::min(story.tree().steps().size(), first + most);
  for (std::size_t step = first; step < end; ++step) {
    progress.say("drawing step " + std::to_string(step) + " of " + std::to_string(end));
    std::string number = std::to_string(step);
    number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
    const BuildStep taken = story.step_at(story.tree().steps()[step]);
    BuildPicture{story, taken, look}.write_png(std::filesystem::path(folder) / ("step-" + number + ".png"));
  }
  progress.clear();
  std::cerr << folder << ": " << end - first << " pictures\n";
}

}  // namespace

BuildCommand::BuildCommand(CLI::App& program, const std::string& data_folder)
    : command_(program.add_subcommand("build", about)),
      data_(data_folder),
      structure_(*command_),
      camera_(*command_, 20, "all of the node") {
  command_->fallthrough();
  auto* step = command_->add_option("--step", step_, "The node that is divided as the K-th, breadth first; default 0")
                   ->option_text("K");
  command_->add_option("--node", node_, "The node of this number, a leaf perhaps")->option_text("N")->excludes(step);
  command_->add_option("--frames", frames_, "A picture of each step into this folder, from --step on")
      ->option_text("DIR");
  command_->add_option("--most", most_frames_, "At most so many pictures of --frames; default 50")
      ->check(CLI::Range(std::size_t(1), std::size_t(10'000)))
      ->option_text("N");
  command_->add_option("--size", size_, "Of the picture or window in pixels; default 1920x1080")
      ->option_text("WIDTHxHEIGHT");
  command_->add_option("--out", out_, "A .png, .svg, .json or .csv file instead of a window")->option_text("FILE");
}

int BuildCommand::run(WindowFrame* frame) const {
  const Kind kind = kind_of(out_);
  const AcceleratorSpec structure = structure_.structure();
  const auto known = replayed_structures();
  if (std::find(known.begin(), known.end(), structure.accelerator) == known.end()) {
    std::string names;
    for (const std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
    refuse("--accel", structure.accelerator, "one of " + names);
  }
  camera_.check();
  const PictureSize size = parse_size_of<BuildPicture>(size_);
  const BuildLook look{camera_.azimuth(), camera_.elevation(), camera_.zoom(), size.width, size.height};
  const bool has_frames = command_->count("--frames") > 0;
  if (has_frames && (!out_.empty() || command_->count("--node"))) {
    refuse("--frames", frames_, "neither --out nor --node beside it");
  }
  if (kind == Kind::window && !has_frames && !has_display()) {
    throw ScreenError("no display to open a window on; write a file instead: --out FILE.png, .svg, .json or .csv");
  }
  if (kind != Kind::window) OutputFile check(out_);  // says now whether it can be written
  std::optional<PictureScreen> screen;
  if (kind == Kind::png || kind == Kind::svg || has_frames) screen.emplace();

  Progress progress;
  progress.say("reading " + structure_.scene());
  const auto mesh = load_scene(structure_.scene(), data_);
  progress.say("building " + structure.label);
  std::string flags;
  for (const std::string& setting : structure_.settings()) flags += option_text("--set", setting);
  const auto held = std::make_shared<const BuildStory>(mesh, structure, structure_.scene(), flags);
  const BuildStory& story = *held;
  const BuildTree& tree = story.tree();
  std::size_t node = 0;
  if (command_->count("--node")) {
    const auto named = tree.named(node_);
    if (!named)
      refuse("--node", std::to_string(node_),
             "the number of a node; the root's is " + std::to_string(tree[0].cell.node));
    node = *named;
  } else if (step_ > 0 && step_ >= tree.steps().size()) {
    refuse("--step", std::to_string(step_),
           "0 to " + std::to_string(tree.steps().size() - 1) + ", as many as there are");
  } else if (!tree.steps().empty()) {
    node = tree.steps()[step_];
  }
  if (has_frames) {
    write_frames(story, look, frames_, step_, most_frames_, progress);
    return 0;
  }
  progress.say("weighing again");
  const BuildStep step = story.step_at(node);
  switch (kind) {
    case Kind::window:
      progress.clear();
      return open_window<BuildWindow>(frame, held, story, node, look, std::cout);
    case Kind::png:
      BuildPicture{story, step, look}.write_png(out_);
      break;
    case Kind::svg:
      write_chart_svg(out_, step.decision, step.title);
      break;
    case Kind::json:
      write_step_json(out_, story, step);
      break;
    case Kind::csv:
      write_step_csv(out_, step);
      break;
  }
  progress.clear();
  std::cerr << out_ << ": the node " << step.decision.reason << '\n';
  return 0;
}

}  // namespace sightline::viz
