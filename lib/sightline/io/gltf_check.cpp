#include "sightline/io/gltf_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "sightline/io/gltf_buffers.h"
#include "sightline/io/json_value.h"

namespace sightline {
namespace {

using nlohmann::json;

/// glTF's numbers for types.
enum Component : std::uint64_t { uint8 = 5121, uint16 = 5123, uint32 = 5125, float32 = 5126 };
enum Mode : std::uint64_t { triangles = 4, triangle_strip = 5, triangle_fan = 6 };

/// Bounds the recursion, here and in Assimp.
constexpr int deepest_node = 1000;

class GltfChecker {
 public:
  GltfChecker(const std::filesystem::path& path, const GltfParts& parts)
      : path_(path), json_(parse_json(path, parts.json)), document_(path_, json_) {
    const JsonValue version = document_["asset"]["version"];
    if (!version.text().starts_with("2.")) version.fail("version 2 of glTF");
    buffers_ = read_gltf_buffers(path, document_, parts.binary);
  }

  CheckedGltf check() {
    if (const auto nodes = document_.find("nodes")) {
      is_placed_.resize(nodes->size());
      json roots = json::array();
      for (const std::uint64_t root : find_roots(*nodes)) roots.push_back(add_node(*nodes, root, 1));
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

  /// Of the scene that the file names, else of its first one, else all that are nobody's children.
  std::vector<std::uint64_t> find_roots(const JsonValue& nodes) const {
    std::vector<std::uint64_t> roots;
    if (const auto scenes = document_.find("scenes"); scenes && scenes->size() > 0) {
      const JsonValue scene = (*scenes)[document_.whole_or("scene", 0)];
      const auto list = scene.find("nodes");
      for (std::size_t i = 0; list && i < list->size(); ++i) roots.push_back((*list)[i].whole());
      return roots;
    }
    std::vector<bool> is_child(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto children = nodes[i].find("children");
      for (std::size_t k = 0; children && k < children->size(); ++k) {
        const std::uint64_t child = (*children)[k].whole();
        if (child < is_child.size()) is_child[child] = true;
      }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!is_child[i]) roots.push_back(i);
    }
    return roots;
  }

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
      const std::uint64_t mode = primitive.whole_or("mode", Mode::triangles);
      if (mode > triangle_fan) primitive["mode"].fail("a mode from 0 to 6");
      if (mode < Mode::triangles) continue;
      const JsonValue positions = accessor(primitive["attributes"]["POSITION"]);
      const std::uint64_t vertices = positions["count"].whole();
      std::vector<std::uint32_t> list = corner_list(primitive, vertices);
      to_triangles(list, mode);
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

  std::vector<std::uint32_t> corner_list(const JsonValue& primitive, std::uint64_t vertices) {
    std::vector<std::uint32_t> list;
    const auto indices = primitive.find("indices");
    if (!indices) {
      // As many as a buffer was long enough for.
      elements(accessor(primitive["attributes"]["POSITION"]), {float32}, "VEC3", 12);
      for (std::uint64_t i = 0; i < vertices; ++i) list.push_back(static_cast<std::uint32_t>(i));
      return list;
    }
    const JsonValue place = accessor(*indices);
    const Elements found = elements(place, {uint8, uint16, uint32}, "SCALAR", 0);
    const std::size_t width = found.component == uint8 ? 1 : found.component == uint16 ? 2 : 4;
    for (std::uint64_t i = 0; i < found.count; ++i) {
      std::uint32_t index = 0;
      std::memcpy(&index, found.first + i * found.stride, width);
      if (index >= vertices) {
        place.fail("vertex numbers below " + std::to_string(vertices),
                   std::to_string(index) + " at " + std::to_string(i));
      }
      list.push_back(index);
    }
    return list;
  }

  /// Every second triangle of a strip turns the other way round, so two corners change places.
  static void to_triangles(std::vector<std::uint32_t>& list, std::uint64_t mode) {
    if (mode == Mode::triangles) {
      list.resize(list.size() - list.size() % 3);
      return;
    }
    std::vector<std::uint32_t> cut;
    for (std::size_t i = 2; i < list.size(); ++i) {
      const bool odd = i % 2 == 1;
      if (mode == triangle_fan) {
        cut.insert(cut.end(), {list[0], list[i - 1], list[i]});
      } else {
        cut.insert(cut.end(), {list[i - 2], list[odd ? i : i - 1], list[odd ? i - 1 : i]});
      }
    }
    list = std::move(cut);
  }

  // ---- Accessors

  struct Elements {
    const char* first;
    std::uint64_t count, stride, component;
  };

  JsonValue accessor(const JsonValue& number) const { return document_["accessors"][number.whole()]; }

  /// The elements of an accessor; `size` bytes each, or as wide as the component where that is 0.
  Elements elements(const JsonValue& place, std::initializer_list<std::uint64_t> components, const char* type,
                    std::uint64_t size) const {
    const std::uint64_t component = place["componentType"].whole();
    if (std::find(components.begin(), components.end(), component) == components.end()) {
      place["componentType"].fail(size > 0 ? "floats (5126)" : "uint8, uint16 or uint32 (5121, 5123 or 5125)");
    }
    if (place["type"].text() != type) place["type"].fail(type);
    if (const auto sparse = place.find("sparse")) sparse->fail("an accessor that is not sparse", "one");
    if (size == 0) size = component == uint8 ? 1 : component == uint16 ? 2 : 4;
    const JsonValue view = document_["bufferViews"][place["bufferView"].whole()];
    const JsonValue buffer_number = view["buffer"];
    const std::uint64_t number = buffer_number.whole();
    if (number >= buffers_.size()) buffer_number.fail("a buffer below " + std::to_string(buffers_.size()));
    const std::uint64_t start = view.whole_or("byteOffset", 0), length = view["byteLength"].whole();
    if (start + length > buffers_[number].size()) {
      view.fail("an end within the buffer's " + std::to_string(buffers_[number].size()) + " bytes",
                std::to_string(start + length));
    }
    const std::uint64_t stride = view.whole_or("byteStride", size), count = place["count"].whole();
    if (stride < size || stride > 252) view["byteStride"].fail(std::to_string(size) + " to 252 bytes");
    if (count == 0) place["count"].fail("at least 1 element");
    const std::uint64_t offset = place.whole_or("byteOffset", 0);
    // All are below 2^53, so only the product needs care.
    if (count > length || offset + (count - 1) * stride + size > length) {
      place.fail("elements within the view's " + std::to_string(length) + " bytes",
                 std::to_string(count) + " elements");
    }
    return {buffers_[number].data() + start + offset, count, stride, component};
  }

  std::size_t add_positions(const JsonValue& place) {
    const Elements found = elements(place, {float32}, "VEC3", 12);
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

  std::size_t add_accessor(std::uint64_t component, const char* type, std::size_t count, const void* data,
                           std::size_t size) {
    clean_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}});
    binary_.append(static_cast<const char*>(data), size);
    clean_["accessors"].push_back({{"bufferView", clean_["bufferViews"].size() - 1},
                                   {"componentType", component},
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
  std::vector<std::string> buffers_;
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
