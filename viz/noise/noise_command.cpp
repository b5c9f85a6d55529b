#include "viz/noise/noise_command.h"

#include <charconv>
#include <cmath>
#include <iostream>
#include <optional>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "viz/noise/noise_data.h"
#include "viz/noise/noise_picture.h"
#include "viz/noise/noise_window.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {
namespace {

constexpr const char* about = R"(Noise, from its lattice to its spectrum.

Random gradients on an integer lattice; at a point, each corner of its cell gives its gradient times the way from there,
and an ease goes over from corner to corner. The sheet shows the values, their analytic gradient, one cell with what its
corners give (LL, LR, UL, UR), the ease with its slope and curvature, the power spectrum, white noise for contrast, and
in space surfaces of equal value and a mist.

Examples
  sightline-view noise
      Perlin's noise as courses teach it; opens a window where there is a display
  sightline-view noise --kind improved --out improved.png
      that of 2002, as a picture; needs no display
  sightline-view noise --show lattice --point 3.25,1.5 --out cell.png
      one panel: the cell of a point, counted in lattice cells
  sightline-view noise --fractal turbulence --octaves 6 --show slice --extent 8 --out turbulence.png
  sightline-view noise --fractal fbm --warp 0.5 --out fbm.png --out fbm.vti
      a sheet, and the values of a cube for ParaView

In the window, H shows the keys.)";

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

constexpr double farthest = 1e6;  // so that cells are still seen apart in float

glm::dvec2 parse_point(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto x = number(std::string_view(text).substr(0, comma));
  const auto y = comma == std::string::npos ? std::nullopt : number(std::string_view(text).substr(comma + 1));
  if (!x || !y || std::fabs(*x) > farthest || std::fabs(*y) > farthest)
    refuse("--point", text, "X,Y, two numbers of cells from -1000000 to 1000000");
  return {*x, *y};
}

double parse_height(const std::string& text) {
  const double z = noise_tool::parse_slice(text);
  if (std::fabs(z) > farthest) refuse("--slice", text, "z=POSITION from -1000000 to 1000000");
  return z;
}

std::optional<NoisePanel> parse_panel(const std::string& text) {
  if (text.empty()) return std::nullopt;
  std::string names;
  for (const NoisePanelInfo& info : noise_panel_infos) {
    if (info.name == text) return info.panel;
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  }
  refuse("--show", text, "one of " + names);
}

bool is_data(const std::string& out) {
  const std::string extension = extension_of(out);
  if (extension != ".png" && extension != ".vti")
    refuse("--out", out, "a name that ends in .png (picture) or .vti (values of a cube)");
  return extension == ".vti";
}

}  // namespace

NoiseCommand::NoiseCommand(CLI::App& program)
    : command_(program.add_subcommand("noise", about)), field_(*command_), camera_(*command_) {
  command_
      ->add_option("--show", panel_,
                   "One panel instead of the sheet, by its name: slice, gradients, lattice, ease,\n"
                   "spectrum, coherence, isosurfaces or volume")
      ->option_text("PANEL");
  command_->add_option("--extent", extent_, "Of what is shown along each side; default 4")->option_text("LENGTH");
  command_->add_option("--slice", slice_, "Where space is cut; default z=0.5")->option_text("z=POSITION");
  command_->add_option("--point", point_, "Whose cell is explained, in lattice cells; default 1.6,1.35")
      ->option_text("X,Y");
  command_->add_option("--size", size_, "Of the picture or window in pixels; default 1600x1000")
      ->option_text("WIDTHxHEIGHT");
  add_outs(*command_, outs_, ".png or .vti");
}

int NoiseCommand::run(WindowFrame* frame) const {
  const PictureSize size = parse_size_of<NoisePicture>(size_);
  if (!(extent_ >= 0.01 && extent_ <= 1000)) refuse("--extent", std::to_string(extent_), "0.01 to 1000");
  NoiseLook look{NoiseField(field_.options())};
  look.extent = extent_;
  look.slice = parse_height(slice_);
  look.point = parse_point(point_);
  camera_.check();
  if (camera_.has_azimuth()) look.azimuth = camera_.azimuth();
  if (camera_.has_elevation()) look.elevation = camera_.elevation();
  look.zoom = camera_.zoom();
  const NoisePicture picture{look, parse_panel(panel_), size.width, size.height};
  bool has_picture = false;
  for (const std::string& out : outs_) {
    has_picture |= !is_data(out);
    OutputFile check(out);  // says now whether it can be written
  }
  std::optional<PictureScreen> screen;
  if (has_picture) screen.emplace();
  if (outs_.empty()) {
    if (!has_display()) {
      throw ScreenError("no display to open a window on; write a file instead: --out FILE.png or .vti");
    }
    return open_window<NoiseWindow>(frame, std::shared_ptr<const void>(), picture, std::cout);
  }
  Progress progress;
  for (const std::string& out : outs_) {
    progress.say("drawing " + out);
    if (is_data(out)) {
      write_vti(out, cube_of(look.field, 128, look.extent, look.slice));
    } else {
      picture.write_png(out);
    }
  }
  progress.clear();
  return 0;
}

}  // namespace sightline::viz
