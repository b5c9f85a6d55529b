#include <cmath>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/axes/picture.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

/// What a seed of its own and many samples make of the scene; its own error is that many samples' root smaller.
FilmState reference(const Effort& effort, const std::shared_ptr<const Scene>& scene, std::uint32_t samples) {
  effort.say(plural(samples, "sample") + " of each pixel for reference");
  RenderSettings settings = picture_settings(effort, samples);
  settings.seed = effort.seed + 1;
  settings.shadow_error = 0;
  settings.cut_off = 0;
  return picture_of(Renderer(scene, settings), 0);
}

std::string share_text(double share) { return "1/" + std::to_string(std::lround(1 / share)); }

Panel panel_of(const Effort& effort, const std::string& name, const std::string& description, const FilmState& truth) {
  const RenderSettings settings = picture_settings(effort, 1);
  const std::string samples = plural(truth.samples, "sample");
  return {name,           description + ", against " + samples + " of each pixel with another seed",
          "pixel",        "of linear light, white is 1",
          ErrorKind::rms, static_cast<double>(settings.width) * settings.height};
}

std::vector<Panel> sample_panels(const Effort& effort) {
  std::vector<Panel> all;
  for (const std::string name : {"shadows", "glossy"}) {
    const auto scene = picture_scene(effort, name);
    const FilmState truth = reference(effort, scene, effort.is_quick ? 256 : 1024);
    Panel panel = panel_of(effort, name, "samples of each pixel of the scene " + name, truth);
    for (std::uint32_t samples = 1; samples <= (effort.is_quick ? 16u : 128u); samples *= 2) {
      panel.choices.push_back(
          picture_choice(plural(samples, "sample"), scene, picture_settings(effort, samples), truth));
    }
    all.push_back(std::move(panel));
  }
  return all;
}

std::vector<Panel> adaptive_panels(const Effort& effort) {
  const auto scene = picture_scene(effort, "shadows");
  const FilmState truth = reference(effort, scene, effort.is_quick ? 256 : 1024);
  const std::uint32_t most = effort.is_quick ? 32 : 256;
  Panel bounds = panel_of(effort, "error bounds", "as many samples as each pixel needs, and as many of each", truth);
  for (const double bound : {1.0 / 8, 1.0 / 16, 1.0 / 32, 1.0 / 64, 1.0 / 128}) {
    RenderSettings settings = picture_settings(effort, most);
    settings.error_bound = bound;
    bounds.choices.push_back(picture_choice("error " + share_text(bound), scene, settings, truth));
  }
  for (std::uint32_t samples = 2; samples <= most; samples *= 2) {
    bounds.choices.push_back(
        picture_choice(plural(samples, "sample"), scene, picture_settings(effort, samples), truth));
  }
  Panel shadows = panel_of(effort, "shadow rays", "rays to lamps that are left out, at 16 samples", truth);
  for (const double error : {0.0, 1.0 / 1024, 1.0 / 256, 1.0 / 64, 1.0 / 16}) {
    RenderSettings settings = picture_settings(effort, 16);
    settings.shadow_error = error;
    shadows.choices.push_back(
        picture_choice(error == 0 ? "all sent" : "shadow error " + share_text(error), scene, settings, truth));
  }
  return {bounds, shadows};
}

std::vector<Panel> cutoff_panels(const Effort& effort) {
  std::vector<Panel> all;
  for (const std::string name : {"glass", "chess"}) {
    const auto scene = picture_scene(effort, name);
    RenderSettings settings = picture_settings(effort, effort.is_quick ? 2 : 8);
    settings.cut_off = 0;
    settings.depth = 10;
    effort.say(name + " without a cut-off");
    const FilmState truth = picture_of(Renderer(scene, settings), 0);
    Panel panel{name,
                "rays of the scene " + name +
                    " that would add less than this are left out; against the same "
                    "samples without",
                "pixel",
                "of linear light, white is 1",
                ErrorKind::rms,
                static_cast<double>(truth.sums.size())};
    for (const double cut : {0.0, 1.0 / 1024, 1.0 / 256, 1.0 / 64, 1.0 / 16, 1.0 / 4}) {
      settings.cut_off = cut;
      panel.choices.push_back(picture_choice(cut == 0 ? "none" : "cut-off " + share_text(cut), scene, settings, truth));
    }
    all.push_back(std::move(panel));
  }
  return all;
}

}  // namespace

Axis samples_axis() { return {"samples", "how many samples each pixel gets", sample_panels}; }
Axis adaptive_axis() { return {"adaptive", "when a pixel, or a shadow, is good enough", adaptive_panels}; }
Axis cutoff_axis() { return {"cut-off", "which mirrored and refracted rays are left out", cutoff_panels}; }

}  // namespace sightline::bench
