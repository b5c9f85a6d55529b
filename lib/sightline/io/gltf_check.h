#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace sightline {

/// More triangles would not fit comfortably; a small file may place one mesh any number of times.
inline constexpr std::uint64_t most_triangles = std::uint64_t{1} << 27;

/// A glTF 2 file that says nothing but positions, triangles and nodes, all of them checked, with its buffers behind it.
struct CheckedGltf {
  std::string glb;
  std::uint64_t triangles = 0;  ///< Each placement counted.
};

/// Reads .gltf and .glb, and the buffers that the file names relative to its folder. Sparse and compressed accessors
/// are refused. Throws FileError, which names the place as a JSON pointer.
CheckedGltf check_gltf(const std::filesystem::path& path, std::string_view bytes);

}  // namespace sightline
