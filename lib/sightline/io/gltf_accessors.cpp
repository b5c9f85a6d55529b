#include "sightline/io/gltf_accessors.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace sightline {
namespace {

using enum GltfComponent;
enum Mode : std::uint64_t { triangles = 4, triangle_strip = 5, triangle_fan = 6 };

std::uint64_t size_of(GltfComponent component) {
  return component == int8 || component == uint8 ? 1 : component == int16 || component == uint16 ? 2 : 4;
}

/// Every second triangle of a strip turns the other way round, so two corners change places.
void to_triangles(std::vector<std::uint32_t>& list, std::uint64_t mode) {
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

template <class T>
float as_float(const char* from, bool is_normalized) {
  T value;
  std::memcpy(&value, from, sizeof value);
  if constexpr (std::is_floating_point_v<T>) return value;
  const float scale = is_normalized ? static_cast<float>(std::numeric_limits<T>::max()) : 1;
  return std::max(static_cast<float>(value) / scale, is_normalized ? -1.0f : std::numeric_limits<float>::lowest());
}

}  // namespace

std::string_view GltfAccessors::bytes_of(const JsonValue& view) const {
  const JsonValue buffer_number = view["buffer"];
  const std::uint64_t number = buffer_number.whole();
  if (number >= buffers_.size()) buffer_number.fail("a buffer below " + std::to_string(buffers_.size()));
  const std::uint64_t start = view.whole_or("byteOffset", 0), length = view["byteLength"].whole();
  if (start + length > buffers_[number].size()) {
    view.fail("an end within the buffer's " + std::to_string(buffers_[number].size()) + " bytes",
              std::to_string(start + length));
  }
  return std::string_view(buffers_[number]).substr(start, length);
}

std::string_view GltfAccessors::view(const JsonValue& number) const {
  return bytes_of(document_["bufferViews"][number.whole()]);
}

GltfElements GltfAccessors::elements(const JsonValue& place, std::initializer_list<GltfComponent> components,
                                     const char* type, std::uint64_t width) const {
  const auto component = static_cast<GltfComponent>(place["componentType"].whole());
  if (std::find(components.begin(), components.end(), component) == components.end()) {
    std::string allowed;
    for (const GltfComponent each : components) {
      allowed += (allowed.empty() ? "" : ", ") + std::to_string(static_cast<std::uint64_t>(each));
    }
    place["componentType"].fail("one of the types " + allowed);
  }
  if (place["type"].text() != type) place["type"].fail(type);
  if (const auto sparse = place.find("sparse")) sparse->fail("an accessor that is not sparse", "one");
  const std::uint64_t size = width * size_of(component);
  const JsonValue view = document_["bufferViews"][place["bufferView"].whole()];
  const std::string_view bytes = bytes_of(view);
  const std::uint64_t stride = view.whole_or("byteStride", size), count = place["count"].whole();
  if (stride < size || stride > 252) view["byteStride"].fail(std::to_string(size) + " to 252 bytes");
  if (count == 0) place["count"].fail("at least 1 element");
  const std::uint64_t offset = place.whole_or("byteOffset", 0);
  // All are below 2^53, so only the product needs care.
  if (count > bytes.size() || offset + (count - 1) * stride + size > bytes.size()) {
    place.fail("elements within the view's " + std::to_string(bytes.size()) + " bytes",
               std::to_string(count) + " elements");
  }
  return {bytes.data() + offset, count, stride, component};
}

std::vector<float> GltfAccessors::floats(const JsonValue& place, const char* type, std::uint64_t width) const {
  const GltfElements found = elements(place, {int8, uint8, int16, uint16, float32}, type, width);
  const auto normalized = place.find("normalized");
  const bool is_normalized = normalized && normalized->truth();
  const std::uint64_t size = size_of(found.component);
  std::vector<float> list;
  list.reserve(found.count * width);
  for (std::uint64_t i = 0; i < found.count; ++i) {
    for (std::uint64_t k = 0; k < width; ++k) {
      const char* at = found.first + i * found.stride + k * size;
      list.push_back(found.component == float32 ? as_float<float>(at, false)
                     : found.component == int8  ? as_float<std::int8_t>(at, is_normalized)
                     : found.component == uint8 ? as_float<std::uint8_t>(at, is_normalized)
                     : found.component == int16 ? as_float<std::int16_t>(at, is_normalized)
                                                : as_float<std::uint16_t>(at, is_normalized));
    }
  }
  return list;
}

std::vector<std::uint32_t> GltfAccessors::corners(const JsonValue& primitive, std::uint64_t vertices) const {
  const std::uint64_t mode = primitive.whole_or("mode", Mode::triangles);
  std::vector<std::uint32_t> list;
  if (const auto indices = primitive.find("indices")) {
    const JsonValue place = accessor(*indices);
    const GltfElements found = elements(place, {uint8, uint16, uint32}, "SCALAR", 1);
    for (std::uint64_t i = 0; i < found.count; ++i) {
      std::uint32_t index = 0;
      std::memcpy(&index, found.first + i * found.stride, size_of(found.component));
      if (index >= vertices) {
        place.fail("vertex numbers below " + std::to_string(vertices),
                   std::to_string(index) + " at " + std::to_string(i));
      }
      list.push_back(index);
    }
  } else {
    // As many as a buffer was long enough for.
    elements(accessor(primitive["attributes"]["POSITION"]), {float32}, "VEC3", 3);
    for (std::uint64_t i = 0; i < vertices; ++i) list.push_back(static_cast<std::uint32_t>(i));
  }
  to_triangles(list, mode);
  return list;
}

bool gltf_has_triangles(const JsonValue& primitive) {
  const std::uint64_t mode = primitive.whole_or("mode", Mode::triangles);
  if (mode > triangle_fan) primitive["mode"].fail("a mode from 0 to 6");
  return mode >= Mode::triangles;
}

std::vector<std::uint64_t> gltf_roots(const JsonValue& document) {
  std::vector<std::uint64_t> roots;
  const JsonValue nodes = document["nodes"];
  if (const auto scenes = document.find("scenes"); scenes && scenes->size() > 0) {
    const JsonValue scene = (*scenes)[document.whole_or("scene", 0)];
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

}  // namespace sightline
