/// sightline-tour: the newcomer's page. Measures, traces and draws one scene with every structure.

#include <fstream>
#include <iostream>
#include <set>

#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"
#include "sightline/scene/scenes.h"
#include "viz/child_process.h"
#include "viz/heat_map.h"
#include "viz/run_tool.h"
#include "viz/structure.h"
#include "viz/tour_page.h"
#include "viz/traced_picture.h"
#include "viz/virtual_screen.h"
#include "viz/web/web_camera.h"
#include "viz/web/web_page.h"

namespace sightline::viz {
namespace {

constexpr int width = 800, height = 600;              // of traced pictures
constexpr int drawn_width = 960, drawn_height = 720;  // of drawn cells, with their caption readable in half a page
constexpr std::string_view oracle_name = "brute-force";

struct Arguments {
  std::filesystem::path out = "out/tour";
  std::vector<std::string> scenes;
  std::string data = SIGHTLINE_DATA_DIR;
};

/// "[3/12] ..." on stderr.
class Steps {
 public:
  explicit Steps(int count) : count_(count) {}
  void next(const std::string& what) { std::cerr << "[" << ++step_ << "/" << count_ << "] " << what << std::endl; }

 private:
  int count_;
  int step_ = 0;
};

struct LoadedScene {
  std::string name;
  std::shared_ptr<const TriangleMesh> mesh;
};

std::vector<LoadedScene> load_scenes(const Arguments& arguments) {
  std::vector<LoadedScene> scenes;
  for (const std::string& name : arguments.scenes) scenes.push_back({name, load_scene(name, arguments.data)});
  if (!scenes.empty()) return scenes;
  try {
    scenes.push_back({"dragon:3", load_scene("dragon:3", arguments.data)});
  } catch (const FileError&) {
    std::cerr << "      without the Stanford dragon, which data/fetch gets; here is the teapot\n";
    scenes.push_back({"teapot", load_scene("teapot", arguments.data)});
  }
  return scenes;
}

void run_bench(const std::vector<LoadedScene>& scenes, const Arguments& arguments, const std::filesystem::path& json) {
  const auto program = program_folder() / "sightline-bench";
  if (!std::filesystem::exists(program)) {
    throw std::runtime_error(program.string() + ": not there; `./sightline tour` builds it");
  }
  std::vector<std::string> words{"--quick", "--data", arguments.data, "--json", json.string()};
  for (const LoadedScene& scene : scenes) words.insert(words.end(), {"--scene", scene.name});
  if (const int status = run_program(program, words); status != 0) {
    throw std::runtime_error("sightline-bench ended with status " + std::to_string(status));
  }
}

nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  nlohmann::json value = nlohmann::json::parse(file, nullptr, false);
  if (value.is_discarded()) throw FileError(path, 0, "measurements as JSON", "something else");
  return value;
}

/// What the names of a scene's pictures begin with: unlike those of all scenes before it, which are in `taken`.
std::string unique_prefix(const std::string& scene, std::set<std::string>& taken) {
  std::string part = std::filesystem::path(scene).filename().string();
  for (char& c : part) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
  }
  std::string prefix = part;
  for (int count = 2; !taken.insert(prefix).second; ++count) prefix = part + "-" + std::to_string(count);
  return prefix + "_";  // in no part, so that no picture's name can be read in two ways
}

/// Every pixel of all structures against the first of them, and some of its pixels against brute force.
/// \throws std::runtime_error where hits differ
class Witness {
 public:
  Witness(const Camera& camera, const LoadedScene& scene) : camera_(camera), scene_(scene) {}

  const std::vector<Hit<float>>& hits() const { return first_; }

  void hear(const std::string& structure, std::vector<Hit<float>> hits) {
    if (names_.empty()) {
      first_ = std::move(hits);
    } else if (hits != first_) {
      throw std::runtime_error(structure + " and " + names_.front() + " see different pictures of " + scene_.name);
    }
    names_.push_back(structure);
  }

  /// As many pixels as brute force answers in a few seconds.
  std::string ask_oracle() const {
    constexpr double tests = 6e8;
    const double pixels = double(camera_.width) * camera_.height;
    const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels * scene_.mesh->size() / tests))));
    const auto oracle = make_tracer(oracle_name, scene_.mesh);
    const Agreement agreement = compare_with(*oracle, camera_, first_, stride);
    if (agreement.differing > 0) {
      throw std::runtime_error("brute force contradicts " + std::to_string(agreement.differing) + " of " +
                               std::to_string(agreement.compared) + " pixels of " + scene_.name);
    }
    return std::to_string(names_.size()) + " structures, one picture: the hits of all " + with_commas(first_.size()) +
           " pixels are bit-identical. Brute force was asked about " +
           (stride == 1 ? "every pixel" : with_commas(agreement.compared) + " of them, spread evenly,") +
           " and gives the same hits.";
  }

 private:
  Camera camera_;
  const LoadedScene& scene_;
  std::vector<std::string> names_;
  std::vector<Hit<float>> first_;
};

StructureTour draw_partition(const Tracer& tracer, const LoadedScene& scene, const std::filesystem::path& out,
                             const std::string& prefix) {
  CellFilter filter;
  suit_filter(tracer, filter);
  const Partition partition = select_cells(tracer, filter);
  const Caption caption = caption_of(tracer, scene.name);
  const std::string name(tracer.name());
  StructureTour tour{name,
                     prefix + name,
                     caption.subtitle,
                     prefix + name + "-cells.png",
                     summary(partition),
                     prefix + name + "-work.png",
                     0};
  View view;
  view.width = drawn_width;
  view.height = drawn_height;
  PartitionPicture{*scene.mesh, partition, filter.slice, caption, view}.write_png(out / tour.partition);
  return tour;
}

/// The page to walk in: of the picture that `sightline-view page` has as well, so that its command gives it again.
WebModel empty_model(const LoadedScene& scene) {
  const auto [camera, focus] = web_camera(scene.mesh->bounds(), View());
  return web_model(scene.name, scene.mesh, camera, focus);
}

void write_page(const std::filesystem::path& path, WebModel& model) {
  model.command = "./sightline view page --accel all --scene " + model.scene + " " + model.rays.front().label +
                  " --html " + path.filename().string();
  write_text(path, web_page(model));
}

SceneTour tour_scene(const LoadedScene& scene, const std::string& prefix, const Arguments& arguments, Steps& steps) {
  const Camera camera = Camera::facing(scene.mesh->bounds(), width, height);
  SceneTour tour{scene.name, scene.mesh->size(), prefix + "picture.png", {}, {}, {}};
  WebModel model = empty_model(scene);
  Witness witness(camera, scene);
  std::vector<std::vector<std::uint32_t>> works;
  double scale = 0;
  for (const AcceleratorInfo& info : accelerator_infos()) {
    if (info.name == oracle_name) continue;
    steps.next(scene.name + ": tracing and drawing with " + std::string(info.name));
    const auto tracer = make_tracer(info.name, scene.mesh);
    TracedPicture traced = trace_picture(*tracer, camera);
    witness.hear(std::string(info.name), std::move(traced.hits));
    if (model.rays.empty()) model.rays.push_back(middle_ray(*tracer, model.camera));
    const std::size_t others = accelerator_infos().size() - 1;
    model.structures.push_back(web_structure(*tracer, std::string(info.name), model, web_bytes_each(others)));
    tour.structures.push_back(draw_partition(*tracer, scene, arguments.out, prefix));
    double sum = 0;
    for (const std::uint32_t work : traced.work) sum += work;
    tour.structures.back().work_per_pixel = sum / double(traced.work.size());
    scale = std::max(scale, scale_for(traced.work));
    works.push_back(std::move(traced.work));
  }
  if (has_web_library()) {
    tour.page = prefix + "walk.html";
    write_page(arguments.out / tour.page, model);
  } else {
    std::cerr << "      without the page to walk in: three.js was missing when this was built (libjs-three)\n";
  }
  steps.next(scene.name + ": asking brute force");
  tour.verdict = witness.ask_oracle();
  std::cerr << "      " << tour.verdict << '\n';
  write_image(arguments.out / tour.picture, shaded_picture(*scene.mesh, camera, witness.hits()));
  for (std::size_t i = 0; i < works.size(); ++i) {
    write_image(arguments.out / tour.structures[i].heat_map, heat_map(works[i], width, height, scale));
  }
  return tour;
}

int run(int argc, char** argv) {
  CLI::App app(
      "The newcomer's page: measures, traces and draws a scene with every structure, and writes index.html.\n\n"
      "Examples\n  sightline-tour\n  sightline-tour --scene teapot:16 --scene soup:20000 --out out/both\n\n"
      "Exit status: 0 done, 1 failure or structures that disagree, 2 wrong usage.",
      "sightline-tour");
  Arguments arguments;
  app.add_option("--out", arguments.out, "Folder of the page; default out/tour")->type_name("DIR");
  app.add_option("--scene", arguments.scenes,
                 "A scene, or a mesh file; may be repeated. Normally dragon:3, or teapot where the dragon is missing")
      ->type_name("SCENE")
      ->allow_extra_args(false);
  app.add_option("--data", arguments.data, "Folder of scene data")->type_name("DIR");
  if (const std::optional<int> status = parse(app, argc, argv)) return *status;

  // The page is the last file written, and an older one goes first: where there is a page, its pictures are whole.
  const std::filesystem::path page = arguments.out / "index.html", json = arguments.out / "bench.json";
  { const OutputFile probe(page); }
  std::filesystem::remove(page);
  const PictureScreen screen;

  const auto structures = static_cast<int>(accelerator_infos().size()) - 1;
  const int scene_count = std::max(1, static_cast<int>(arguments.scenes.size()));
  Steps steps(2 + scene_count * (structures + 1) + 1);
  steps.next("reading the scene");
  const std::vector<LoadedScene> scenes = load_scenes(arguments);
  steps.next("measuring (sightline-bench --quick)");
  run_bench(scenes, arguments, json);
  std::vector<SceneTour> tours;
  std::set<std::string> prefixes;
  for (const LoadedScene& scene : scenes) {
    tours.push_back(tour_scene(scene, unique_prefix(scene.name, prefixes), arguments, steps));
  }
  steps.next("writing the page");
  write_text(page, tour_page(tours, read_json(json)));
  std::cout << page.string() << std::endl;
  return success;
}

}  // namespace
}  // namespace sightline::viz

int main(int argc, char** argv) {
  return sightline::run_tool("sightline-tour", [&] { return sightline::viz::run(argc, argv); });
}
