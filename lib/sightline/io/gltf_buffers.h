#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/io/json_value.h"

namespace sightline {

/// The two parts of a glTF file: for .gltf all of it is JSON.
struct GltfParts {
  std::string_view json;
  std::optional<std::string_view> binary;
};

/// Throws FileError.
GltfParts split_gltf(const std::filesystem::path& path, std::string_view bytes);

/// The contents of all buffers, cut to their byteLength: from the binary part, from data URIs, or from files relative
/// to the folder of `path`. Throws FileError.
std::vector<std::string> read_gltf_buffers(const std::filesystem::path& path, const JsonValue& document,
                                           const std::optional<std::string_view>& binary);

/// What a "uri" says: the content of a data URI, or nothing where it names a file.
std::optional<std::string> gltf_data(const JsonValue& uri);

/// The file that a "uri" names, %XX decoded. Throws FileError for one that is not relative.
std::filesystem::path gltf_file(const JsonValue& uri);

}  // namespace sightline
