#include "viz/compare/compare_command.h"

#include <cmath>
#include <filesystem>
#include <iostream>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "sightline/scene/scenes.h"
#include "viz/compare/compare_data.h"
#include "viz/compare/compare_window.h"
#include "viz/view_options.h"
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

constexpr std::size_t fewest_structures = 2, most_structures = 6;

enum class Form { png, svg, csv, json };

Form form_of(const std::string& out) {
  std::string extension = std::filesystem::path(out).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
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

Ray<float> parse_ray(const std::string& text) {
  const auto v = finite_numbers(text, 6, ',');
  if (!v) refuse("--ray", text, "OX,OY,OZ,DX,DY,DZ, six finite numbers: an origin and a direction");
  const auto number = [&](std::size_t i) { return static_cast<float>((*v)[i]); };
  const Ray<float> ray{{number(0), number(1), number(2)}, {number(3), number(4), number(5)}};
  if (!is_valid(ray)) refuse("--ray", text, "numbers that are finite as float, and a direction that is not zero");
  return ray;
}

Ray<float> parse_pick(const std::string& text, const TriangleMesh& mesh, const CompareLook& look,
                      const CompareLayout& layout) {
  const auto pixel = finite_numbers(text, 2, ',');
  if (pixel && std::fabs((*pixel)[0]) < 1e6 && std::fabs((*pixel)[1]) < 1e6) {
    const auto [x, y] = std::pair(static_cast<int>((*pixel)[0]), static_cast<int>((*pixel)[1]));
    const bool is_whole = x == (*pixel)[0] && y == (*pixel)[1];
    if (const auto ray = ray_through_pixel(mesh, look, layout, x, y); ray && is_whole) return *ray;
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

CompareCommand::CompareCommand(CLI::App& program, const std::string& data_folder)
    : command_(program.add_subcommand("compare", about)), data_(data_folder), usual_data_(data_folder) {
  command_->fallthrough();
  const auto add = [this](const char* name, auto& value, const char* help, const char* form) {
    return command_->add_option(name, value, help)->option_text(form);
  };
  add("--accel", accelerators_, "Two to six structures; default box-tree,sphere-tree,grid,bsp-tree,kd-tree,bih",
      "NAME[:OPTION=VALUE,...],...");
  add("--scene", scene_, "A scene of list, with or without :SIZE, or a mesh file; default teapot", "SCENE");
  add("--set", settings_, "An option of all entries of a structure; may be repeated", "ACCEL.OPTION=VALUE")
      ->expected(1)
      ->take_all();
  add("--threads", threads_, "Threads to build with, to 1024; default 0: all", "N")->check(CLI::Range(0, 1024));
  add("--show", show_, "walk, work, difference, histogram or all; default walk", "KIND");
  add("--count", count_, "What work is: nodes (cells opened), candidates (tested) or all; default all", "COUNT");
  add("--against", against_, "What others are compared with; default the first of --accel", "NAME");
  add("--alone", alone_, "Only the N-th structure, large; scales stay those of all", "N")->check(CLI::Range(1, 6));
  auto* ray =
      add("--ray", ray_, "Origin and direction; default one from the left that meets much", "OX,OY,OZ,DX,DY,DZ");
  add("--pick", pick_, "The ray through a pixel of the picture instead", "X,Y")->excludes(ray);
  add("--turn", turn_, "Turns the camera to the right after a pick, to see the ray from the side; default 0", "DEGREES")
      ->check(CLI::Range(-180.0, 180.0));
  add("--size", size_, "Of the picture or window in pixels, from 960x540; default 1920x1080", "WIDTHxHEIGHT");
  add("--azimuth", azimuth_, "Camera: degrees to the right of the front; default 24", "DEGREES")
      ->check(CLI::Range(-360.0, 360.0));
  add("--elevation", elevation_, "Camera: degrees above the horizon; default 20", "DEGREES")
      ->check(CLI::Range(-90.0, 90.0));
  add("--zoom", zoom_, "Camera: 1 shows everything, 2 comes twice as close", "FACTOR")->check(CLI::Range(0.1, 100.0));
  add("--out", outs_, "A .png, .svg, .csv or .json file instead of a window; may be repeated", "FILE")
      ->expected(1)
      ->take_all();
}

CompareCommand::Plan CompareCommand::plan() const {
  const PictureSize size =
      parse_size_of<CompareLayout>(size_);  // GCC 12 destroys twice what it throws amid a Plan{...}
  Plan plan{{}, {}, {accelerators_, scene_, {}, settings_, {}}, size, {}, {}, false};
  try {
    plan.specs = parse_accelerators(accelerators_);
    if (plan.specs.size() < fewest_structures || plan.specs.size() > most_structures) {
      refuse("--accel", accelerators_, "two to six structures, found " + std::to_string(plan.specs.size()));
    }
    apply_settings(plan.specs, settings_);
    for (AcceleratorSpec& spec : plan.specs) {
      spec.settings.threads = threads_;
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
  for (const auto& [option, value] :
       {std::pair("--azimuth", azimuth_), {"--elevation", elevation_}, {"--zoom", zoom_}, {"--turn", turn_}}) {
    require_number(option, value);
  }
  look.azimuth = azimuth_, look.elevation = elevation_, look.zoom = zoom_;
  if (command_->count("--against")) {
    look.against = 0;
    while (look.against < plan.specs.size() && plan.source.labels[look.against] != against_) ++look.against;
    if (look.against == plan.specs.size()) refuse("--against", against_, "one of --accel " + accelerators_);
  }
  if (alone_ > static_cast<int>(plan.specs.size())) {
    refuse("--alone", std::to_string(alone_), "1 to " + std::to_string(plan.specs.size()));
  }
  if (alone_ > 0) look.alone = static_cast<std::size_t>(alone_ - 1);
  if (command_->count("--ray")) plan.ray = parse_ray(ray_);
  if (command_->count("--turn") && !command_->count("--pick")) {
    refuse("--turn", std::to_string(turn_), "--pick beside it");
  }
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

int CompareCommand::run() const {
  Plan plan = this->plan();
  std::optional<PictureScreen> screen;
  if (plan.needs_screen) screen.emplace();
  Progress progress;
  progress.say("reading " + scene_);
  const auto mesh = load_scene(scene_, data_);
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
  CompareSession session(std::move(compared), plan.source);

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
  if (outs_.empty() && has_display()) {
    CompareWindow(session, look, width, height, std::cout).run();
  } else if (outs_.empty()) {
    std::cerr << "sightline-view: no display to open a window on; --out FILE.png writes the picture\n";
  }
  if (!verdict.is_same) std::cerr << "sightline-view: " << verdict.text << '\n';
  return verdict.is_same ? 0 : 1;
}

}  // namespace sightline::viz
