#include "viz/render_tool/request.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "sightline/query/accelerator_spec.h"
#include "viz/run_tool.h"

namespace sightline::render_tool {
namespace {

constexpr const char* about = R"(Renders a picture of a scene, and simulates only what the scene calls for.

SCENE is a name with a size ("balls:3"), a scene file (.json; data/README.md teaches the format), or a model: glTF, OBJ,
and whatever else Assimp reads. ./sightline scenes lists what there is.

Ctrl-C ends early: the picture of what is done so far is written, and a checkpoint beside it, from which --resume goes
on to the same picture, bit for bit. A second Ctrl-C ends at once.)";

constexpr const char* examples = R"(
Examples
  sightline-render data/scenes/rocket.json
  sightline-render balls:3 --size 1920x1080 --samples 64 --out balls.exr --aov depth,normal,id
  sightline-render tree:6 --samples 1024 --error 0.005 --preview
  sightline-render tree:6 --samples 1024 --error 0.005 --resume
  sightline-render data/scenes/rocket.json --plan

Exit status: 0 done, 1 failure, 2 wrong usage, 130 ended early by Ctrl-C (143 by SIGTERM).
)";

/// What CLI11 reads and is looked at here.
struct Texts {
  std::string size = "640x480", accelerator, precision = "watertight", aovs;
  std::vector<std::string> settings;
  int depth = 0;
  double cut_off = 0, shadow_error = 0;
};

[[noreturn]] void refuse(const std::string& option, const std::string& expected, const std::string& found) {
  throw std::invalid_argument(option + ": expected " + expected + ", found \"" + found + "\"");
}

void parse_size(const std::string& text, RenderSettings& settings) {
  constexpr int largest = 16384;
  constexpr std::int64_t most_pixels = std::int64_t{1} << 26;  // 64 bytes each
  int end = 0;
  if (std::sscanf(text.c_str(), "%5dx%5d%n", &settings.width, &settings.height, &end) != 2 ||
      end != static_cast<int>(text.size()) || settings.width < 1 || settings.height < 1 || settings.width > largest ||
      settings.height > largest || std::int64_t{settings.width} * settings.height > most_pixels) {
    refuse("--size", "WxH from 1x1 to 16384x16384, of at most 2^26 pixels", text);
  }
}

Level parse_precision(const std::string& text) {
  for (const LevelInfo& info : level_infos) {
    if (info.name == text) return info.level;
  }
  refuse("--precision", "fast, watertight, precise or exact", text);
}

std::vector<Aov> parse_aovs(const std::string& text) {
  std::vector<Aov> aovs;
  std::string names;
  for (const AovInfo& info : aov_infos) names += (names.empty() ? "" : ", ") + std::string(info.name);
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const auto info = std::find_if(aov_infos.begin(), aov_infos.end(),
                                   [&](const AovInfo& each) { return each.name == text.substr(from, to - from); });
    if (info == aov_infos.end()) refuse("--aov", "names of " + names + ", separated by commas", text);
    if (std::find(aovs.begin(), aovs.end(), info->aov) == aovs.end()) aovs.push_back(info->aov);
    from = to + 1;
  }
  return aovs;
}

void parse_structure(const Texts& texts, RenderSettings& settings) {
  if (texts.accelerator.empty()) {
    if (!texts.settings.empty()) refuse("--set", "--accel before it", texts.settings.front());
    return;
  }
  std::vector<AcceleratorSpec> specs = parse_accelerators(texts.accelerator);
  if (specs.size() != 1) refuse("--accel", "one structure", texts.accelerator);
  apply_settings(specs, texts.settings);
  check_accelerator(specs.front());
  settings.accelerator = specs.front().accelerator;
  settings.options = specs.front().settings.options;
}

/// "data/scenes/rocket.json" and "balls:3" to "out/rocket.png" and "out/balls-3.png".
std::string name_of_picture(const std::string& scene) {
  std::string name = std::filesystem::path(scene).stem().string();
  std::replace(name.begin(), name.end(), ':', '-');
  return "out/" + (name.empty() ? "picture" : name) + ".png";
}

void check_name(const std::string& out) {
  constexpr auto known = std::to_array<std::string_view>({".exr", ".png", ".tif", ".tiff"});
  std::string extension = std::filesystem::path(out).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    refuse("--out", "a name that ends in .exr, .png, .tif or .tiff", out);
  }
}

void require_finite(const std::string& option, double value) {
  if (!std::isfinite(value)) refuse(option, "a number", value != value ? "nan" : "inf");
}

}  // namespace

std::optional<int> parse_request(int argc, const char* const* argv, Request& request) {
  CLI::App app(about, "sightline-render");
  app.footer(examples);
  RenderSettings& settings = request.settings;
  Texts texts;
  app.add_option("scene", request.scene, "The scene")->option_text("SCENE");
  app.add_option("--out", request.out, "The picture: .exr, .png or .tif; default out/SCENE.png")->option_text("FILE");
  app.add_option("--size", texts.size, "Pixels; default 640x480")->option_text("WxH");
  app.add_option("--samples", settings.samples, "The most of a pixel, to 2^20; default: as many as the scene says")
      ->check(CLI::Range(1u, 1u << 20))
      ->option_text("N");
  app.add_option("--error", settings.error_bound,
                 "The standard error of a pixel's luminance at which it is good enough, and as a share of it where it "
                 "is above 1; default 0: each gets all samples")
      ->option_text("BOUND");
  app.add_option(
         "--shadow-error", texts.shadow_error,
         "The standard error of a pixel's luminance that rays to area lights which are not sent may add; 0 sends "
         "all; default: as the scene says")
      ->option_text("BOUND");
  app.add_option("--depth", texts.depth, "Reflections and refractions, one after the other; default: as the scene says")
      ->check(CLI::Range(0, 1000))
      ->option_text("N");
  app.add_option("--cut-off", texts.cut_off, "What could add less to a pixel is not traced; default: as the scene says")
      ->option_text("X");
  app.add_option("--threads", settings.threads, "To 1024; default 0: all. The picture is the same")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
  app.add_option("--precision", texts.precision, "fast, watertight, precise or exact; default watertight")
      ->option_text("LEVEL");
  app.add_option("--accel", texts.accelerator, "The structure; sightline-view list tells of all")
      ->option_text("NAME[:OPTION=VALUE,...]");
  app.add_option("--set", texts.settings, "An option of the structure; may be repeated")
      ->option_text("ACCEL.OPTION=VALUE")
      ->expected(1)
      ->take_all();
  app.add_option("--camera", settings.camera, "By its name; default: the scene's first one")->option_text("NAME");
  app.add_option("--time", settings.time, "Of the scene's animations, in seconds; default 0")->option_text("T");
  app.add_option("--seed", settings.seed, "Of all that is chosen by chance; default 0")->option_text("N");
  app.add_option("--exposure", request.exposure, "Doubles the light of the picture so many times; default 0")
      ->option_text("EV");
  app.add_option("--aov", texts.aovs,
                 "What is told of pixels beside colors: depth, normal, id, cost, samples; in EXR and TIFF further "
                 "channels of the same file, for PNG files of their own")
      ->option_text("NAME,...");
  app.add_flag("--resume", request.resumes, "Goes on where the same command was stopped");
  app.add_option("--checkpoint", request.checkpoint_interval,
                 "How often what is done is kept in FILE.checkpoint; default 60; 0: only when stopped")
      ->option_text("SECONDS");
  app.add_flag("--preview", request.previews, "A window shows the picture while it is rendered");
  app.add_flag("--plan", request.is_plan, "Only tells what would be simulated, and who asks for it");
  app.add_flag("--explain", request.explains, "Writes what was simulated, and what it took, into FILE.bill.txt");
  app.add_flag("--dated", request.is_dated,
               "The picture's metadata has date and time taken; without, the same picture is the same bytes");
  app.add_flag("--quiet", request.is_quiet, "Nothing on standard error but what goes wrong");
  if (const std::optional<int> status = parse(app, argc, argv)) return status;

  if (request.scene.empty()) throw std::invalid_argument("expected a scene, found none (see --help)");
  if (app.count("--depth") > 0) settings.depth = texts.depth;
  if (app.count("--shadow-error") > 0) settings.shadow_error = texts.shadow_error;
  if (app.count("--cut-off") > 0) settings.cut_off = texts.cut_off;
  for (const auto& [option, value] :
       std::initializer_list<std::pair<const char*, double>>{{"--time", settings.time},
                                                             {"--exposure", request.exposure},
                                                             {"--error", settings.error_bound},
                                                             {"--cut-off", texts.cut_off},
                                                             {"--shadow-error", texts.shadow_error},
                                                             {"--checkpoint", request.checkpoint_interval}}) {
    require_finite(option, value);
  }
  if (settings.error_bound < 0) refuse("--error", "a number from 0", std::to_string(settings.error_bound));
  if (texts.shadow_error < 0) refuse("--shadow-error", "a number from 0", std::to_string(texts.shadow_error));
  if (texts.cut_off < 0) refuse("--cut-off", "a number from 0", std::to_string(texts.cut_off));
  if (std::fabs(request.exposure) > 64) refuse("--exposure", "-64 to 64", std::to_string(request.exposure));
  if (request.checkpoint_interval < 0) {
    refuse("--checkpoint", "seconds from 0", std::to_string(request.checkpoint_interval));
  }
  parse_size(texts.size, settings);
  settings.level = parse_precision(texts.precision);
  parse_structure(texts, settings);
  if (!texts.aovs.empty()) request.aovs = parse_aovs(texts.aovs);
  if (request.out.empty()) request.out = name_of_picture(request.scene);
  check_name(request.out);

  for (const char* name : {"--error", "--shadow-error", "--depth", "--cut-off", "--precision", "--accel", "--set",
                           "--camera", "--time", "--seed", "--exposure"}) {
    if (app.count(name) == 0) continue;
    std::string value;
    for (const std::string& text : app.get_option(name)->results()) value += (value.empty() ? "" : " ") + text;
    request.told.emplace_back(name + 2, value);
  }
  return std::nullopt;
}

}  // namespace sightline::render_tool
