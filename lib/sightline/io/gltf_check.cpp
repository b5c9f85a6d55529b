#include "sightline/io/gltf_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "sightline/io/gltf_accessors.h"
#include "sightline/io/gltf_buffers.h"
#include "sightline/io/json_value.h"

namespace sightline {
namespace {

using nlohmann::json;

using enum GltfComponent;

/// Bounds the recursion, here and in Assimp.
constexpr int deepest_node = 1000;

class GltfChecker {
 public:
  GltfChecker(const std::filesystem::path& path, const GltfParts& parts)
      : path_(path), json_(parse_json(path, parts.json)), document_(path_, json_) {
    const JsonValue version = document_["asset"]["version"];
    if (!version.text().starts_with("2.")) version.fail("version 2 of glTF");
    accessors_.emplace(document_, read_gltf_buffers(path, document_, parts.binary));
  }

  CheckedGltf check() {
    if (const auto nodes = document_.find("nodes")) {
      is_placed_.resize(nodes->size());
      json roots = json::array();
      for (const std::uint64_t root : gltf_roots(document_)) roots.push_back(add_node(*nodes, root, 1));
      clean_["scenes"] = json::array({json{{"nodes", roots}}});
    }
    if (triangles_ == 0) return {};
    clean_["asset"]["version"] = "2.0";
    clean_["scene"] = 0;
    clean_["buffers"] = json::array({json{{"byteLength", binary_.size()}}});
    return {as_glb(), triangles_};
  }

 private:
  // ---- Nodes

  /// The number of the node's copy.
  std::size_t add_node(const JsonValue& nodes, std::uint64_t number, int depth) {
    const JsonValue node = nodes[number];
    if (is_placed_[number]) node.fail("a node in one place of the tree", "another way to it");
    if (depth > deepest_node) node.fail("nodes at most " + std::to_string(deepest_node) + " deep", "more");
    is_placed_[number] = true;
    json copy = json::object();
    constexpr std::pair<const char*, std::size_t> placements[] = {
        {"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}};
    for (const auto& [name, count] : placements) {
      const auto values = node.find(name);
      if (!values) continue;
      if (values->size() != count) values->fail(std::to_string(count) + " numbers", std::to_string(values->size()));
      for (std::size_t i = 0; i < count; ++i) copy[name].push_back((*values)[i].number());
    }
    if (const auto mesh = node.find("mesh")) place_mesh(*mesh, copy);
    if (const auto children = node.find("children")) {
      for (std::size_t i = 0; i < children->size(); ++i) {
        copy["children"].push_back(add_node(nodes, (*children)[i].whole(), depth + 1));
      }
    }
    clean_["nodes"].push_back(std::move(copy));
    return clean_["nodes"].size() - 1;
  }

  // ---- Meshes

  struct Mesh {
    bool is_known = false;
    std::size_t number = 0;  ///< Of the copy, if it has triangles.
    std::uint64_t triangles = 0, vertices = 0;
  };

  void place_mesh(const JsonValue& number, json& node) {
    const JsonValue meshes = document_["meshes"];
    meshes_.resize(meshes.size());
    const std::uint64_t index = number.whole();
    const JsonValue mesh = meshes[index];
    if (!meshes_[index].is_known) meshes_[index] = add_mesh(mesh);
    triangles_ += meshes_[index].triangles;
    vertices_ += meshes_[index].vertices;
    if (triangles_ > most_triangles || vertices_ > most_triangles) {
      mesh.fail("at most " + std::to_string(most_triangles) + " triangles and vertices where nodes place them", "more");
    }
    if (meshes_[index].triangles > 0) node["mesh"] = meshes_[index].number;
  }

  Mesh add_mesh(const JsonValue& mesh) {
    Mesh added{true};
    json copy = json::object();
    const JsonValue primitives = mesh["primitives"];
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const JsonValue primitive = primitives[i];
      if (!gltf_has_triangles(primitive)) continue;
      const JsonValue positions = accessors_->accessor(primitive["attributes"]["POSITION"]);
      const std::uint64_t vertices = positions["count"].whole();
      const std::vector<std::uint32_t> list = accessors_->corners(primitive, vertices);
      if (list.empty()) continue;
      added.vertices += vertices;
      added.triangles += list.size() / 3;
      if (total_ += vertices + list.size(); total_ > 4 * most_triangles) {
        primitive.fail("fewer vertices and triangles", "more than " + std::to_string(4 * most_triangles));
      }
      const std::size_t position_copy = add_positions(positions);
      copy["primitives"].push_back(
          {{"attributes", {{"POSITION", position_copy}}},
           {"indices", add_accessor(uint32, "SCALAR", list.size(), list.data(), 4 * list.size())}});
    }
    if (added.triangles == 0) return added;
    clean_["meshes"].push_back(std::move(copy));
    added.number = clean_["meshes"].size() - 1;
    return added;
  }

  std::size_t add_positions(const JsonValue& place) {
    const GltfElements found = accessors_->elements(place, {float32}, "VEC3", 3);
    std::vector<float> list(3 * found.count);
    for (std::uint64_t i = 0; i < found.count; ++i) {
      float* p = list.data() + 3 * i;
      std::memcpy(p, found.first + i * found.stride, 12);
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
        place.fail("finite coordinates", "NaN or infinity in vertex " + std::to_string(i));
      }
    }
    return add_accessor(float32, "VEC3", found.count, list.data(), 12 * found.count);
  }

  std::size_t add_accessor(GltfComponent component, const char* type, std::size_t count, const void* data,
                           std::size_t size) {
    clean_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}});
    binary_.append(static_cast<const char*>(data), size);
    clean_["accessors"].push_back({{"bufferView", clean_["bufferViews"].size() - 1},
                                   {"componentType", static_cast<std::uint64_t>(component)},
                                   {"count", count},
                                   {"type", type}});
    return clean_["accessors"].size() - 1;
  }

  // ---- The result

  std::string as_glb() const {
    std::string text = clean_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::uint64_t size = 12 + 8 + text.size() + 8 + binary_.size();
    if (size > std::numeric_limits<std::uint32_t>::max()) throw FileError(path_, 0, "less than 4 GiB", "more");
    std::string glb = "glTF";
    const auto append = [&glb](std::size_t word) {
      static_assert(std::endian::native == std::endian::little);
      const auto narrow = static_cast<std::uint32_t>(word);
      glb.append(reinterpret_cast<const char*>(&narrow), sizeof narrow);
    };
    append(2);
    append(size);
    append(text.size());
    glb += "JSON" + text;
    append(binary_.size());
    glb += std::string("BIN\0", 4) + binary_;
    return glb;
  }

  const std::filesystem::path& path_;
  json json_;
  JsonValue document_;
  std::optional<GltfAccessors> accessors_;
  std::vector<bool> is_placed_;
  std::vector<Mesh> meshes_;
  json clean_;
  std::string binary_;
  std::uint64_t triangles_ = 0, vertices_ = 0, total_ = 0;
};

}  // namespace

CheckedGltf check_gltf(const std::filesystem::path& path, std::string_view bytes) {
  return GltfChecker(path, split_gltf(path, bytes)).check();
}

}  // namespace sightline
