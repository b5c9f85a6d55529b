#pragma once
/// What goes before Assimp. Version 5.2 aborts on some broken files, waits or fills the memory on others, and makes
/// meshes with NaN or half of the triangles from yet others; it also follows what does not concern geometry (materials,
/// textures), and splits and reorders by it. So every format is first read strictly, by lines and numbers, and Assimp
/// is given only what was understood, in the one form that it reads exactly.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/math/vec.h"

namespace sightline {

/// Polygons that share vertices.
///   P1  Positions are finite, indices below positions.size(), sizes from 3 to most_corners, and sum to corners.size().
struct Polygons {
  std::vector<Vec3f> positions;
  std::vector<std::uint32_t> corners;  ///< Those of the first polygon, of the second ...
  std::vector<std::uint32_t> sizes;    ///< Corners a polygon.

  std::size_t triangles() const { return corners.size() - 2 * sizes.size(); }
};

/// Cutting a polygon into triangles takes time in the square of its corners.
inline constexpr std::int64_t most_corners = 4096;

/// Each throws FileError. `bytes` is the whole file, not empty.
Polygons read_obj(const std::filesystem::path& path, std::string_view bytes);
Polygons read_off(const std::filesystem::path& path, std::string_view bytes);
Polygons read_ply(const std::filesystem::path& path, std::string_view bytes);
Polygons read_stl(const std::filesystem::path& path, std::string_view bytes);

/// As a binary PLY file.
std::string as_ply(const Polygons& polygons);

}  // namespace sightline
