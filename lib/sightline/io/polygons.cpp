#include "sightline/io/polygons.h"

#include <bit>
#include <cstring>

namespace sightline {

std::string as_ply(const Polygons& polygons) {
  static_assert(std::endian::native == std::endian::little && sizeof(Vec3f) == 12);
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(polygons.positions.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(polygons.sizes.size()) + "\nproperty list uint uint vertex_indices\nend_header\n";
  const std::size_t header = bytes.size(), vertices = 12 * polygons.positions.size();
  bytes.resize(header + vertices + 4 * (polygons.sizes.size() + polygons.corners.size()));
  char* end = bytes.data() + header;
  const auto append = [&end](const void* from, std::size_t count) {
    std::memcpy(end, from, count);
    end += count;
  };
  append(polygons.positions.data(), vertices);
  const std::uint32_t* corner = polygons.corners.data();
  for (const std::uint32_t size : polygons.sizes) {
    append(&size, 4);
    append(corner, 4 * std::size_t{size});
    corner += size;
  }
  return bytes;
}

}  // namespace sightline
