#include "viz/noise/noise_window.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <algorithm>

#include "viz/command_text.h"
#include "viz/noise/space_panels.h"

namespace sightline::viz {
namespace {

template <class Infos, class Kind>
std::string name_in(const Infos& infos, Kind kind) {
  return std::string(infos[static_cast<std::size_t>(kind)].name);
}

/// The options that are not the usual ones.
std::string field_text(const FieldOptions& options) {
  const FieldOptions usual;
  std::string text;
  const auto add = [&](const std::string& option, const auto& value, const auto& usually, const std::string& words) {
    if (value != usually) text += option_text(option, words);
  };
  const auto& noise = options.noise;
  add("--kind", noise.kind, usual.noise.kind, name_in(noise_infos, noise.kind));
  add("--ease", noise.ease, usual.noise.ease, name_in(ease_infos, noise.ease));
  add("--seed", noise.seed, usual.noise.seed, std::to_string(noise.seed));
  add("--period", noise.period, usual.noise.period, std::to_string(noise.period));
  add("--fractal", options.fractal, usual.fractal, name_in(fractal_infos, options.fractal));
  add("--octaves", options.octaves, usual.octaves, std::to_string(options.octaves));
  add("--lacunarity", options.lacunarity, usual.lacunarity, shortest(options.lacunarity));
  add("--gain", options.gain, usual.gain, shortest(options.gain));
  add("--frequency", options.frequency, usual.frequency, shortest(options.frequency));
  add("--warp", options.warp, usual.warp, shortest(options.warp));
  return text;
}

}  // namespace

NoiseWindow::NoiseWindow(const NoisePicture& first, std::ostream& commands, WindowFrame* frame)
    : InteractiveWindow(
          {.name = "noise", .title = "noise", .width = first.width, .height = first.height, .tells_command = false},
          frame, commands),
      picture_(first),
      first_(first) {
  show();
}

std::string NoiseWindow::command() const {
  const NoiseLook& look = picture_.look;
  const NoiseLook usual{NoiseField{}};
  std::string text = "sightline-view noise" + field_text(look.field.options());
  if (picture_.only) text += " --show " + std::string(noise_panel_infos[static_cast<std::size_t>(*picture_.only)].name);
  if (look.extent != usual.extent) text += option_text("--extent", shortest(look.extent));
  if (look.slice != usual.slice) text += option_text("--slice", "z=" + shortest(look.slice));
  if (look.point != usual.point) text += option_text("--point", shortest(look.point.x) + ',' + shortest(look.point.y));
  if (look.azimuth) text += option_text("--azimuth", shortest(*look.azimuth));
  if (look.elevation) text += option_text("--elevation", shortest(*look.elevation));
  if (look.zoom != 1) text += option_text("--zoom", shortest(look.zoom));
  return text + size_text(picture_.width, picture_.height);
}

std::vector<WindowKey> NoiseWindow::keys() const {
  return {{"drag, wheel", "turns what is in space, comes closer"},
          {"Left, Right", "moves the slice"},
          {"Space", "the next seed"},
          {"E", "the other ease"},
          {"1 to 8; 0", "one panel; all"},
          {"R", "back to the beginning"}};
}

void NoiseWindow::answer_key(const std::string& key) {
  NoiseLook& look = picture_.look;
  FieldOptions options = look.field.options();
  if (key == "Left" || key == "Right") {
    look.slice += (key == "Left" ? -1 : 1) / (16 * options.frequency);
  } else if (key == "space") {
    ++options.noise.seed;
  } else if (key == "e" || key == "E") {
    options.noise.ease = options.noise.ease == Ease::cubic ? Ease::quintic : Ease::cubic;
  } else if (key.size() == 1 && key[0] >= '0' && key[0] <= '8') {
    picture_.only =
        key[0] == '0' ? std::nullopt : std::optional(noise_panel_infos[static_cast<std::size_t>(key[0] - '1')].panel);
  } else if (key == "r" || key == "R") {
    look = first_.look;
    picture_.only = first_.only;
    return show();
  } else {
    return;
  }
  look.field = NoiseField(options);
  show();
}

void NoiseWindow::press() {
  is_held_ = true;
  from_ = hand();
}

/// Cameras go around what has been made.
void NoiseWindow::move() {
  const auto at = hand();
  if (!is_held_ || at == from_) return;
  constexpr double degrees = 0.4;  // for one pixel
  NoiseLook& look = picture_.look;
  const double azimuth = look.azimuth.value_or(usual_azimuth), elevation = look.elevation.value_or(usual_elevation);
  look.azimuth = rounded(std::fmod(azimuth - degrees * (at[0] - from_[0]), 360), 10);
  look.elevation = std::clamp(rounded(elevation - degrees * (at[1] - from_[1]), 10), -90.0, 90.0);
  from_ = at;
  const Axes axes = axes_of(look);
  vtkRendererCollection& all = *window().GetRenderers();
  for (int i = 0; i < all.GetNumberOfItems(); ++i) {
    auto* renderer = vtkRenderer::SafeDownCast(all.GetItemAsObject(i));
    if (renderer->GetActors()->GetNumberOfItems() == 0) continue;
    vtkCamera& camera = *renderer->GetActiveCamera();
    Vec3d focus;
    camera.GetFocalPoint(&focus[0]);
    const Vec3d eye = focus + camera.GetDistance() * axes.z;
    camera.SetPosition(&eye[0]);
    camera.SetViewUp(&axes.y[0]);
    renderer->ResetCameraClippingRange();
  }
  render();
}

void NoiseWindow::zoom(double factor) {
  picture_.look.zoom = std::clamp(rounded(picture_.look.zoom * factor, 1000), 0.1, 100.0);
  show();
}

void NoiseWindow::fit() {
  const auto [width, height] = area_for<NoisePicture>();
  if (width == picture_.width && height == picture_.height) return;
  picture_.width = width, picture_.height = height;
  show();
}

void NoiseWindow::show() {
  picture_.show_in(window(), 1);
  render();
}

}  // namespace sightline::viz
