/// The Object File Format: a header, counts, one vertex a line, one polygon a line. Colors and normals behind them are
/// left out.
#include "sightline/io/polygons.h"
#include "sightline/io/text_reader.h"

namespace sightline {

Polygons read_off(const std::filesystem::path& path, std::string_view bytes) {
  TextReader reader(path, bytes);
  if (!reader.next_filled_line()) reader.fail_at_end("OFF");
  const std::string_view header = reader.word();
  if (header != "OFF" && header != "COFF" && header != "NOFF" && header != "CNOFF" && header != "STOFF") {
    reader.fail("OFF", "\"" + std::string(header.substr(0, 20)) + "\"");
  }
  if (!reader.has_word() && !reader.next_filled_line()) reader.fail_at_end("the numbers of vertices and faces");
  const std::int64_t vertices = reader.integer("the number of vertices");
  const std::int64_t faces = reader.integer("the number of faces");
  // Each takes a line of at least 5 bytes, so the lists grow no larger than the file before its end is found missing.
  if (vertices < 0) reader.fail("a number of vertices", std::to_string(vertices));
  if (faces < 0) reader.fail("a number of faces", std::to_string(faces));

  Polygons polygons;
  for (std::int64_t i = 0; i < vertices; ++i) {
    if (!reader.next_filled_line()) {
      reader.fail_at_end("vertex " + std::to_string(i) + " of " + std::to_string(vertices));
    }
    Vec3f& p = polygons.positions.emplace_back();
    for (int axis = 0; axis < 3; ++axis) p[axis] = reader.number("a coordinate");
  }
  for (std::int64_t i = 0; i < faces; ++i) {
    if (!reader.next_filled_line()) {
      reader.fail_at_end("face " + std::to_string(i) + " of " + std::to_string(faces));
    }
    const std::int64_t corners = reader.integer("the number of corners");
    reader.check_corners(corners);
    for (std::int64_t corner = 0; corner < corners; ++corner) {
      polygons.corners.push_back(reader.index("a vertex number", vertices));
    }
    polygons.sizes.push_back(static_cast<std::uint32_t>(corners));
  }
  return polygons;
}

}  // namespace sightline
