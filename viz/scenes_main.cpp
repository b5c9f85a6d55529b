/// sightline-scenes: what scenes there are, what is in one, and one as glTF.

#include <iostream>
#include <memory>
#include <stdexcept>

#include "sightline/io/progress.h"
#include "sightline/scene/gltf_export.h"
#include "sightline/scene/scenes.h"
#include "viz/run_tool.h"
#include "viz/scenes_tool/page.h"
#include "viz/scenes_tool/scene_facts.h"
#include "viz/scenes_tool/thumbnail.h"

namespace sightline::scenes_tool {
namespace {

constexpr const char* about = R"(Lists what --scene takes, a line each; or tells of one scene, and writes it as glTF.

  without SCENE    scenes by name, the scene files of data/scenes, and the models of data/cache: nodes, triangles where
                   nodes place them, solids, and the size of it all; with --out also pictures, a sheet of them and a page
  with SCENE       its tree of nodes, materials, textures, lights, cameras and animations

SCENE is a name with a size ("balls:3"), a scene file (.json; data/README.md teaches the format), or a model: glTF, OBJ,
and whatever else Assimp reads. Of models the nodes, materials, textures, lights and cameras are kept.)";

constexpr const char* examples = R"(
Examples
  sightline-scenes
  sightline-scenes --out out/scenes
  sightline-scenes data/scenes/rocket.json
  sightline-scenes data/scenes/rocket.json --export out/rocket.glb
  sightline-scenes tree:6 --out out/tree

Exit status: 0 all went well, 1 a scene could not be read or a file not be written, 2 wrong usage.
)";

struct Request {
  std::string scene, out, file, size = "320x240";
  int width = 320, height = 240;
};

void parse_size(Request& request) {
  int end = 0;
  if (std::sscanf(request.size.c_str(), "%5dx%5d%n", &request.width, &request.height, &end) != 2 ||
      end != static_cast<int>(request.size.size()) || request.width < 16 || request.height < 16 ||
      request.width > 4096 || request.height > 4096) {
    throw std::invalid_argument("--size: expected WxH from 16x16 to 4096x4096, found \"" + request.size + "\"");
  }
}

void say_warnings(const std::string& spec, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) std::cerr << "sightline-scenes: " << spec << ": " << warning << '\n';
}

int tell_of_all(const Request& request) {
  int status = success;
  std::vector<Shown> shown;
  Progress progress;
  for (const Entry& entry : entries(SIGHTLINE_DATA_DIR)) {
    try {
      progress.say("reading scenes", entry.spec);
      const auto scene = std::make_shared<const Scene>(make_scene(entry.spec, SIGHTLINE_DATA_DIR));
      const Facts facts = facts_of(*scene);
      Shown each{entry.spec, entry.description, row(entry, facts).substr(entry.spec.size()), {}};
      if (!request.out.empty()) {
        each.picture = thumbnail(scene, request.width, request.height);
        shown.push_back(std::move(each));
      }
      progress.clear();
      std::cout << row(entry, facts) << std::endl;
      say_warnings(entry.spec, scene->warnings);
    } catch (const std::exception& error) {
      progress.clear();
      std::cerr << "sightline-scenes: " << error.what() << '\n';
      status = failure;
    }
  }
  if (!request.out.empty()) {
    write_page(request.out, shown);
    std::cerr << "sightline-scenes: wrote " << request.out << "/index.html\n";
  }
  return status;
}

int tell_of_one(const Request& request) {
  const auto scene = std::make_shared<const Scene>(make_scene(request.scene, SIGHTLINE_DATA_DIR));
  say_warnings(request.scene, scene->warnings);
  describe(*scene, std::cout);
  if (!request.out.empty()) {
    write_page(request.out, {{request.scene, scene->name, "", thumbnail(scene, request.width, request.height)}});
    std::cerr << "sightline-scenes: wrote " << request.out << "/index.html\n";
  }
  if (!request.file.empty()) {
    say_warnings(request.file, write_gltf(request.file, *scene));
    std::cerr << "sightline-scenes: wrote " << request.file << '\n';
  }
  return success;
}

int run(int argc, char** argv) {
  CLI::App app(about, "sightline-scenes");
  app.footer(examples);
  Request request;
  app.add_option("scene", request.scene, "The one to tell of; normally all are listed")->option_text("SCENE");
  app.add_option("--out", request.out, "Where pictures and a page of them go")->option_text("DIR");
  app.add_option("--size", request.size, "Pixels of a picture; default 320x240")->option_text("WxH");
  app.add_option("--export", request.file, "Writes the scene as glTF 2: .glb, or .gltf with its data within")
      ->option_text("FILE");
  if (const std::optional<int> status = parse(app, argc, argv)) return *status;
  parse_size(request);
  if (!request.scene.empty()) return tell_of_one(request);
  if (!request.file.empty()) throw std::invalid_argument("--export: expected a scene to write, found none");
  return tell_of_all(request);
}

}  // namespace
}  // namespace sightline::scenes_tool

int main(int argc, char** argv) {
  return sightline::run_tool("sightline-scenes", [&] { return sightline::scenes_tool::run(argc, argv); });
}
