/// Stereolithography files: triangles without shared vertices, as text or binary.
#include <bit>
#include <cmath>
#include <cstring>

#include "sightline/io/file_error.h"
#include "sightline/io/polygons.h"
#include "sightline/io/text_reader.h"

namespace sightline {
namespace {

constexpr std::size_t header_size = 80, facet_size = 50;

void add_triangle(Polygons& polygons) {
  for (int i = 0; i < 3; ++i) polygons.corners.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  polygons.sizes.push_back(3);
}

/// 80 bytes of header, the number of facets, and of each facet 12 floats (normal and corners) and 2 bytes more.
Polygons read_binary(const std::filesystem::path& path, std::string_view bytes) {
  static_assert(std::endian::native == std::endian::little);
  Polygons polygons;
  const std::size_t count = (bytes.size() - header_size - 4) / facet_size;
  const char* facet = bytes.data() + header_size + 4;
  for (std::size_t i = 0; i < count; ++i, facet += facet_size) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec3f& p = polygons.positions.emplace_back();
      std::memcpy(&p, facet + 12 * (corner + 1), sizeof p);
      if (!is_finite(p))
        throw FileError(path, 0, "finite coordinates", "NaN or infinity in facet " + std::to_string(i));
    }
    add_triangle(polygons);
  }
  return polygons;
}

/// Words, whatever their lines, but for the names of solids, which may have blanks in them.
Polygons read_text(const std::filesystem::path& path, std::string_view bytes) {
  TextReader reader(path, bytes);
  const auto next = [&reader](std::string_view expected) {
    if (!reader.has_word() && !reader.next_filled_line()) reader.fail_at_end(expected);
    return reader.word();
  };
  const auto take = [&](std::string_view expected) {
    const std::string_view found = next(expected);
    if (found != expected) {
      reader.fail("\"" + std::string(expected) + "\"", "\"" + std::string(found.substr(0, 20)) + "\"");
    }
  };
  Polygons polygons;
  while (reader.next_line()) {
    if (!reader.has_word()) continue;
    take("solid");
    while (true) {
      if (!reader.next_filled_line()) reader.fail_at_end("\"facet\" or \"endsolid\"");
      const std::string_view statement = reader.word();
      if (statement == "endsolid") break;
      if (statement != "facet") {
        reader.fail("\"facet\" or \"endsolid\"", "\"" + std::string(statement.substr(0, 20)) + "\"");
      }
      take("normal");
      for (int axis = 0; axis < 3; ++axis) next("a normal");  // often wrong, sometimes NaN, never used
      take("outer");
      take("loop");
      for (int corner = 0; corner < 3; ++corner) {
        take("vertex");
        Vec3f& p = polygons.positions.emplace_back();
        for (int axis = 0; axis < 3; ++axis) p[axis] = reader.number("a coordinate");
      }
      take("endloop");
      take("endfacet");
      add_triangle(polygons);
    }
  }
  return polygons;
}

}  // namespace

/// Binary headers may begin with "solid" as well, so the size decides first.
Polygons read_stl(const std::filesystem::path& path, std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= header_size + 4) {
    std::memcpy(&count, bytes.data() + header_size, 4);
    if (bytes.size() == header_size + 4 + std::size_t{count} * facet_size) return read_binary(path, bytes);
  }
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes.substr(first).starts_with("solid")) return read_text(path, bytes);
  if (bytes.size() < header_size + 4) {
    throw FileError(path, 0, "\"solid\" or a header of 84 bytes", std::to_string(bytes.size()) + " bytes");
  }
  throw FileError(path, 0,
                  std::to_string(header_size + 4 + std::size_t{count} * facet_size) + " bytes for " +
                      std::to_string(count) + " facets",
                  std::to_string(bytes.size()) + " bytes");
}

}  // namespace sightline
