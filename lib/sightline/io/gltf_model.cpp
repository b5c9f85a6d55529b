#include "sightline/io/gltf_model.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <optional>
#include <string>

#include "sightline/io/gltf_accessors.h"
#include "sightline/io/gltf_buffers.h"
#include "sightline/io/gltf_check.h"
#include "sightline/io/gltf_materials.h"
#include "sightline/io/model_bytes.h"
#include "sightline/math/transform.h"

namespace sightline {
namespace {

using enum GltfComponent;

std::string name_of(const JsonValue& json) {
  const auto name = json.find("name");
  return name ? name->text() : "";
}

template <std::size_t N>
std::array<double, N> numbers_of(const JsonValue& json) {
  if (json.size() != N) json.fail(std::to_string(N) + " numbers", std::to_string(json.size()));
  std::array<double, N> numbers;
  for (std::size_t i = 0; i < N; ++i) numbers[i] = json[i].real();
  return numbers;
}

/// Columns of 16 numbers, or translation * rotation * scale, which may be singular.
Affine place_of(const JsonValue& node) {
  Affine place;
  if (const auto matrix = node.find("matrix")) {
    const auto numbers = numbers_of<16>(*matrix);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k) place.rows[i][k] = numbers[4 * k + i];
    }
    return place;
  }
  if (const auto rotation = node.find("rotation")) {
    const auto [x, y, z, w] = numbers_of<4>(*rotation);
    if (x == 0 && y == 0 && z == 0 && w == 0) rotation->fail("a quaternion other than 0");
    place = Transform::rotation(glm::dquat(w, x, y, z)).matrix();
  }
  if (const auto scale = node.find("scale")) {
    const auto factors = numbers_of<3>(*scale);
    for (auto& row : place.rows) {
      for (std::size_t k = 0; k < 3; ++k) row[k] *= factors[k];
    }
  }
  if (const auto translation = node.find("translation")) {
    const auto by = numbers_of<3>(*translation);
    for (std::size_t i = 0; i < 3; ++i) place.rows[i][3] = by[i];
  }
  return place;
}

class GltfReader {
 public:
  GltfReader(const std::filesystem::path& path, const GltfParts& parts)
      : path_(path),
        json_(parse_json(path, parts.json)),
        document_(path_, json_),
        accessors_(checked(), read_gltf_buffers(path, document_, parts.binary)) {}

  Model read() {
    read_gltf_surfaces(document_, accessors_, model_);
    read_gltf_lights(document_, model_);
    read_gltf_cameras(document_, model_);
    if (document_.find("nodes")) read_nodes();
    read_animations();
    check_model(path_, model_);
    return std::move(model_);
  }

 private:
  const JsonValue& checked() const {
    const JsonValue version = document_["asset"]["version"];
    if (!version.text().starts_with("2.")) version.fail("version 2 of glTF");
    const auto required = document_.find("extensionsRequired");
    for (std::size_t i = 0; required && i < required->size(); ++i) {
      const std::string& name = (*required)[i].text();
      const bool changes_geometry = name.find("draco") != std::string::npos ||
                                    name.find("meshopt") != std::string::npos ||
                                    name.find("quantization") != std::string::npos;
      if (changes_geometry && name != "KHR_mesh_quantization") (*required)[i].fail("no compression");
    }
    return document_;
  }

  // ---- Nodes

  /// Depth-first, children in their order.
  void read_nodes() {
    const JsonValue nodes = document_["nodes"];
    numbers_.assign(nodes.size(), nothing);
    struct Open {
      std::uint64_t node;
      std::uint32_t parent;
    };
    std::vector<Open> open;
    const std::vector<std::uint64_t> roots = gltf_roots(document_);
    for (std::size_t i = roots.size(); i > 0; --i) open.push_back({roots[i - 1], nothing});
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      const JsonValue node = nodes[next.node];
      if (numbers_[next.node] != nothing) node.fail("a node in one place of the tree", "another way to it");
      const auto number = static_cast<std::uint32_t>(model_.nodes.size());
      numbers_[next.node] = number;
      model_.nodes.push_back(node_of(node, next.parent));
      if (const auto children = node.find("children")) {
        for (std::size_t i = children->size(); i > 0; --i) open.push_back({(*children)[i - 1].whole(), number});
      }
    }
  }

  ModelNode node_of(const JsonValue& json, std::uint32_t parent) {
    ModelNode node;
    node.name = name_of(json);
    node.parent = parent;
    node.local = place_of(json);
    if (const auto mesh = json.find("mesh")) node.meshes = meshes_of(*mesh);
    if (const auto camera = json.find("camera")) node.camera = number_of(*camera, model_.cameras.size(), "a camera");
    const auto extensions = json.find("extensions");
    if (const auto light = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt) {
      node.light = number_of((*light)["light"], model_.lights.size(), "a light");
    }
    if (const auto visibility = extensions ? extensions->find("KHR_node_visibility") : std::nullopt) {
      if (const auto visible = visibility->find("visible")) node.is_visible = visible->truth();
    }
    return node;
  }

  static std::uint32_t number_of(const JsonValue& json, std::size_t count, const char* what) {
    if (json.whole() >= count) json.fail(std::string(what) + " below " + std::to_string(count));
    return static_cast<std::uint32_t>(json.whole());
  }

  // ---- Meshes

  /// One for each primitive; those that were read before are not read again.
  std::vector<std::uint32_t> meshes_of(const JsonValue& number) {
    const JsonValue meshes = document_["meshes"];
    meshes_.resize(meshes.size());
    const JsonValue mesh = meshes[number.whole()];
    auto& known = meshes_[number.whole()];
    if (known) return *known;
    known.emplace();
    const JsonValue primitives = mesh["primitives"];
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      if (!gltf_has_triangles(primitives[i])) continue;
      ModelMesh added = mesh_of(primitives[i]);
      if (added.triangles.empty()) continue;
      added.name = name_of(mesh);
      known->push_back(static_cast<std::uint32_t>(model_.meshes.size()));
      model_.meshes.push_back(std::move(added));
    }
    return *known;
  }

  ModelMesh mesh_of(const JsonValue& primitive) {
    ModelMesh mesh;
    if (const auto material = primitive.find("material")) {
      mesh.material = number_of(*material, model_.materials.size(), "a material");
    }
    const JsonValue attributes = primitive["attributes"];
    const JsonValue positions = accessors_.accessor(attributes["POSITION"]);
    const std::vector<std::uint32_t> corners = accessors_.corners(primitive, positions["count"].whole());
    const std::vector<float> coordinates = accessors_.floats(positions, "VEC3", 3);
    if (total_ += corners.size() + coordinates.size() / 3; total_ > 4 * most_triangles) {
      primitive.fail("fewer vertices and triangles", "more than " + std::to_string(4 * most_triangles));
    }
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    }
    for (std::size_t i = 0; i < coordinates.size(); i += 3) {
      mesh.positions.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
      if (!is_finite(mesh.positions.back())) {
        positions.fail("finite coordinates", "NaN or infinity in vertex " + std::to_string(i / 3));
      }
    }
    if (const auto normals = attributes.find("NORMAL")) read_normals(*normals, mesh);
    if (const auto uvs = attributes.find("TEXCOORD_0")) {
      const auto list = per_vertex(*uvs, "VEC2", 2, mesh);
      for (std::size_t i = 0; i < list.size(); i += 2) mesh.uvs.emplace_back(list[i], 1 - list[i + 1]);
    }
    return mesh;
  }

  std::vector<float> per_vertex(const JsonValue& number, const char* type, std::uint64_t width,
                                const ModelMesh& mesh) const {
    const JsonValue accessor = accessors_.accessor(number);
    std::vector<float> list = accessors_.floats(accessor, type, width);
    if (list.size() != width * mesh.positions.size()) {
      accessor.fail("one for each of " + std::to_string(mesh.positions.size()) + " vertices",
                    std::to_string(list.size() / width));
    }
    for (const float value : list) {
      if (!std::isfinite(value)) accessor.fail("finite numbers", "NaN or infinity");
    }
    return list;
  }

  /// Where one is no direction, the surface says all of them better.
  void read_normals(const JsonValue& number, ModelMesh& mesh) {
    const auto list = per_vertex(number, "VEC3", 3, mesh);
    for (std::size_t i = 0; i < list.size(); i += 3) {
      const Vec3d normal(list[i], list[i + 1], list[i + 2]);
      const double length = glm::length(normal);
      if (!(length > 0)) {
        model_.warnings.push_back("normals " + number.place() + ": expected directions, found 0; left out");
        mesh.normals.clear();
        return;
      }
      mesh.normals.emplace_back(normal / length);
    }
  }

  // ---- Animations

  void read_animations() {
    const auto list = document_.find("animations");
    for (std::size_t i = 0; list && i < list->size(); ++i) {
      const JsonValue json = (*list)[i];
      ModelAnimation animation;
      animation.name = name_of(json);
      const JsonValue channels = json["channels"], samplers = json["samplers"];
      for (std::size_t k = 0; k < channels.size(); ++k) {
        const JsonValue target = channels[k]["target"], sampler = samplers[channels[k]["sampler"].whole()];
        const auto node = target.find("node");
        const std::string& part = target["path"].text();
        if (!node || part == "weights" || node->whole() >= numbers_.size()) continue;
        const std::uint32_t number = numbers_[node->whole()];
        if (number == nothing) continue;  // it stands nowhere
        animation.tracks.push_back(track_of(sampler, part, target));
        animation.tracks.back().node = number;
      }
      add_rests(animation);
      if (!animation.tracks.empty()) model_.animations.push_back(std::move(animation));
    }
  }

  /// Parts of moved nodes that do not move have one key: where the node rests.
  void add_rests(ModelAnimation& animation) const {
    std::map<std::uint32_t, std::array<bool, 3>> moved;
    for (const ModelTrack& track : animation.tracks) moved[track.node][static_cast<std::size_t>(track.part)] = true;
    constexpr std::array<const char*, 3> names{"translation", "rotation", "scale"};
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const auto found = moved.find(numbers_[i]);
      for (std::size_t part = 0; part < 3 && found != moved.end(); ++part) {
        const auto rest = document_["nodes"][i].find(names[part]);
        if (found->second[part] || !rest) continue;
        ModelTrack track{found->first, static_cast<ModelTrack::Part>(part), true, {0}, {{0, 0, 0, 0}}};
        for (std::size_t k = 0; k < rest->size() && k < 4; ++k) track.values[0][k] = (*rest)[k].real();
        animation.tracks.push_back(std::move(track));
      }
    }
  }

  ModelTrack track_of(const JsonValue& sampler, const std::string& part, const JsonValue& target) {
    ModelTrack track;
    if (part == "rotation") {
      track.part = ModelTrack::Part::rotation;
    } else if (part == "scale") {
      track.part = ModelTrack::Part::scale;
    } else if (part != "translation") {
      target["path"].fail("one of translation, rotation, scale, weights");
    }
    const bool is_turn = track.part == ModelTrack::Part::rotation;
    const std::size_t width = is_turn ? 4 : 3;
    const auto interpolation = sampler.find("interpolation");
    const std::string kind = interpolation ? interpolation->text() : "LINEAR";
    const bool is_spline = kind == "CUBICSPLINE";
    track.is_step = kind == "STEP";
    if (!is_spline && !track.is_step && kind != "LINEAR") interpolation->fail("LINEAR, STEP or CUBICSPLINE");
    if (is_spline)
      model_.warnings.push_back("animation " + sampler.place() +
                                ": expected LINEAR, found CUBICSPLINE, whose keys are kept");
    const JsonValue input = accessors_.accessor(sampler["input"]), output = accessors_.accessor(sampler["output"]);
    const std::vector<float> times = accessors_.floats(input, "SCALAR", 1);
    const std::vector<float> values = accessors_.floats(output, is_turn ? "VEC4" : "VEC3", width);
    // A spline's keys have a tangent on either side.
    const std::size_t stride = is_spline ? 3 * width : width, first = is_spline ? width : 0;
    if (values.size() != times.size() * stride)
      output.fail("a value for each of " + std::to_string(times.size()) + " keys");
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (!std::isfinite(times[i]) || times[i] < 0 || (i > 0 && times[i] <= times[i - 1])) {
        input.fail("times that grow from 0", "others at key " + std::to_string(i));
      }
      track.times.push_back(times[i]);
      auto& value = track.values.emplace_back(std::array<double, 4>{0, 0, 0, 0});
      for (std::size_t k = 0; k < width; ++k) value[k] = values[i * stride + first + k];
    }
    return track;
  }

  const std::filesystem::path& path_;
  nlohmann::json json_;
  JsonValue document_;
  GltfAccessors accessors_;
  std::vector<std::uint32_t> numbers_;  ///< Of glTF's nodes in the model.
  std::vector<std::optional<std::vector<std::uint32_t>>> meshes_;
  std::uint64_t total_ = 0;
  Model model_;
};

}  // namespace

Model read_gltf(const std::filesystem::path& path, std::string_view bytes) {
  return GltfReader(path, split_gltf(path, bytes)).read();
}

}  // namespace sightline
