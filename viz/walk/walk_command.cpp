#include "viz/walk/walk_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"
#include "viz/virtual_screen.h"
#include "viz/walk/coarse_mesh.h"
#include "viz/walk/walk_data.h"
#include "viz/walk/walk_picture.h"
#include "viz/walk/walk_window.h"

namespace sightline::viz {
namespace {

constexpr const char* about = R"(What a ray does in a structure, step by step.

Each step opens a node or a leaf, tests one candidate of a leaf, or drops what was put aside and lies beyond the far
limit. The picture shows the cells in space, in the hierarchy and as areas, in the same colors; what is put aside, and
what it has cost so far; at the bottom all steps: their depth, and t where they enter. Cells, triangles and ray are drawn
over the mesh, not hidden by it. Of large meshes a coarser one is drawn, of at most 120,000 triangles in pictures and
24,000 in the window; the picture tells how many. The walk itself goes through the whole mesh.

Examples
  sightline-view walk
      a window on a ray in the teapot's kd-tree; H tells the keys
  sightline-view walk --accel box-tree --scene dragon:1 --out walk.png
      the last step as a picture; needs no display
  sightline-view walk --accel bsp-tree --ray=-3,2,2,1,-0.4,-0.3 --step 12 --out step.png --out step.vtp
      another ray, seen after step 12; negative steps count from the end
  sightline-view walk --pick 500,400 --out pick.png
      the ray through a pixel of the picture, then seen from 40 degrees farther to the right
  sightline-view walk --frames out/walk --every 2
      every other step as a picture of its own
  sightline-view walk --set bih.lazy=true --accel bih --after 20 --out grown.png
      what a ray adds to a tree that 20 random rays have made)";

enum class Form { png, json, vtp, gltf };

Form form_of(const std::string& out) {
  const std::string extension = extension_of(out);
  if (extension == ".png") return Form::png;
  if (extension == ".json") return Form::json;
  if (extension == ".vtp") return Form::vtp;
  if (extension == ".gltf") return Form::gltf;
  refuse("--out", out, "a name that ends in .png (picture), .json, .vtp or .gltf (data)");
}

Pixel parse_pick(const std::string& text, const WalkLook& look) {
  const Panel space = look.layout().space;
  const double unit = look.layout().unit();
  const auto at = pixel_in(text);
  if (at && space.contains((at->x + 0.5) / unit, (at->y + 0.5) / unit)) return *at;
  const auto pixel = [&](double x) { return std::to_string(static_cast<int>(std::ceil(x * unit - 0.5))); };
  const auto last = [&](double x) { return std::to_string(static_cast<int>(std::ceil(x * unit - 0.5)) - 1); };
  refuse("--pick", text,
         "X,Y, a pixel that shows the scene: X from " + pixel(space.x) + " to " + last(space.x + space.width) +
             ", Y from " + pixel(space.y) + " to " + last(space.y + space.height));
}

/// Negative ones count from the end.
std::size_t chosen_step(long long step, const WalkModel& model) {
  const auto count = static_cast<long long>(model.last_step()) + 1;
  if (step < -count || step >= count) {
    refuse("--step", std::to_string(step),
           "a step of this walk, from 0 to " + std::to_string(count - 1) + ", or from -1 to -" + std::to_string(count) +
               " counted from the end");
  }
  return static_cast<std::size_t>(step < 0 ? count + step : step);
}

void write_frames(const std::string& folder, std::size_t every, const WalkModel& model, const WalkLook& look,
                  const TriangleMesh& coarse, Progress& progress) {
  for (std::size_t step = 0; step <= model.last_step(); step += every) {
    char name[32];
    std::snprintf(name, sizeof name, "step-%05zu.png", step);
    progress.say("drawing " + folder, "step " + std::to_string(step), double(step) / double(model.last_step() + 1));
    write_walk_png(std::filesystem::path(folder) / name, model, step, look, coarse);
  }
}

}  // namespace

WalkCommand::WalkCommand(CLI::App& program, const std::string& data_folder)
    : command_(program.add_subcommand("walk", about)), data_(data_folder), structure_(*command_), camera_(*command_) {
  command_->fallthrough();
  auto* ray = command_->add_option("--ray", ray_, "Origin and direction; default across the middle")
                  ->option_text("OX,OY,OZ,DX,DY,DZ");
  command_->add_option("--pick", pick_, "The ray through a pixel of the picture instead, seen from aside")
      ->option_text("X,Y")
      ->excludes(ray);
  command_->add_option("--step", step_, "The step to show, from 0; negative from the end; default -1")
      ->option_text("N");
  command_->add_option("--after", after_, "So many random rays are traced before; a lazy structure grows by them")
      ->check(CLI::Range(std::size_t(0), std::size_t(10'000'000)))
      ->option_text("N");
  command_->add_option("--earlier", earlier_, "A ray that is traced before; may be repeated")
      ->option_text("OX,OY,OZ,DX,DY,DZ")
      ->expected(1)
      ->take_all();
  command_->add_option("--size", size_, "Of the picture or window in pixels, from 960x540; default 1920x1080")
      ->option_text("WIDTHxHEIGHT");
  add_outs(*command_, outs_, ".png, .json, .vtp or .gltf");
  auto* frames =
      command_->add_option("--frames", frames_, "A folder that gets a picture of every step")->option_text("DIR");
  command_->add_option("--every", every_, "Of every so-manieth step")
      ->check(CLI::Range(std::size_t(1), std::size_t(1'000'000)))
      ->option_text("K")
      ->needs(frames);
  command_->add_option("--benchmark-frames", benchmark_, "Prints the median time of so many frames of the window")
      ->check(CLI::Range(1, 10'000))
      ->option_text("N")
      ->group("");
}

int WalkCommand::run(WindowFrame* frame) const {
  const PictureSize size = parse_size_of<WalkLayout>(size_);
  camera_.check();
  WalkLook look{camera_.azimuth(), camera_.elevation(), camera_.zoom(), size.width, size.height};
  const AcceleratorSpec structure = structure_.structure();
  std::optional<Ray<float>> ray;
  std::optional<Pixel> pixel;
  std::vector<Ray<float>> earlier;
  if (command_->count("--ray")) ray = parse_ray("--ray", ray_);
  if (command_->count("--pick")) pixel = parse_pick(pick_, look);
  for (const std::string& text : earlier_) earlier.push_back(parse_ray("--earlier", text));
  const bool has_frames = command_->count("--frames") > 0;
  if (has_frames && frames_.empty()) refuse("--frames", frames_, "a folder");
  bool needs_screen = has_frames || benchmark_ > 0;
  for (const std::string& out : outs_) {
    needs_screen |= form_of(out) == Form::png;
    OutputFile check(out);  // says now whether it can be written
  }
  if (has_frames) OutputFile check(std::filesystem::path(frames_) / "step-00000.png");
  const bool is_window = outs_.empty() && !needs_screen;
  if (is_window && !has_display()) {
    throw ScreenError("no display to open a window on; write a file instead: --out FILE.png, .json, .vtp or .gltf");
  }
  std::optional<PictureScreen> screen;
  if (needs_screen) screen.emplace();

  Progress progress;
  progress.say("reading " + structure_.scene());
  const auto mesh = load_scene(structure_.scene(), data_);
  progress.say("building " + structure.label);
  const std::shared_ptr<const Tracer> tracer = make_tracer(structure.accelerator, mesh, structure.settings);
  const auto start = std::chrono::steady_clock::now();
  for (const auto& rays : {random_rays(mesh->bounds(), after_, 1), earlier}) {
    std::vector<Hit<float>> hits(rays.size());
    tracer->closest_hits(rays, hits);
  }
  progress.say("walking through " + structure.label);

  if (pixel) {
    WalkModel usual;
    usual.tracer = tracer.get();
    usual.walk.ray = usual_ray(mesh->bounds());
    ray = ray_through_pixel(usual, look, pixel->x, pixel->y);
    look.azimuth = std::fmod(look.azimuth + aside, 360);
  }
  WalkModel model = model_of(*tracer, ray ? *ray : usual_ray(*tracer));
  model.structure = structure.label;
  model.scene = structure_.scene();
  model.command = "sightline-view walk" + structure_.text();
  if (after_ > 0) model.command += " --after " + std::to_string(after_);
  for (const Ray<float>& before : earlier) model.command += " --earlier=" + text_of(before);
  const std::size_t step = chosen_step(step_, model);

  if (benchmark_ > 0) {
    const FrameTimes times = measure_frames(model, look, benchmark_);
    progress.clear();
    std::printf("%zu triangles drawn; turning %.1f ms, stepping %.1f ms a frame (median of %d)\n", times.triangles,
                times.turn, times.step, benchmark_);
    return 0;
  }
  if (is_window) {
    progress.clear();
    return open_window<WalkWindow>(frame, tracer, model, step, look, std::cout);
  }
  TriangleMesh coarse;
  if (needs_screen) coarse = coarse_mesh(*mesh, most_picture_triangles);
  for (const std::string& out : outs_) {
    progress.say("writing " + out);
    switch (form_of(out)) {
      case Form::png:
        write_walk_png(out, model, step, look, coarse);
        break;
      case Form::json:
        write_text(out, walk_json(model).dump(1) + "\n");
        break;
      case Form::vtp:
        write_walk_vtp(out, model, step);
        break;
      case Form::gltf:
        write_walk_gltf(out, model, step);
        break;
    }
  }
  if (has_frames) write_frames(frames_, every_, model, look, coarse, progress);
  progress.clear();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::fprintf(stderr, "%s on %s: step %zu of 0 to %zu, %.1f s after building\n", structure.label.c_str(),
               structure_.scene().c_str(), step, model.last_step(), taken.count());
  return 0;
}

}  // namespace sightline::viz
