#include "viz/web/page_command.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "sightline/scene/scenes.h"
#include "viz/view_options.h"
#include "viz/web/web_camera.h"
#include "viz/web/web_page.h"

namespace sightline::viz {
namespace {

constexpr const char* about = R"(A page that shows structures, walks of rays and their work, in any browser.

One file that needs no network: turn the scene, go down the depths, walk with a ray step by step through each structure,
see the stack, the far limit and the counters, and charts of work and cells. H shows the keys.
What each ray did goes to stdout: a line a ray and structure.

Examples
  sightline-view page --html teapot.html
  sightline-view page --accel kd-tree,bih,wide-tree --scene dragon:3 --html dragon.html
  sightline-view page --accel all --scene teapot --pick 600,450 --pick 300,500 --html rays.html
      the rays through two pixels of a picture of 1200x900, in all structures but brute force
  sightline-view page --accel kd-tree,kd-tree:max_leaf_size=16 --ray 0,1,9,0,0,-1 --html sizes.html)";

constexpr std::size_t most_rays = 50;

std::vector<AcceleratorSpec> parse_structures(const std::string& text, const std::vector<std::string>& settings) try {
  std::string names = text;
  if (text == "all") {
    names.clear();
    for (const AcceleratorInfo& info : accelerator_infos()) {
      if (info.name != "brute-force") names += (names.empty() ? "" : ",") + std::string(info.name);
    }
  }
  std::vector<AcceleratorSpec> specs = parse_accelerators(names);
  apply_settings(specs, settings);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    check_accelerator(specs[i]);
    for (std::size_t k = 0; k < i; ++k) {
      if (specs[k].label == specs[i].label) refuse("--accel", text, "each structure once");
    }
  }
  return specs;
} catch (const UsageError&) {
  throw;
} catch (const std::invalid_argument& error) {
  throw UsageError(error.what());
}

Pixel parse_pick(const std::string& text, const PictureSize& size) {
  const auto at = pixel_in(text);
  if (!at || at->x < 0 || at->x >= size.width || at->y < 0 || at->y >= size.height) {
    refuse("--pick", text,
           "X,Y, a pixel of the picture: X from 0 to " + std::to_string(size.width - 1) + ", Y from 0 to " +
               std::to_string(size.height - 1));
  }
  return *at;
}

void print_walks(const WebModel& model) {
  std::printf("%-24s %-24s %8s %8s %10s %8s %12s %10s\n", "structure", "ray", "nodes", "leaves", "candidates", "culled",
              "t", "triangle");
  for (const WebStructure& structure : model.structures) {
    for (std::size_t i = 0; i < model.rays.size(); ++i) {
      const Walk& walk = structure.walks[i];
      const TraversalStats stats = walk.statistics();
      std::string t = "-", triangle = "-";
      if (walk.hit.is_hit()) {
        char text[32];
        std::snprintf(text, sizeof text, "%.6g", double(walk.hit.t));
        t = text, triangle = std::to_string(walk.hit.prim_id);
      }
      std::string ray = model.rays[i].label.substr(2);
      ray[ray.find(' ')] = '=';
      std::printf("%-24s %-24s %8llu %8llu %10llu %8llu %12s %10s\n", structure.label.c_str(), ray.c_str(),
                  static_cast<unsigned long long>(stats.nodes), static_cast<unsigned long long>(stats.leaves),
                  static_cast<unsigned long long>(stats.candidates), static_cast<unsigned long long>(stats.culled),
                  t.c_str(), triangle.c_str());
    }
  }
}

}  // namespace

PageCommand::PageCommand(CLI::App& program, const std::string& data)
    : command_(program.add_subcommand("page", about)), data_(data) {
  command_->fallthrough();
  const auto several = [](CLI::Option* option) { option->expected(1)->take_all(); };
  command_
      ->add_option("--accel", accelerators_,
                   "Structures, by commas, or all (but brute force); default kd-tree,box-tree,grid")
      ->option_text("NAME[:OPTION=VALUE,...],...");
  command_->add_option("--scene", scene_, "A scene of --list, with or without :SIZE, or a mesh file; default teapot")
      ->option_text("SCENE");
  several(command_->add_option("--set", settings_, "An option of a structure; may be repeated")
              ->option_text("ACCEL.OPTION=VALUE"));
  command_->add_option("--threads", threads_, "Threads to build with, to 1024; default 0: all")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
  several(
      command_->add_option("--ray", rays_, "Origin and direction; may be repeated")->option_text("OX,OY,OZ,DX,DY,DZ"));
  several(command_
              ->add_option("--pick", picks_,
                           "The ray through a pixel of the picture, from its top left corner; may be repeated. "
                           "Default: the nearest to the middle that hits")
              ->option_text("X,Y"));
  command_->add_option("--size", size_, "Of the picture whose pixels are picked; default 1200x900")
      ->option_text("WIDTHxHEIGHT");
  command_->add_option("--azimuth", azimuth_, "Its camera: degrees to the right of the front; default 24")
      ->check(CLI::Range(-360.0, 360.0))
      ->option_text("DEGREES");
  command_->add_option("--elevation", elevation_, "Its camera: degrees above the horizon; default 20")
      ->check(CLI::Range(-90.0, 90.0))
      ->option_text("DEGREES");
  command_->add_option("--zoom", zoom_, "Its camera: 1 shows everything, 2 comes twice as close")
      ->check(CLI::Range(0.1, 100.0))
      ->option_text("FACTOR");
  command_->add_option("--html", html_, "The page")->option_text("FILE")->required();
}

std::string PageCommand::command_line(const std::vector<std::string>& rays) const {
  std::ostringstream line;
  line << "./sightline view page --accel " << accelerators_ << " --scene " << scene_;
  for (const std::string& setting : settings_) line << " --set " << setting;
  if (command_->count("--size")) line << " --size " << size_;
  if (command_->count("--azimuth")) line << " --azimuth=" << azimuth_;
  if (command_->count("--elevation")) line << " --elevation=" << elevation_;
  if (command_->count("--zoom")) line << " --zoom " << zoom_;
  for (const std::string& ray : rays) line << ' ' << ray;
  line << " --html " << std::filesystem::path(html_).filename().string();
  return line.str();
}

int PageCommand::run() const {
  const PictureSize size = parse_size(size_);
  require_number("--azimuth", azimuth_);
  require_number("--elevation", elevation_);
  require_number("--zoom", zoom_);
  const std::vector<AcceleratorSpec> specs = parse_structures(accelerators_, settings_);
  if (rays_.size() + picks_.size() > most_rays) {
    throw UsageError("--ray and --pick: expected at most " + std::to_string(most_rays) + " rays");
  }
  std::vector<WebRay> rays;
  for (const std::string& ray : rays_) rays.push_back({"--ray " + ray, parse_ray("--ray", ray)});
  for (const std::string& pick : picks_) parse_pick(pick, size);
  if (!has_web_library()) web_page({});  // says what is missing
  { const OutputFile check(html_); }     // says now whether it can be written

  Progress progress;
  progress.say("reading " + scene_);
  const auto mesh = load_scene(scene_, data_);
  const auto [camera, focus] = web_camera(mesh->bounds(), {azimuth_, elevation_, zoom_, size.width, size.height});
  WebModel model = web_model(scene_, mesh, camera, focus);
  for (const std::string& pick : picks_) {
    const auto [x, y] = parse_pick(pick, size);
    rays.push_back({"--pick " + pick, camera.ray(x, y)});
  }
  model.rays = rays;
  for (const AcceleratorSpec& spec : specs) {
    progress.say("building " + spec.label + " of " + with_commas(mesh->size()) + " triangles");
    TracerSettings settings = spec.settings;
    settings.threads = threads_;
    const auto tracer = make_tracer(spec.accelerator, mesh, settings);
    progress.say("walking through " + spec.label);
    if (model.rays.empty()) model.rays.push_back(middle_ray(*tracer, camera));
    model.structures.push_back(web_structure(*tracer, spec.label, model, web_bytes_each(specs.size())));
  }
  progress.say("writing " + html_);
  std::vector<std::string> labels;
  for (const WebRay& ray : model.rays) labels.push_back(ray.label);
  model.command = command_line(labels);
  const std::string page = web_page(model);
  write_text(html_, page);
  progress.clear();
  print_walks(model);
  return 0;
}

}  // namespace sightline::viz
