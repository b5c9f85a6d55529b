#include "viz/partition_command.h"

#include <iostream>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "sightline/scene/scenes.h"
#include "viz/cell_export.h"
#include "viz/partition_window.h"
#include "viz/structure.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {
namespace {

enum class Form { window, png, vtp, gltf };

Form form_of(const std::string& out) {
  if (out.empty()) return Form::window;
  const std::string extension = extension_of(out);
  if (extension == ".png") return Form::png;
  if (extension == ".vtp") return Form::vtp;
  if (extension == ".gltf") return Form::gltf;
  refuse("--out", out, "a name that ends in .png (picture), .vtp or .gltf (data)");
}

}  // namespace

PartitionCommand::PartitionCommand(CLI::App& program, const std::string& data_folder)
    : command_(program.add_subcommand("partitions", "The cells of a structure over the mesh")),
      data_(data_folder),
      structure_(*command_),
      camera_(*command_) {
  command_->fallthrough();
  command_->add_option("--depth", depth_, "Depths to show, the root's is 0; default: as many as read well")
      ->option_text("MIN:MAX");
  command_->add_flag("--leaves", leaves_, "Leaves only, of all depths");
  command_
      ->add_option("--slice", slice_,
                   "The cells that a plane cuts, drawn as sections; the position is a share of the extent")
      ->option_text("AXIS=POSITION");
  command_->add_option("--max-cells", max_cells_, "At most so many cells, the largest ones; default 4000")
      ->check(CLI::Range(std::size_t(1), std::size_t(10'000'000)))
      ->option_text("N");
  command_->add_option("--size", size_, "Of the picture or window in pixels; default 1200x900")
      ->option_text("WIDTHxHEIGHT");
  command_->add_option("--out", out_, "A .png, .vtp or .gltf file instead of a window")->option_text("FILE");
}

CellFilter PartitionCommand::filter() const {
  CellFilter filter;
  filter.leaves_only = leaves_;
  filter.max_cells = max_cells_;
  if (!depth_.empty()) {
    const DepthRange range = parse_depth(depth_);
    filter.shallowest = range.shallowest;
    filter.deepest = range.deepest;
  }
  if (!slice_.empty()) filter.slice = parse_slice(slice_);
  return filter;
}

/// Everything that can be refused is refused before the scene is read, so that nobody waits for an error.
int PartitionCommand::run(WindowFrame* frame) const {
  const Form form = form_of(out_);
  const AcceleratorSpec structure = structure_.structure();
  CellFilter filter = this->filter();
  camera_.check();
  View view;
  if (camera_.has_azimuth()) view.azimuth = camera_.azimuth();
  if (camera_.has_elevation()) view.elevation = camera_.elevation();
  view.zoom = camera_.zoom();
  const PictureSize size = parse_size(size_);
  view.width = size.width;
  view.height = size.height;
  if (form == Form::window && !has_display()) {
    throw ScreenError("no display to open a window on; write a file instead: --out FILE.png, .vtp or .gltf");
  }
  if (form != Form::window) OutputFile check(out_);  // says now whether it can be written
  std::optional<PictureScreen> screen;
  if (form == Form::png) screen.emplace();

  Progress progress;
  progress.say("reading " + structure_.scene());
  const auto mesh = load_scene(structure_.scene(), data_);
  progress.say("building " + structure.label + " of " + with_commas(mesh->size()) + " triangles");
  const std::shared_ptr<const Tracer> tracer = make_tracer(structure.accelerator, mesh, structure.settings);
  wake_lazy_cells(*tracer);
  progress.say("drawing " + structure.label);
  if (depth_.empty() && slice_.empty() && !leaves_) suit_filter(*tracer, filter);
  const Caption caption = caption_of(*tracer, structure_.scene());
  const Partition partition = select_cells(*tracer, filter);
  if (partition.cells.empty()) {
    throw std::runtime_error(structure.label + " on " + structure_.scene() + ": none of its " +
                             with_commas(partition.total) + " cells (depth 0 to " +
                             std::to_string(partition.total_deepest) + ") match");
  }
  const PartitionPicture picture{*mesh, partition, filter.slice, caption, view};
  switch (form) {
    case Form::window:
      progress.clear();
      return open_window<PartitionWindow>(frame, tracer, *tracer, filter, caption, view,
                                          "sightline-view partitions" + structure_.text(), std::cout);
    case Form::png:
      picture.write_png(out_);
      break;
    case Form::vtp:
      write_vtp(out_, partition);
      break;
    case Form::gltf:
      write_gltf(out_, partition, *mesh);
      break;
  }
  progress.clear();
  std::cerr << out_ << ": " << summary(partition) << '\n';
  return 0;
}

}  // namespace sightline::viz
