#pragma once
/// The binary side of a glTF file that is being written, and the file.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "sightline/io/json_value.h"

namespace sightline {

/// Appends to a document's bufferViews and accessors, and to the bytes behind them.
class GltfBuffer {
 public:
  explicit GltfBuffer(nlohmann::json& document) : document_(document) {}

  /// The number of the view. Each begins at a multiple of 4 bytes.
  std::size_t add_view(std::string_view bytes);
  /// The number of the accessor. `type` is SCALAR, VEC2, ..., of `width` floats each.
  std::size_t add_floats(std::span<const float> values, const char* type, std::size_t width, bool has_bounds = false);
  std::size_t add_indices(std::span<const std::uint32_t> values);

  /// Completes the document and writes it, by the extension. \throws FileError.
  void write(const std::filesystem::path& path);

 private:
  nlohmann::json& document_;
  std::string bytes_;
};

}  // namespace sightline
