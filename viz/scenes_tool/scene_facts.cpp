#include "viz/scenes_tool/scene_facts.h"

#include <algorithm>
#include <cstdio>
#include <ostream>
#include <sstream>

#include "sightline/scene/flatten.h"
#include "sightline/scene/scenes.h"

namespace sightline::scenes_tool {
namespace {

/// "12,345"
std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string extent_of(const Aabb& bounds) {
  if (bounds.is_empty()) return "";
  const Vec3d extent = Vec3d(bounds.hi) - Vec3d(bounds.lo);
  return short_number(extent.x) + " x " + short_number(extent.y) + " x " + short_number(extent.z);
}

/// Without what would break a line.
std::string plain(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

std::string shape_of(const Scene& scene, NodeId node) {
  const std::uint32_t number = scene.graph.geometry(node);
  if (number == no_item) return "";
  const Geometry& geometry = scene.geometries[number];
  const auto* mesh = std::get_if<MeshGeometry>(&geometry.shape);
  const std::string what = mesh ? grouped(mesh->mesh->size()) + " triangles" : "a solid";
  return "  [" + plain(geometry.name) + (geometry.name.empty() ? "" : ": ") + what + "]";
}

std::string label(const Scene& scene, NodeId node) {
  std::string text = plain(scene.graph.name(node));
  if (text.empty()) text = "#" + std::to_string(node);
  text += shape_of(scene, node);
  if (const std::uint32_t material = scene.graph.material(node); material != no_item) {
    text += "  " + plain(scene.materials[material].name);
  }
  for (const Light& light : scene.lights) text += light.node == node ? "  light" : "";
  for (const SceneCamera& camera : scene.cameras) text += camera.node == node ? "  camera" : "";
  return text + (scene.graph.is_visible(node) ? "" : "  hidden");
}

template <class List, class Said>
void list(std::ostream& out, const char* title, const List& items, Said&& said) {
  if (items.empty()) return;
  out << title << '\n';
  constexpr std::size_t most = 24;
  for (std::size_t i = 0; i < items.size() && i < most; ++i) out << "  " << said(items[i]) << '\n';
  if (items.size() > most) out << "  ... and " << grouped(items.size() - most) << " more\n";
}

std::string color_text(const Color& color) {
  return short_number(color.x) + " " + short_number(color.y) + " " + short_number(color.z);
}

std::string background_text(const Surroundings& surroundings) {
  std::string text;
  if (const auto* sky = std::get_if<SkyGradient>(&surroundings.background)) {
    text = "sky, zenith " + color_text(sky->zenith) + ", horizon " + color_text(sky->horizon) + ", ground " +
           color_text(sky->ground);
  } else if (const auto* image = std::get_if<SkyImage>(&surroundings.background)) {
    text = image->image.string();
  } else {
    text = color_text(std::get<Color>(surroundings.background));
  }
  if (surroundings.intensity != 1) text += ", times " + short_number(surroundings.intensity);
  return plain(text) + (surroundings.lights ? ", lights" : "");
}

std::vector<std::string> settings_of(const Scene& scene) {
  std::vector<std::string> lines{"background  " + background_text(scene.surroundings)};
  if (scene.ambient.color != Color(0)) {
    const double distance = scene.ambient.occlusion_distance;
    lines.push_back("ambient  " + color_text(scene.ambient.color) +
                    (distance > 0 ? ", shut out within " + short_number(distance) : ""));
  }
  if (scene.fog.density > 0) {
    lines.push_back("fog  " + short_number(scene.fog.density) + ", " + color_text(scene.fog.color));
  }
  lines.push_back("render  " + std::to_string(scene.render.samples) + " samples, depth " +
                  std::to_string(scene.render.depth) + (scene.render.interreflection ? ", interreflection" : ""));
  return lines;
}

}  // namespace

std::vector<Entry> entries(const std::filesystem::path& data_dir) {
  std::vector<Entry> list;
  std::error_code ignored;
  for (const SceneInfo& info : scene_infos()) {
    if (info.name == "dragon" && !std::filesystem::exists(data_dir / "cache" / "dragon_vrip_res3.ply", ignored))
      continue;
    list.push_back({std::string(info.name), std::string(info.description)});
  }
  const auto add = [&](const std::filesystem::path& folder, const std::string& description, auto&& is_shown) {
    const std::size_t first = list.size();
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      if (entry.is_regular_file(ignored) && is_shown(entry.path()))
        list.push_back({entry.path().string(), description});
    }
    std::sort(list.begin() + static_cast<std::ptrdiff_t>(first), list.end(),
              [](const Entry& a, const Entry& b) { return a.spec < b.spec; });
  };
  add(data_dir / "scenes", "a scene file", [](const auto& path) {
    return path.extension() == ".json" && path.stem() != "materials";  // which has nothing to see
  });
  // The dragon's files are scenes by name.
  add(data_dir / "cache", "a model", [](const auto& path) {
    const auto extension = path.extension();
    return !path.stem().string().starts_with("dragon") &&
           (extension == ".ply" || extension == ".obj" || extension == ".glb" || extension == ".gltf" ||
            extension == ".stl" || extension == ".off");
  });
  return list;
}

Facts facts_of(const Scene& scene) {
  const SceneInstances flat = instances_of(scene);
  return {scene.graph.size(), flat.instances.triangles(), flat.solids_left_out, flat.instances.bounds()};
}

std::string row(const Entry& entry, const Facts& facts) {
  const auto padded = [](std::string text, std::size_t width, bool is_right) {
    if (text.size() < width) text.insert(is_right ? 0 : text.size(), width - text.size(), ' ');
    return text;
  };
  std::string text = padded(entry.spec, 34, false) + padded(grouped(facts.nodes), 9, true) + " nodes" +
                     padded(grouped(facts.triangles), 12, true) + " triangles";
  if (facts.solids > 0) text += ", " + grouped(facts.solids) + " solids";
  return text + "  " + extent_of(facts.bounds);
}

void describe(const Scene& scene, std::ostream& out) {
  const SceneGraph& graph = scene.graph;
  constexpr std::uint32_t most_siblings = 8, most_lines = 200, deepest = 40;
  struct Open {
    NodeId node;
    std::uint32_t depth, place;
  };
  std::vector<Open> open{{graph.first_child(root_node), 0, 0}};
  out << plain(scene.name) << '\n';
  std::uint32_t lines = 0;
  while (!open.empty() && lines < most_lines) {
    const Open here = open.back();
    open.pop_back();
    if (here.node == no_node) continue;
    const std::string indent(2 + 2 * here.depth, ' ');
    ++lines;
    if (here.place >= most_siblings) {
      std::uint64_t rest = 0;
      for (NodeId node = here.node; node != no_node; node = graph.next_sibling(node)) ++rest;
      out << indent << "... and " << grouped(rest) << " more\n";
      continue;
    }
    out << indent << label(scene, here.node) << '\n';
    open.push_back({graph.next_sibling(here.node), here.depth, here.place + 1});
    if (here.depth < deepest) open.push_back({graph.first_child(here.node), here.depth + 1, 0});
  }
  if (!open.empty()) out << "  ...\n";

  const Facts facts = facts_of(scene);
  out << grouped(facts.nodes) << " nodes, " << grouped(facts.triangles) << " triangles, " << grouped(facts.solids)
      << " solids; " << extent_of(facts.bounds) << '\n';
  list(out, "materials", scene.materials, [&](const Material& each) {
    std::string text = plain(each.name) + "  color " + color_text(each.color);
    if (each.color_texture != no_item) text += ", texture " + plain(scene.textures[each.color_texture].name);
    if (each.normal_map != no_item) text += ", normals " + plain(scene.textures[each.normal_map].name);
    if (each.dents) text += ", dents";
    if (each.metallic > 0) text += ", metallic " + short_number(each.metallic);
    if (each.transmission > 0) text += ", transmission " + short_number(each.transmission);
    return text + ", roughness " + short_number(each.roughness);
  });
  list(out, "textures", scene.textures, [](const TextureSource& each) {
    const auto* spec = std::get_if<std::string>(&each.source);
    return plain(each.name + "  " + (spec ? *spec : std::get<std::filesystem::path>(each.source).string()));
  });
  list(out, "lights", scene.lights, [&](const Light& each) { return plain(graph.path(each.node)); });
  list(out, "cameras", scene.cameras, [&](const SceneCamera& each) {
    std::string text = plain(graph.path(each.node)) + "  " + short_number(each.field_of_view) + " degrees";
    if (each.aperture > 0) {
      text += ", aperture " + short_number(each.aperture) + ", sharp at " + short_number(each.focus_distance);
    }
    if (each.shutter[1] > each.shutter[0]) {
      text += ", open from " + short_number(each.shutter[0]) + " to " + short_number(each.shutter[1]) + " s";
    }
    return text;
  });
  list(out, "animations", scene.animations, [](const Animation& each) {
    return plain(each.name) + "  " + std::to_string(each.channels.size()) + " nodes, " + short_number(each.duration()) +
           " s";
  });
  list(out, "picture", settings_of(scene), [](const std::string& each) { return each; });
}

}  // namespace sightline::scenes_tool
