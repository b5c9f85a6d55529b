#pragma once
/// Numbers in the buffers of glTF files, and its lists of nodes.

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/io/json_value.h"

namespace sightline {

/// glTF's numbers for types.
enum class GltfComponent : std::uint64_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

/// Elements in a buffer: the one after `first` is `stride` bytes on.
struct GltfElements {
  const char* first;
  std::uint64_t count, stride;
  GltfComponent component;
};

/// All throw FileError, which names the place as a JSON pointer. Sparse accessors are refused.
class GltfAccessors {
 public:
  GltfAccessors(JsonValue document, std::vector<std::string> buffers)
      : document_(std::move(document)), buffers_(std::move(buffers)) {}

  JsonValue accessor(const JsonValue& number) const { return document_["accessors"][number.whole()]; }

  /// The elements of an accessor: of one of these components, `width` of them each. All are within their buffer.
  GltfElements elements(const JsonValue& accessor, std::initializer_list<GltfComponent> components, const char* type,
                        std::uint64_t width) const;

  /// The same as floats; whole numbers of normalized accessors stand for 0 to 1, or -1 to 1.
  std::vector<float> floats(const JsonValue& accessor, const char* type, std::uint64_t width) const;

  /// Three vertices, below `vertices`, for each triangle of a primitive that has some.
  std::vector<std::uint32_t> corners(const JsonValue& primitive, std::uint64_t vertices) const;

  /// The bytes of a buffer view.
  std::string_view view(const JsonValue& number) const;

 private:
  std::string_view bytes_of(const JsonValue& view) const;

  JsonValue document_;
  std::vector<std::string> buffers_;
};

/// Whether a primitive has triangles, not points or lines.
bool gltf_has_triangles(const JsonValue& primitive);

/// The nodes of the scene that the file names, else of its first one, else all that are nobody's children.
std::vector<std::uint64_t> gltf_roots(const JsonValue& document);

}  // namespace sightline
