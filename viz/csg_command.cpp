#include "viz/csg_command.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>

#include "sightline/io/output_file.h"
#include "sightline/scene/solid_file.h"
#include "sightline/scene/solids.h"
#include "viz/command_text.h"
#include "viz/csg_picture.h"
#include "viz/csg_table.h"
#include "viz/csg_window.h"
#include "viz/view_options.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {
namespace {

constexpr const char* about = R"(The interval ladder: what a ray makes of a solid, node by node.

A solid is a tree of unions, intersections, differences and complements. A ray lists where it enters and leaves each
primitive; each operation merges the lists of its operands A and B in the order of t, and keeps a transition where
being in the result changes. What the root keeps is the solid; the first boundary with t >= 0 is the hit.

The table goes to stdout. The picture shows the same in bars, under a section through the ray, beside the solid.

Examples
  sightline-view csg --list
  sightline-view csg --solid widget --out widget.png
      the table, and the picture of a ray that shows something
  sightline-view csg --solid lens --ray -3,0.25,0,1,0,0
      another ray: origin and direction; t counts in lengths of the direction. Opens a window where there is a display
  sightline-view csg --solid menger:2 --pick 300,420 --out pick.png
      the ray through a pixel of the picture, counted from its top left corner
  sightline-view csg --solid solid.json --precision exact --out ladder.json --out ladder.png
      a solid of one's own: {"op":"diff","args":[{"prim":"box","lo":[-1,-1,-1],"hi":[1,1,1],"material":"oak"},
                                                 {"prim":"sphere","c":[0,0,1],"r":0.5}]})";

/// Of solids rays have doubles.
Ray<double> parse_solid_ray(const std::string& text) {
  const auto v = finite_numbers(text, 6, ',');
  if (!v) refuse("--ray", text, "OX,OY,OZ,DX,DY,DZ, six finite numbers: an origin and a direction");
  const Ray<double> ray{{(*v)[0], (*v)[1], (*v)[2]}, {(*v)[3], (*v)[4], (*v)[5]}};
  if (!is_valid(ray)) refuse("--ray", text, "a direction that is not zero, of a length from 2^-500 to 2^500");
  return ray;
}

Ray<double> parse_pick(const std::string& text, const LadderSolid& solid, const PictureSize& size) {
  std::optional<Ray<double>> ray;
  if (const auto at = pixel_in(text)) ray = ray_through_pixel(solid, size.width, size.height, at->x, at->y);
  if (!ray) {
    const SolidPanel panel = CsgLayout(size.width, size.height).panel();
    refuse("--pick", text,
           "X,Y, a pixel where the picture of " + std::to_string(size.width) + "x" + std::to_string(size.height) +
               " shows the solid: X from " + std::to_string(panel.x) + " to " +
               std::to_string(panel.x + panel.width - 1) + ", Y from " + std::to_string(panel.y) + " to " +
               std::to_string(panel.y + panel.height - 1));
  }
  return *ray;
}

Level parse_level(const std::string& text) {
  std::string names;
  for (const LevelInfo& info : level_infos) {
    if (info.name == text) return info.level;
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  }
  refuse("--precision", text, "one of " + names);
}

/// Names have neither in them, files have an extension at least.
bool is_file(const std::string& spec) { return spec.find_first_of("./") != std::string::npos; }

/// What is wrong with a file's solid is said of the file.
LadderSolid solid_of(const std::string& spec, const std::string& accelerator) {
  if (!is_file(spec)) return {load_solid(spec), accelerator};
  try {
    return {read_solid(spec), accelerator};
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    throw std::runtime_error(what.starts_with(spec) ? what : spec + ": " + what);
  }
}

/// Of a file's solid: across its middle, from outside.
Ray<double> ray_across(const LadderSolid& solid) {
  const Aabb& extent = solid.plain().extent();
  if (extent.is_empty()) return {{-2, 0.25, 0.125}, {1, 0, 0}};
  const Vec3d lo(extent.lo), hi(extent.hi), size = hi - lo;
  return {{lo.x - 0.25 * size.x, lo.y + 0.55 * size.y, lo.z + 0.56 * size.z}, {size.x, 0, 0}};
}

int list() {
  for (const SolidInfo& info : solid_infos()) {
    const std::string size = info.default_size == 0 ? "" : ":" + std::to_string(info.default_size);
    std::printf("%-16s %s\n", (std::string(info.name) + size).c_str(), std::string(info.description).c_str());
  }
  std::printf("%-16s %s\n", "FILE.json", "a tree of one's own, as ./sightline probe takes it");
  return 0;
}

enum class Form { png, json };

Form form_of(const std::string& out) {
  const std::string extension = extension_of(out);
  if (extension == ".png") return Form::png;
  if (extension == ".json") return Form::json;
  refuse("--out", out, "a name that ends in .png (picture) or .json (data)");
}

}  // namespace

CsgCommand::CsgCommand(CLI::App& program) : command_(program.add_subcommand("csg", about)) {
  command_->add_option("--solid", solid_, "A solid of --list, with or without :SIZE, or a .json file; default widget")
      ->option_text("SOLID");
  auto* ray = command_->add_option("--ray", ray_, "Origin and direction; default one that suits the solid")
                  ->option_text("OX,OY,OZ,DX,DY,DZ");
  command_->add_option("--pick", pick_, "The ray through a pixel of the picture instead")
      ->option_text("X,Y")
      ->excludes(ray);
  command_->add_option("--precision", precision_, "fast, watertight, precise or exact; default watertight")
      ->option_text("LEVEL");
  command_
      ->add_option("--accel", accelerator_,
                   "The structure that finds the operands of large unions as the picture is traced; default box-tree")
      ->option_text("NAME");
  command_->add_option("--size", size_, "Of the picture or window in pixels; default 1600x900")
      ->option_text("WIDTHxHEIGHT");
  command_->add_option("--out", outs_, "A .png or .json file instead of a window; may be repeated")
      ->option_text("FILE")
      ->expected(1)
      ->take_all();
  command_->add_flag("--list", is_list_, "The solids that have names");
}

int CsgCommand::run(WindowFrame* frame) const {
  if (is_list_) return list();
  const PictureSize size = parse_size_of<CsgLayout>(size_);
  const Level level = parse_level(precision_);
  std::optional<Ray<double>> ray;
  if (command_->count("--ray")) ray = parse_solid_ray(ray_);
  bool has_picture = false;
  for (const std::string& out : outs_) {
    has_picture |= form_of(out) == Form::png;
    OutputFile check(out);  // says now whether it can be written
  }
  const AcceleratorSpec accelerator = parse_structure(accelerator_, {});
  if (accelerator.label != accelerator.accelerator) {
    refuse("--accel", accelerator_, "a name alone; structures of operands have no options");
  }
  const auto held = std::make_shared<const LadderSolid>(solid_of(solid_, accelerator.accelerator));
  const LadderSolid& solid = *held;
  std::string description = std::to_string(solid.plain().primitives().size()) + " primitives";
  if (!is_file(solid_)) {
    const SolidInfo& info = solid_info(solid_);
    description = info.description;
    if (const std::size_t end = description.find("; size"); end != std::string::npos) description.resize(end);
    if (!ray) {
      const auto& [o, d] = std::pair(info.origin, info.direction);
      ray = Ray<double>{{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
    }
  }
  if (command_->count("--pick")) ray = parse_pick(pick_, solid, size);
  if (!ray) ray = ray_across(solid);

  const std::string name = is_file(solid_) ? std::filesystem::path(solid_).filename().string() : solid_;
  const CsgPicture picture{solid, solid.climb(*ray, level), name, description, size.width, size.height};
  std::optional<PictureScreen> screen;
  if (has_picture) screen.emplace();
  std::cout << ladder_table(picture.ladder, solid, name) << std::flush;
  for (const std::string& out : outs_) {
    if (form_of(out) == Form::json) {
      write_text(out, ladder_json(picture.ladder, solid, name).dump(1) + "\n");
    } else {
      picture.write_png(out);
    }
  }
  if (!outs_.empty()) return 0;
  if (has_display()) {
    std::string command = "sightline-view csg" + option_text("--solid", solid_);
    if (command_->count("--precision")) command += option_text("--precision", precision_);
    if (command_->count("--accel")) command += option_text("--accel", accelerator_);
    return open_window<CsgWindow>(frame, held, picture, command, std::cout);
  } else {
    std::cerr << "sightline-view: no display to open a window on; --out FILE.png writes the picture\n";
  }
  return 0;
}

}  // namespace sightline::viz
