#include "sightline/scene/scene_members.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

namespace sightline {
namespace {

using Names = std::string_view;

constexpr auto scene =
    std::to_array<Names>({"$schema", "name", "include", "textures", "materials", "geometries", "groups", "objects",
                          "animations", "background", "ambient", "fog", "render"});
constexpr auto texture = std::to_array<Names>({"procedural", "image", "data"});
constexpr auto material =
    std::to_array<Names>({"color", "color_texture", "normal_map", "normal_strength", "dents", "roughness", "metallic",
                          "transmission", "refractive_index", "absorption", "emission"});
constexpr auto dents =
    std::to_array<Names>({"height", "noise", "fractal", "octaves", "lacunarity", "gain", "frequency", "warp", "seed"});
constexpr auto geometry = std::to_array<Names>(
    {"mesh", "solid", "csg", "sphere", "box", "quad", "lathe", "vertices", "triangles", "normals", "uvs"});
constexpr auto sphere = std::to_array<Names>({"radius", "segments"});
constexpr auto box = std::to_array<Names>({"lo", "hi"});
constexpr auto quad = std::to_array<Names>({"width", "height", "repeat"});
constexpr auto lathe = std::to_array<Names>({"profile", "segments", "smooth"});
constexpr auto object = std::to_array<Names>({"name", "parent", "transform", "material", "geometry", "use", "scene",
                                              "light", "camera", "visible", "children", "repeat"});
constexpr auto step = std::to_array<Names>({"translate", "rotate", "scale", "matrix", "look_at"});
constexpr auto rotation = std::to_array<Names>({"axis", "degrees"});
constexpr auto look_at = std::to_array<Names>({"eye", "target", "up"});
constexpr auto light =
    std::to_array<Names>({"kind", "color", "intensity", "inner_angle", "outer_angle", "width", "height"});
constexpr auto camera = std::to_array<Names>({"field_of_view", "aperture", "focus_distance", "shutter"});
constexpr auto background =
    std::to_array<Names>({"color", "zenith", "horizon", "ground", "image", "rotation", "intensity", "lights"});
constexpr auto ambient = std::to_array<Names>({"color", "occlusion_distance"});
constexpr auto fog = std::to_array<Names>({"density", "color"});
constexpr auto render = std::to_array<Names>({"samples", "depth", "interreflection", "cut_off", "shadow_error"});
constexpr auto repeat = std::to_array<Names>({"count", "transform"});
constexpr auto animation = std::to_array<Names>({"name", "loop", "channels"});
constexpr auto channel = std::to_array<Names>({"node", "translation", "rotation", "scale"});
constexpr auto track = std::to_array<Names>({"interpolation", "times", "values"});

constexpr std::array<SceneMembers, 25> kinds{{{"scene", scene},
                                              {"texture", texture},
                                              {"material", material},
                                              {"dents", dents},
                                              {"geometry", geometry},
                                              {"sphere", sphere},
                                              {"box", box},
                                              {"quad", quad},
                                              {"lathe", lathe},
                                              {"object", object},
                                              {"step", step},
                                              {"rotation", rotation},
                                              {"look_at", look_at},
                                              {"light", light},
                                              {"camera", camera},
                                              {"background", background},
                                              {"ambient", ambient},
                                              {"fog", fog},
                                              {"render", render},
                                              {"repeat", repeat},
                                              {"animation", animation},
                                              {"channel", channel},
                                              {"translation_track", track},
                                              {"rotation_track", track},
                                              {"scale_track", track}}};

std::string list_of(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

/// Letters to insert, delete or replace. Levenshtein, "Binary Codes Capable of Correcting Deletions, Insertions, and
/// Reversals", 1966.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1);
  std::iota(before.begin(), before.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    row[0] = i + 1;
    for (std::size_t k = 0; k < b.size(); ++k) {
      row[k + 1] = std::min({before[k + 1] + 1, row[k] + 1, before[k] + (a[i] != b[k])});
    }
    before.swap(row);
  }
  return before[b.size()];
}

std::string nearest(std::string_view found, std::span<const std::string_view> names) {
  constexpr std::size_t longest = 40;  // of what could be meant for one of them
  if (found.size() > longest) return {};
  const auto best = std::min_element(names.begin(), names.end(), [&](std::string_view a, std::string_view b) {
    return distance(found, a) < distance(found, b);
  });
  if (best == names.end() || distance(found, *best) > 2) return {};
  return " (is \"" + std::string(*best) + "\" meant?)";
}

}  // namespace

std::span<const SceneMembers> scene_members() { return kinds; }

void check_members(const JsonValue& json, std::string_view kind) {
  const auto known =
      std::find_if(kinds.begin(), kinds.end(), [&](const SceneMembers& each) { return each.kind == kind; });
  json.for_each_member([&](const std::string& name, const JsonValue&) {
    if (std::find(known->names.begin(), known->names.end(), name) != known->names.end()) return;
    json.fail("members of a " + std::string(kind) + ", which are " + list_of(known->names),
              "\"" + name.substr(0, 40) + "\"" + nearest(name, known->names));
  });
}

std::string_view one_member(const JsonValue& json, std::span<const std::string_view> names) {
  std::vector<std::string_view> found;
  for (const std::string_view name : names) {
    if (json.find(std::string(name).c_str())) found.push_back(name);
  }
  if (found.size() != 1) json.fail("one of " + list_of(names), found.empty() ? "none" : list_of(found));
  return found.front();
}

}  // namespace sightline
