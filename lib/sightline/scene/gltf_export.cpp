#include "sightline/scene/gltf_export.h"

#include <cmath>
#include <glm/exponential.hpp>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <type_traits>

#include "sightline/io/file_bytes.h"
#include "sightline/scene/gltf_buffer.h"

namespace sightline {
namespace {

using nlohmann::json;

constexpr double radians = std::numbers::pi / 180;

json numbers(const Vec3d& v) { return {v.x, v.y, v.z}; }
json numbers(const Color& c) { return {c.x, c.y, c.z}; }
json numbers(const glm::dquat& q) { return {q.x, q.y, q.z, q.w}; }

class Exporter {
 public:
  explicit Exporter(const Scene& scene) : scene_(scene), buffer_(document_), meshes_(scene.geometries.size()) {}

  std::vector<std::string> write(const std::filesystem::path& path) {
    document_["asset"] = {{"version", "2.0"}, {"generator", "Sightline"}};
    const auto* plain = std::get_if<Color>(&scene_.surroundings.background);
    if (!plain || *plain != Color(0) || scene_.ambient.color != Color(0) || scene_.fog.density > 0) {
      warn("surroundings", "none", "a background, ambient light or fog");
    }
    for (const Material& material : scene_.materials) document_["materials"].push_back(material_of(material));
    add_nodes();
    for (const Light& light : scene_.lights) add(light);
    for (const SceneCamera& camera : scene_.cameras) add(camera);
    for (const Animation& animation : scene_.animations) add(animation);
    json list = json::array();
    for (const std::string& extension : extensions_) list.push_back(extension);
    if (!list.empty()) document_["extensionsUsed"] = std::move(list);
    buffer_.write(path);
    return std::move(warnings_);
  }

 private:
  // ---- Surfaces

  json material_of(const Material& material) {
    json result{{"name", material.name}, {"doubleSided", true}};
    json& pbr = result["pbrMetallicRoughness"];
    Vec3f color = glm::min(material.color, Vec3f(1));
    pbr["baseColorFactor"] = {color.x, color.y, color.z, 1};
    pbr["metallicFactor"] = material.metallic;
    pbr["roughnessFactor"] = material.roughness;
    if (const auto texture = texture_of(material.color_texture)) pbr["baseColorTexture"]["index"] = *texture;
    if (const auto texture = texture_of(material.normal_map)) {
      result["normalTexture"] = {{"index", *texture}, {"scale", material.normal_strength}};
    }
    if (material.dents) warn("material \"" + material.name + "\"", "an image of normals", "dents of noise");
    if (const float brightest = max_norm(material.emission); brightest > 0) {
      result["emissiveFactor"] = numbers(brightest > 1 ? material.emission / brightest : material.emission);
      if (brightest > 1) extend(result, "KHR_materials_emissive_strength")["emissiveStrength"] = brightest;
    }
    if (material.transmission > 0) {
      extend(result, "KHR_materials_transmission")["transmissionFactor"] = material.transmission;
      extend(result, "KHR_materials_ior")["ior"] = material.refractive_index;
    }
    if (material.absorption != Color(0)) {
      json& volume = extend(result, "KHR_materials_volume");
      volume["thicknessFactor"] = 1;
      volume["attenuationDistance"] = 1;
      volume["attenuationColor"] = numbers(glm::exp(-Vec3d(material.absorption)));
    }
    return result;
  }

  json& extend(json& of, const char* extension) {
    extensions_.insert(extension);
    return of["extensions"][extension];
  }

  std::optional<std::size_t> texture_of(std::uint32_t number) {
    if (number == no_item) return std::nullopt;
    const auto [place, is_new] = textures_.try_emplace(number, std::nullopt);
    if (!is_new) return place->second;
    const TextureSource& texture = scene_.textures[number];
    const auto* path = std::get_if<std::filesystem::path>(&texture.source);
    const std::string bytes = path ? read_bytes(*path) : "";
    const bool is_png = bytes.starts_with("\x89PNG"), is_jpeg = bytes.starts_with("\xff\xd8\xff");
    if (!is_png && !is_jpeg) {
      warn("texture \"" + texture.name + "\"", path ? "a PNG or JPEG image" : "an image",
           path ? "another" : "a function of space");
      return std::nullopt;
    }
    document_["images"].push_back({{"name", texture.name},
                                   {"mimeType", is_png ? "image/png" : "image/jpeg"},
                                   {"bufferView", buffer_.add_view(bytes)}});
    document_["textures"].push_back({{"source", document_["images"].size() - 1}});
    return place->second = document_["textures"].size() - 1;
  }

  void warn(const std::string& what, const std::string& expected, const std::string& found) {
    warnings_.push_back(what + ": glTF expected " + expected + ", found " + found + "; left out");
  }

  // ---- Meshes

  /// A geometry with a material, which glTF has within the mesh.
  std::optional<std::size_t> mesh_of(std::uint32_t geometry, std::uint32_t material) {
    const auto* shape = std::get_if<MeshGeometry>(&scene_.geometries[geometry].shape);
    if (!shape || shape->mesh->size() == 0) return std::nullopt;
    const auto [place, is_new] = pairs_.try_emplace({geometry, material}, 0);
    if (!is_new) return place->second;
    json primitive = accessors_of(*shape, geometry);
    if (material != no_item) primitive["material"] = material;
    document_["meshes"].push_back(
        {{"name", scene_.geometries[geometry].name}, {"primitives", json::array({primitive})}});
    return place->second = document_["meshes"].size() - 1;
  }

  json accessors_of(const MeshGeometry& shape, std::uint32_t geometry) {
    json& known = meshes_[geometry];
    if (!known.is_null()) return known;
    const auto& positions = shape.mesh->positions();
    const auto& triangles = shape.mesh->triangles();
    known["attributes"]["POSITION"] = buffer_.add_floats({&positions[0].x, 3 * positions.size()}, "VEC3", 3, true);
    known["indices"] = buffer_.add_indices({triangles[0].data(), 3 * triangles.size()});
    if (!shape.normals.empty()) {
      known["attributes"]["NORMAL"] = buffer_.add_floats({&shape.normals[0].x, 3 * shape.normals.size()}, "VEC3", 3);
    }
    if (!shape.uvs.empty()) {
      std::vector<float> list;
      for (const glm::vec2& uv : shape.uvs) list.insert(list.end(), {uv.x, 1 - uv.y});  // down, as glTF counts
      known["attributes"]["TEXCOORD_0"] = buffer_.add_floats(list, "VEC2", 2);
    }
    return known;
  }

  // ---- Nodes

  void add_nodes() {
    const SceneGraph& graph = scene_.graph;
    numbers_.resize(graph.size());
    materials_.resize(graph.size(), no_item);
    std::uint32_t solids = 0;
    const bool has_root = needs_root();
    std::vector<json> nodes;
    json roots = json::array();
    graph.for_each([&](NodeId id, const Transform&) {
      const NodeId parent = graph.parent(id);
      materials_[id] = graph.material(id) != no_item || id == root_node ? graph.material(id) : materials_[parent];
      if (id == root_node && !has_root) return;
      numbers_[id] = nodes.size();
      json node = json::object();
      if (!graph.name(id).empty()) node["name"] = graph.name(id);
      if (const Affine& local = graph.local(id).matrix(); !local.is_identity()) node["matrix"] = matrix_of(local);
      if (const std::uint32_t geometry = graph.geometry(id); geometry != no_item) {
        if (const auto mesh = mesh_of(geometry, materials_[id])) {
          node["mesh"] = *mesh;
        } else {
          ++solids;
        }
      }
      if (!graph.is_visible(id)) extend(node, "KHR_node_visibility")["visible"] = false;
      if (id == root_node || (parent == root_node && !has_root)) {
        roots.push_back(nodes.size());
      } else {
        nodes[numbers_[parent]]["children"].push_back(nodes.size());
      }
      nodes.push_back(std::move(node));
    });
    if (solids > 0) warn(std::to_string(solids) + " nodes", "triangles", "solids");
    document_["nodes"] = std::move(nodes);
    document_["scenes"] = json::array({json{{"name", scene_.name}, {"nodes", std::move(roots)}}});
    document_["scene"] = 0;
  }

  /// The root is no node of glTF's unless it says something.
  bool needs_root() const {
    const SceneGraph& graph = scene_.graph;
    bool needs = !graph.local(root_node).matrix().is_identity() || graph.geometry(root_node) != no_item ||
                 !graph.is_visible(root_node);
    for (const Light& light : scene_.lights) needs = needs || light.node == root_node;
    for (const SceneCamera& camera : scene_.cameras) needs = needs || camera.node == root_node;
    for (const Animation& animation : scene_.animations) {
      for (const Channel& channel : animation.channels) needs = needs || channel.node == root_node;
    }
    return needs;
  }

  static json matrix_of(const Affine& local) {
    json matrix = json::array();
    for (std::size_t column = 0; column < 4; ++column) {
      for (const auto& row : local.rows) matrix.push_back(row[column]);
      matrix.push_back(column == 3 ? 1 : 0);
    }
    return matrix;
  }

  /// The node itself, or a child of it where it has one such thing already.
  template <class Has>
  json& holder(NodeId id, Has&& has) {
    json& nodes = document_["nodes"];
    if (!has(nodes[numbers_[id]])) return nodes[numbers_[id]];
    nodes[numbers_[id]]["children"].push_back(nodes.size());
    nodes.push_back(json::object());
    return nodes.back();
  }

  // ---- Lights, cameras and animations

  void add(const Light& light) {
    json made{
        {"name", light.name}, {"color", numbers(glm::min(light.color, Color(1)))}, {"intensity", light.intensity}};
    if (std::holds_alternative<AreaLight>(light.kind)) {
      return warn("light \"" + light.name + "\"", "a point, a direction or a spot", "an area");
    }
    made["type"] = std::holds_alternative<PointLight>(light.kind) ? "point" : "directional";
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) {
      made["type"] = "spot";
      made["spot"] = {{"innerConeAngle", spot->inner_angle * radians}, {"outerConeAngle", spot->outer_angle * radians}};
    }
    json& lights = extend(document_, "KHR_lights_punctual")["lights"];
    lights.push_back(std::move(made));
    const std::size_t number = lights.size() - 1;
    json& node = holder(light.node, [](const json& each) { return each.contains("extensions"); });
    node["extensions"]["KHR_lights_punctual"]["light"] = number;
  }

  void add(const SceneCamera& camera) {
    if (camera.aperture > 0) warn("lens of camera \"" + camera.name + "\"", "a pinhole", "an aperture");
    document_["cameras"].push_back({{"name", camera.name},
                                    {"type", "perspective"},
                                    {"perspective", {{"yfov", camera.field_of_view * radians}, {"znear", 0.01}}}});
    const std::size_t number = document_["cameras"].size() - 1;
    json& node = holder(camera.node, [](const json& each) { return each.contains("camera"); });
    node["camera"] = number;
  }

  void add(const Animation& animation) {
    json made{{"name", animation.name}, {"channels", json::array()}, {"samplers", json::array()}};
    for (const Channel& channel : animation.channels) {
      json& node = document_["nodes"][numbers_[channel.node]];
      node.erase("matrix");
      add(made, node, channel, channel.translation, "translation", "VEC3");
      add(made, node, channel, channel.rotation, "rotation", "VEC4");
      add(made, node, channel, channel.scale, "scale", "VEC3");
    }
    if (!made["channels"].empty()) document_["animations"].push_back(std::move(made));
  }

  template <class T>
  void add(json& made, json& node, const Channel& channel, const Track<T>& track, const char* path, const char* type) {
    if (track.is_empty()) return;
    std::vector<float> times, values;
    for (std::size_t i = 0; i < track.times.size(); ++i) {
      times.push_back(static_cast<float>(track.times[i]));
      T value = track.values[i];
      if constexpr (std::is_same_v<T, glm::dquat>) value = glm::normalize(value);
      if (i == 0) node[path] = numbers(value);
      for (const json& each : numbers(value)) values.push_back(each.get<float>());
    }
    made["samplers"].push_back({{"input", buffer_.add_floats(times, "SCALAR", 1, true)},
                                {"output", buffer_.add_floats(values, type, values.size() / times.size())},
                                {"interpolation", track.interpolation == Interpolation::step ? "STEP" : "LINEAR"}});
    made["channels"].push_back(
        {{"sampler", made["samplers"].size() - 1}, {"target", {{"node", numbers_[channel.node]}, {"path", path}}}});
  }

  const Scene& scene_;
  json document_ = json::object();
  GltfBuffer buffer_;
  std::vector<json> meshes_;  ///< What primitives of a geometry have in common; null where that is not written yet.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> pairs_;
  std::map<std::uint32_t, std::optional<std::size_t>> textures_;
  std::vector<std::size_t> numbers_;      ///< Of nodes, in the document.
  std::vector<std::uint32_t> materials_;  ///< Of nodes: their own, or their nearest ancestor's.
  std::set<std::string> extensions_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> write_gltf(const std::filesystem::path& path, const Scene& scene) {
  return Exporter(scene).write(path);
}

}  // namespace sightline
