#include "tests/scene/scene_mutants.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "sightline/io/file_error.h"
#include "sightline/scene/flatten.h"
#include "sightline/scene/scene_file.h"

namespace sightline {
namespace {

std::string read_all(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::uint32_t below(Random& random, std::size_t count) { return random.below(static_cast<std::uint32_t>(count)); }

using nlohmann::json;

void collect(json& value, std::vector<json*>& all) {
  all.push_back(&value);
  if (!value.is_structured()) return;
  for (json& each : value) collect(each, all);
}

json hostile(Random& random) {
  static const std::vector<json> values = {0,
                                           -1,
                                           1e308,
                                           -1e308,
                                           5e-324,
                                           1e-200,
                                           0.1,
                                           4294967295.,
                                           65536,
                                           "",
                                           "x",
                                           "../",
                                           "/",
                                           true,
                                           false,
                                           {},
                                           json::array(),
                                           json::object(),
                                           {0, 0, 0},
                                           {1e200, 1, 1},
                                           "teapot:2",
                                           "materials.json",
                                           "mutant.json",
                                           3,
                                           360};
  return values[below(random, values.size())];
}

/// Changes the values, so that what comes out is JSON still.
std::string changed(json document, Random& random) {
  for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
    std::vector<json*> all;
    collect(document, all);
    json& value = *all[below(random, all.size())];
    switch (random.below(6)) {
      case 0:
        value = hostile(random);
        break;
      case 1: {
        const json other = *all[below(random, all.size())];
        value = other;
        break;
      }
      case 2:
        if (value.is_structured() && !value.empty()) value.erase(std::next(value.begin(), below(random, value.size())));
        break;
      case 3:
        if (value.is_object() && !value.empty()) {
          const auto member = std::next(value.begin(), below(random, value.size()));
          const json content = member.value();
          value[member.key() + "x"] = content;
        }
        break;
      case 4:
        if (value.is_array() && !value.empty()) {
          const json content = value[below(random, value.size())];
          for (int i = 0; i < 3; ++i) value.push_back(content);
        }
        break;
      default:
        if (value.is_number()) value = value.get<double>() * (random.below(2) ? -1e3 : 1e-3);
    }
  }
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string scrambled(std::string bytes, Random& random) {
  static const std::vector<std::string> tokens = {"-1",
                                                  "0",
                                                  "4294967295",
                                                  "nan",
                                                  "1e39",
                                                  " ",
                                                  "\n",
                                                  "/*",
                                                  "//",
                                                  "\"",
                                                  "{",
                                                  "[",
                                                  "]",
                                                  "}",
                                                  ",",
                                                  ":",
                                                  "\\",
                                                  std::string(4, '\xff'),
                                                  std::string(4, '\0')};
  for (std::uint32_t changes = 1 + random.below(4); changes > 0 && !bytes.empty(); --changes) {
    const std::uint32_t at = below(random, bytes.size());
    const std::string& token = tokens[below(random, tokens.size())];
    switch (random.below(6)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes[at] = static_cast<char>(random.next());
        break;
      case 2:
        bytes.insert(at, token);
        break;
      case 3:
        bytes.erase(at, 1 + random.below(8));
        break;
      case 4:
        bytes.insert(at, bytes.substr(below(random, bytes.size()), 1 + random.below(64)));
        break;
      default:
        bytes.replace(at, std::min(token.size(), bytes.size() - at), token);
    }
  }
  return bytes;
}

bool is_one_clear_line(const std::string& what) {
  return what.find('\n') == std::string::npos && what.find(": expected ") != std::string::npos &&
         what.find(", found ") != std::string::npos;
}

/// What refers to nothing, or empty.
std::string dangling(const Scene& scene) {
  const auto is_number = [](std::uint32_t number, std::size_t count) { return number == no_item || number < count; };
  for (NodeId node = 0; node < scene.graph.size(); ++node) {
    if (!is_number(scene.graph.geometry(node), scene.geometries.size())) return "a node's geometry";
    if (!is_number(scene.graph.material(node), scene.materials.size())) return "a node's material";
    if (node != root_node && scene.graph.parent(node) >= scene.graph.size()) return "a node's parent";
  }
  for (const Material& material : scene.materials) {
    if (!is_number(material.color_texture, scene.textures.size())) return "a material's texture";
    if (!is_number(material.normal_map, scene.textures.size())) return "a material's normals";
    if (material.dents && !is_finite(Dents(*material.dents).normal({0, 0, 1}, Vec3d(0.3)))) return "a material's dents";
  }
  for (const Light& light : scene.lights) {
    if (light.node >= scene.graph.size()) return "a light's node";
  }
  for (const SceneCamera& camera : scene.cameras) {
    if (camera.node >= scene.graph.size() || !(camera.field_of_view > 0 && camera.field_of_view < 180))
      return "a camera";
    if (!(camera.aperture >= 0) || (camera.aperture > 0 && !(camera.focus_distance > 0))) return "a lens";
    if (!(camera.shutter[1] >= camera.shutter[0])) return "a shutter";
  }
  if (const auto* sky = std::get_if<SkyImage>(&scene.surroundings.background);
      sky && !std::filesystem::exists(sky->image))
    return "an image of the sky";
  if (scene.render.samples < 1 || scene.render.samples > most_samples || scene.render.depth > most_bounces)
    return "settings";
  if (!(scene.fog.density >= 0 && scene.ambient.occlusion_distance >= 0)) return "fog or ambient light";
  for (const Geometry& geometry : scene.geometries) {
    const auto* mesh = std::get_if<MeshGeometry>(&geometry.shape);
    if (!mesh) continue;
    const std::size_t count = mesh->mesh->positions().size();
    if (!mesh->normals.empty() && mesh->normals.size() != count) return "normals";
    if (!mesh->uvs.empty() && mesh->uvs.size() != count) return "places in images";
    for (const Vec3f& p : mesh->mesh->positions()) {
      if (!is_finite(p)) return "a vertex that is not finite";
    }
    for (const auto& triangle : mesh->mesh->triangles()) {
      for (const std::uint32_t corner : triangle) {
        if (corner >= count) return "a corner";
      }
    }
  }
  return {};
}

}  // namespace

std::vector<SceneSeed> scene_seeds(const std::filesystem::path& folder) {
  std::vector<SceneSeed> seeds;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json")
      seeds.push_back({entry.path().filename().string(), read_all(entry.path())});
  }
  std::sort(seeds.begin(), seeds.end(), [](const SceneSeed& a, const SceneSeed& b) { return a.name < b.name; });
  return seeds;
}

std::vector<SceneSeed> model_seeds(const std::filesystem::path& folder, std::size_t most_bytes, std::size_t most) {
  std::map<std::string, std::vector<SceneSeed>> by_extension;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.file_size() > most_bytes || !is_scene_file(entry.path())) continue;
    by_extension[entry.path().extension().string()].push_back(
        {entry.path().filename().string(), read_all(entry.path())});
  }
  std::vector<SceneSeed> seeds;
  for (auto& [extension, list] : by_extension) {
    std::sort(list.begin(), list.end(), [](const SceneSeed& a, const SceneSeed& b) {
      return std::pair(a.bytes.size(), a.name) < std::pair(b.bytes.size(), b.name);
    });
    if (list.size() > most) list.resize(most);
    seeds.insert(seeds.end(), list.begin(), list.end());
  }
  return seeds;
}

std::string mutant_of(const SceneSeed& seed, Random& random) {
  const bool is_json = seed.bytes.find_first_not_of(" \n\r\t") == seed.bytes.find('{');
  if (is_json && random.below(4) > 0) {
    json document = json::parse(seed.bytes, nullptr, false, true);
    if (!document.is_discarded()) return changed(std::move(document), random);
  }
  return scrambled(seed.bytes, random);
}

std::string fault_of(const std::filesystem::path& path, bool& is_read) {
  is_read = false;
  try {
    const Scene scene = read_scene(path, {});
    is_read = true;
    if (const std::string fault = dangling(scene); !fault.empty()) return "refers to nothing: " + fault;
    for (const std::string& warning : scene.warnings) {
      if (warning.find('\n') != std::string::npos) return "a warning of more than a line: " + warning;
    }
    try {
      instances_of(scene);
    } catch (const std::invalid_argument& error) {
      if (std::string(error.what()).find('\n') != std::string::npos) return error.what();
    }
  } catch (const FileError& error) {
    if (!is_one_clear_line(error.what())) return std::string("not one clear line: ") + error.what();
  } catch (const std::exception& error) {
    return std::string("not a FileError: ") + error.what();
  }
  return {};
}

}  // namespace sightline
