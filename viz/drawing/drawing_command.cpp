#include "viz/drawing/drawing_command.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"
#include "viz/drawing/drawing_picture.h"
#include "viz/view_options.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {
namespace {

Drawing drawing_in(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw FileError(file, 0, "a drawing in JSON", "no file that can be read");
  try {
    return nlohmann::json::parse(in).get<Drawing>();
  } catch (const std::exception& error) {
    throw FileError(file, 0, "a drawing in JSON", error.what());
  }
}

}  // namespace

DrawingCommand::DrawingCommand(CLI::App& program)
    : command_(program.add_subcommand("drawing", "A picture of what the labs found, from its data")) {
  command_->add_option("file", file_, "As labs write it beside their pictures")->option_text("FILE.json")->required();
  command_->add_option("--out", out_, "The picture")->option_text("FILE.png")->required();
  command_->add_option("--size", size_, "In pixels, from 480x360; default 1200x900")->option_text("WIDTHxHEIGHT");
}

int DrawingCommand::run() const {
  const PictureSize size = parse_size(size_);
  if (size.width < DrawingSize::least_width || size.height < DrawingSize::least_height) {
    refuse("--size", size_, "at least 480x360");
  }
  if (extension_of(out_) != ".png") refuse("--out", out_, "a name that ends in .png");
  const Drawing drawing = drawing_in(file_);
  OutputFile check(out_);  // says now whether it can be written
  const PictureScreen screen;
  write_drawing_png(out_, drawing, {size.width, size.height});
  return 0;
}

}  // namespace sightline::viz
