#include "viz/texture/texture_commands.h"

#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "viz/texture/normals_picture.h"
#include "viz/texture/picture_window.h"
#include "viz/texture/wood_picture.h"
#include "viz/view_options.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {
namespace {

constexpr const char* about_wood = R"(Solid textures: wood as the course builds it, and others.

f(P) = (X^2 + Z^2 + noise(P)) mod 1 counts from ring to ring around the y axis; the color goes from early wood to late
wood with f. Three knobs tune it: how close rings are (texture frequency), how many bumps they have (noise frequency),
and how far these go (noise amplitude).

Examples
  sightline-view wood --tune --out tuning.png
      the tuning sheet: each knob from 1 to 3
  sightline-view wood --texture wood:texture_frequency=2,noise_amplitude=0.5 --out plank.png
      a block and a section across it
  sightline-view wood --texture marble
      another texture, in a window where there is a display
  sightline-view wood --list
      all textures with their options)";

constexpr const char* about_normals = R"(Normal mapping: dents that are seen, and are not there.

The same noise dents a sphere twice: once its normals only, so that light falls as on dents, and once its surface, as a
mesh whose vertices are moved. The silhouettes tell them apart; the table says what each costs in time and memory, the
picture what it costs in counts.

Noise has frequency 5 and a quintic ease here, unless told otherwise: with the cubic one, whose curvature jumps, lattice
planes show as creases.

Examples
  sightline-view normals --out normals.png
  sightline-view normals --ease cubic --out creases.png
  sightline-view normals --fractal fbm --frequency 2 --amplitude 0.15 --out rough.png)";

/// Whether a picture goes to a file, which can be written; otherwise there is a display.
bool is_file(const std::string& out) {
  if (out.empty()) {
    if (!has_display()) throw ScreenError("no display to open a window on; write a file instead: --out FILE.png");
    return false;
  }
  if (std::filesystem::path(out).extension() != ".png") refuse("--out", out, "a name that ends in .png");
  OutputFile check(out);
  return true;
}

int list() {
  for (const TextureInfo& info : texture_infos()) {
    std::printf("%-10s %s\n", std::string(info.name).c_str(), std::string(info.description).c_str());
    for (const TextureOptionInfo& option : info.options) {
      std::printf("    %s=%s: %s (%s)\n", std::string(option.name).c_str(), option.default_value.c_str(),
                  std::string(option.help).c_str(), option.allowed.c_str());
    }
  }
  return 0;
}

void add_output(CLI::App& command, std::string& size, std::string& out) {
  command.add_option("--size", size, "Of the picture or window in pixels; default " + size)
      ->option_text("WIDTHxHEIGHT");
  command.add_option("--out", out, "A .png file instead of a window")->option_text("FILE");
}

}  // namespace

WoodCommand::WoodCommand(CLI::App& program) : command_(program.add_subcommand("wood", about_wood)) {
  command_->add_option("--texture", texture_, "A texture of --list, with or without options; default wood")
      ->option_text("NAME[:OPTION=VALUE,...]");
  command_->add_flag("--tune", is_tuning_, "The course's sheet: what each of wood's three knobs does");
  command_->add_flag("--list", is_list_, "The textures with their options");
  add_output(*command_, size_, out_);
}

int WoodCommand::run() const {
  if (is_list_) return list();
  const PictureSize size = parse_size_of<WoodPicture>(size_);
  const Texture texture = make_texture(texture_);
  if (is_tuning_ && !std::holds_alternative<Wood>(texture.any())) refuse("--tune with --texture", texture_, "wood");
  const WoodPicture picture{texture_, is_tuning_, size.width, size.height};
  const auto show = [&](vtkRenderWindow& window, int scale) { picture.show_in(window, scale); };
  if (!is_file(out_)) {
    open_picture_window(is_tuning_ ? "tuning wood" : texture_, size.width, size.height, show);
    return 0;
  }
  const PictureScreen screen;
  Progress progress;
  progress.say("drawing " + texture_);
  picture.write_png(out_);
  progress.clear();
  return 0;
}

NormalsCommand::NormalsCommand(CLI::App& program)
    : command_(program.add_subcommand("normals", about_normals)), field_(*command_) {
  command_
      ->add_option("--amplitude", amplitude_,
                   "How far noise of 1 dents, in radii of the sphere, up to 0.5; default 0.08")
      ->option_text("LENGTH");
  command_->add_option("--divisions", divisions_, "Of the displaced mesh, 12 times the square of this; default 256")
      ->check(CLI::Range(2, 1024))
      ->option_text("N");
  add_output(*command_, size_, out_);
}

int NormalsCommand::run() const {
  const PictureSize size = parse_size_of<NormalsPicture>(size_);
  if (!(amplitude_ >= 0 && amplitude_ <= 0.5)) refuse("--amplitude", std::to_string(amplitude_), "0 to 0.5");
  FieldOptions options = field_.options();
  if (options.noise.kind == NoiseKind::white) refuse("--kind", "white", "noise that has a gradient");
  if (!command_->count("--frequency")) options.frequency = 5;
  // Light follows the gradient, whose creases at lattice planes show where the ease is cubic.
  if (!command_->count("--ease")) options.noise.ease = Ease::quintic;
  const Dents dents{NoiseField(options), amplitude_};
  const bool has_file = is_file(out_);
  std::optional<PictureScreen> screen;
  if (has_file) screen.emplace();
  Progress progress;
  progress.say("denting a sphere, and displacing its " + std::to_string(12 * divisions_ * divisions_) + " triangles");
  const NormalsPicture picture(dents, divisions_, size.width, size.height);
  progress.clear();
  std::cout << picture.table() << std::flush;
  if (has_file) {
    picture.write_png(out_);
  } else {
    open_picture_window("normals", size.width, size.height,
                        [&](vtkRenderWindow& window, int scale) { picture.show_in(window, scale); });
  }
  return 0;
}

}  // namespace sightline::viz
