#include "viz/compare/compare_command.h"

#include <cmath>
#include <filesystem>
#include <iostream>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "sightline/scene/scenes.h"
#include "viz/compare/compare_data.h"
#include "viz/compare/compare_window.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {
namespace {

constexpr const char* about = R"(Two to six structures side by side, on the same scene and the same ray.

  walk        what each makes of one ray: cells in the order of opening, what is culled, the candidates, the hit
  work        what each spends on the rays of one camera, pixel by pixel, on one scale
  difference  what each spends more or less than one of them
  histogram   how that work is spread over the rays, on common axes

All structures must give the same hits, bit for bit; where one does not, that is told, and the exit status is 1. The
table of the ray's walks goes to stdout. Times are in none of this: they differ from run to run.

Examples
  sightline-view compare
      opens a window on six structures around the teapot: H there tells the keys
  sightline-view compare --out walks.png
  sightline-view compare --accel kd-tree,kd-tree:max_leaf_size=32,bih --show work --count candidates --out work.png
  sightline-view compare --show difference --against kd-tree --out difference.png
  sightline-view compare --show histogram --out histogram.svg --out histogram.csv
  sightline-view compare --pick 1000,300 --turn 60 --out picked.png --out picked.json
      the ray through a pixel of the picture, seen from the side; the data have every figure
  sightline-view compare --show all --out teapot.png
      writes teapot-walk.png, teapot-work.png, teapot-difference.png and teapot-histogram.png)";

constexpr const char* heat_about =
    R"(What a structure spends on the rays of a picture, pixel by pixel: cells opened, triangles tested, or both.

Examples
  sightline-view heat
      a window on the teapot's kd-tree: H there tells the keys
  sightline-view heat --accel grid --scene dragon:3 --count candidates --out grid.png
  sightline-view heat --accel bih --out bih.json
      every figure)";

constexpr std::size_t fewest_structures = 2, most_structures = 6;

enum class Form { png, svg, csv, json };

Form form_of(const std::string& out) {
  const std::string extension = extension_of(out);
  if (extension == ".png") return Form::png;
  if (extension == ".svg") return Form::svg;
  if (extension == ".csv") return Form::csv;
  if (extension == ".json") return Form::json;
  refuse("--out", out,
         "a name that ends in .png (picture), .svg (histograms), .csv (histograms) or .json (all figures)");
}

template <class Kinds>
auto parse_name(const std::string& option, const std::string& text, const Kinds& kinds, const std::string& more = "") {
  std::string names;
  for (const auto kind : kinds) {
    if (name_of(kind) == text) return kind;
    names += (names.empty() ? "" : ", ") + std::string(name_of(kind));
  }
  refuse(option, text, "one of " + names + more);
}

Ray<float> parse_pick(const std::string& text, const TriangleMesh& mesh, const CompareLook& look,
                      const CompareLayout& layout) {
  if (const auto at = pixel_in(text)) {
    if (const auto ray = ray_through_pixel(mesh, look, layout, at->x, at->y)) return *ray;
  }
  std::string places;
  for (const PixelFrame& f : layout.pictures()) {
    places += (places.empty() ? "" : "; ") + std::to_string(f.x) + ".." + std::to_string(f.x + f.width - 1) + "," +
              std::to_string(f.y) + ".." + std::to_string(f.y + f.height - 1);
  }
  refuse("--pick", text, "X,Y, a pixel where a panel shows the scene: " + places);
}

/// "dir/teapot.png" as "dir/teapot-work.png".
std::string with_kind(const std::string& out, CompareKind kind) {
  const std::filesystem::path path(out);
  return (path.parent_path() / (path.stem().string() + '-' + std::string(name_of(kind)) + path.extension().string()))
      .string();
}

struct Output {
  std::string path;
  Form form;
  CompareKind kind;  ///< Of a picture.
};

}  // namespace

/// What the command line asks for; all that can be refused has been.
struct CompareCommand::Plan {
  std::vector<AcceleratorSpec> specs;
  CompareLook look;
  CompareSource source;
  PictureSize size;
  std::optional<Ray<float>> ray;
  std::vector<Output> outputs;
  bool needs_screen = false;
};

CompareCommand::CompareCommand(CLI::App& program, const std::string& data_folder, bool is_heat)
    : is_heat_(is_heat),
      command_(program.add_subcommand(is_heat ? "heat" : "compare", is_heat ? heat_about : about)),
      data_(data_folder),
      usual_data_(data_folder),
      structures_(*command_, is_heat ? "kd-tree" : "box-tree,sphere-tree,grid,bsp-tree,kd-tree,bih", !is_heat),
      camera_(*command_),
      show_(is_heat ? "work" : "walk") {
  command_->fallthrough();
  const auto add = [this](const char* name, auto& value, const char* help, const char* form) {
    return command_->add_option(name, value, help)->option_text(form);
  };
  add("--count", count_, "What work is: nodes (cells opened), candidates (tested) or all; default all", "COUNT");
  if (!is_heat) {
    add("--show", show_, "walk, work, difference, histogram or all; default walk", "KIND");
    add("--against", against_, "What others are compared with; default the first of --accel", "NAME");
    add("--alone", alone_, "Only the N-th structure, large; scales stay those of all", "N")->check(CLI::Range(1, 6));
  }
  auto* ray =
      add("--ray", ray_, "Origin and direction; default one from the left that meets much", "OX,OY,OZ,DX,DY,DZ");
  auto* pick = add("--pick", pick_, "The ray through a pixel of the picture instead", "X,Y")->excludes(ray);
  add("--turn", turn_, "Turns the camera to the right after a pick, to see the ray from the side; default 0", "DEGREES")
      ->check(CLI::Range(-180.0, 180.0))
      ->needs(pick);
  add("--size", size_, "Of the picture or window in pixels, from 960x540; default 1920x1080", "WIDTHxHEIGHT");
  add_outs(*command_, outs_, ".png, .svg, .csv or .json");
}

CompareCommand::Plan CompareCommand::plan() const {
  const PictureSize size =
      parse_size_of<CompareLayout>(size_);  // GCC 12 destroys twice what it throws amid a Plan{...}
  const std::string& accelerators = structures_.accelerators();
  Plan plan{{}, {}, {accelerators, structures_.scene(), {}, structures_.settings(), {}}, size, {}, {}, false};
  plan.source.name = command_->get_name();
  try {
    plan.specs = parse_accelerators(accelerators);
    const std::size_t fewest = is_heat_ ? 1 : fewest_structures, most = is_heat_ ? 1 : most_structures;
    if (plan.specs.size() < fewest || plan.specs.size() > most) {
      refuse(
          "--accel", accelerators,
          (is_heat_ ? "one structure, found " : "two to six structures, found ") + std::to_string(plan.specs.size()));
    }
    apply_settings(plan.specs, structures_.settings());
    for (AcceleratorSpec& spec : plan.specs) {
      spec.settings.threads = structures_.threads();
      check_accelerator(spec);
      plan.source.labels.push_back(spec.label);
    }
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  if (data_ != usual_data_) plan.source.common = {"--data", data_};

  CompareLook& look = plan.look;
  const bool has_all = show_ == "all";
  if (!has_all) look.kind = parse_name("--show", show_, compare_kinds, " or all");
  look.work = parse_name("--count", count_, work_kinds);
  camera_.check();
  require_number("--turn", turn_);
  look.azimuth = camera_.azimuth(), look.elevation = camera_.elevation(), look.zoom = camera_.zoom();
  if (!against_.empty()) {
    look.against = 0;
    while (look.against < plan.specs.size() && plan.source.labels[look.against] != against_) ++look.against;
    if (look.against == plan.specs.size()) refuse("--against", against_, "one of --accel " + accelerators);
  }
  if (alone_ > static_cast<int>(plan.specs.size())) {
    refuse("--alone", std::to_string(alone_), "1 to " + std::to_string(plan.specs.size()));
  }
  if (alone_ > 0) look.alone = static_cast<std::size_t>(alone_ - 1);
  if (command_->count("--ray")) plan.ray = parse_ray("--ray", ray_);
  for (const std::string& out : outs_) {
    const Form form = form_of(out);
    plan.needs_screen |= form == Form::png || form == Form::svg;
    const bool is_one = form != Form::png || !has_all;
    for (const CompareKind kind : compare_kinds) {
      if (!is_one) {
        plan.outputs.push_back({with_kind(out, kind), form, kind});
      } else if (kind == look.kind) {
        plan.outputs.push_back({out, form, kind});
      }
    }
  }
  for (const Output& output : plan.outputs) OutputFile check(output.path);  // says now whether it can be written
  return plan;
}

int CompareCommand::run(WindowFrame* frame) const {
  Plan plan = this->plan();
  std::optional<PictureScreen> screen;
  if (plan.needs_screen) screen.emplace();
  Progress progress;
  progress.say("reading " + structures_.scene());
  const auto mesh = load_scene(structures_.scene(), data_);
  std::vector<Compared> compared;
  for (const AcceleratorSpec& spec : plan.specs) {
    progress.say("building " + spec.label);
    compared.push_back({spec.label, make_tracer(spec.accelerator, mesh, spec.settings)});
  }
  const auto [width, height] = plan.size;
  CompareLook& look = plan.look;
  look.ray = plan.ray ? *plan.ray : ray_across(*compared.front().tracer);
  if (command_->count("--pick")) {
    look.ray = parse_pick(pick_, *mesh, look, {width, height, look.alone ? 1 : compared.size()});
    look.azimuth = std::fmod(look.azimuth + turn_, 360);
  }
  const auto held = std::make_shared<CompareSession>(std::move(compared), plan.source);
  CompareSession& session = *held;

  Verdict verdict = verdict_of(session.compared(), session.find(look, width, height, false));
  std::cout << comparison_table(session.compared(), session.picture(look, width, height).findings) << std::flush;
  for (const Output& output : plan.outputs) {
    look.kind = output.kind;
    const bool needs_pixels = output.form != Form::png || look.kind != CompareKind::walk;
    const CompareFindings& findings = session.find(look, width, height, needs_pixels, 1, [&](const std::string& label) {
      progress.say("tracing the picture's rays", label);
    });
    const Verdict found = verdict_of(session.compared(), findings);
    if (verdict.is_same) verdict = found;
    progress.say("drawing " + output.path);
    const ComparePicture picture = session.picture(look, width, height);
    switch (output.form) {
      case Form::png:
        picture.write_png(output.path);
        break;
      case Form::svg:
        picture.histograms().write_svg(output.path, width, height, picture.layout().unit());
        break;
      case Form::csv:
        write_text(output.path, histogram_csv(session.compared(), findings));
        break;
      case Form::json:
        write_text(output.path, comparison_json(session.compared(), findings, look, session.source()).dump(1) + "\n");
        break;
    }
  }
  progress.clear();
  if (!verdict.is_same) std::cerr << "sightline-view: " << verdict.text << '\n';
  if (outs_.empty() && !has_display()) {
    std::cerr << "sightline-view: no display to open a window on; --out FILE.png writes the picture\n";
  } else if (outs_.empty()) {
    open_window<CompareWindow>(frame, held, session, look, width, height, std::cout);
  }
  return verdict.is_same ? 0 : 1;
}

}  // namespace sightline::viz
