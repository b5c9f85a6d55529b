#include <algorithm>
#include <array>

#include "sightline/scene/round_meshes.h"
#include "sightline/scene/spd/databases.h"
#include "sightline/scene/spd/stage.h"
#include "sightline/shape/mesh_builder.h"

namespace sightline::spd {
namespace {

constexpr int teeth = 36;
/// Of the radius at which gears mesh: less than 1, so that two never touch.
constexpr double outer_radius = 0.995;
constexpr double inner_radius = 0.9;

/// From z = 0 down to -1: two faces of 144 corners and 144 rectangles between them.
TriangleMesh make_gear() {
  struct Corner {
    double radius, turn;  // in teeth
  };
  constexpr std::array<Corner, 4> tooth{
      {{outer_radius, -0.19}, {outer_radius, 0.19}, {inner_radius, 0.3}, {inner_radius, 0.7}}};
  std::vector<Vec3f> rim, below;
  for (int i = 0; i < teeth; ++i) {
    for (const Corner& corner : tooth) {
      const Vec3d out =
          Transform::rotation({0, 0, 1}, (i + corner.turn) * (360.0 / teeth)).vector({corner.radius, 0, 0});
      rim.emplace_back(out);
      below.push_back(rim.back() - Vec3f(0, 0, 1));
    }
  }
  const std::size_t corners = rim.size();
  MeshBuilder builder;
  const auto on_both_faces = [&](std::size_t a, std::size_t b, std::size_t c) {
    builder.triangle(rim[a], rim[b], rim[c]);
    builder.triangle(below[a], below[c], below[b]);
  };
  std::vector<std::size_t> inner;
  for (std::size_t first = 0; first < corners; first += 4) {
    const std::size_t before = (first + corners - 1) % corners;
    on_both_faces(before, first, first + 1);
    on_both_faces(before, first + 1, first + 2);
    inner.push_back(first + 2);
    inner.push_back(first + 3);
  }
  for_each_triangle(static_cast<std::uint32_t>(inner.size()), [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    on_both_faces(inner[a], inner[b], inner[c]);
  });
  for (std::size_t i = 0; i < corners; ++i) {
    const std::size_t next = (i + 1) % corners;
    builder.quad(rim[i], below[i], below[next], rim[next]);
  }
  return builder.take();
}

/// Whole and sevenths: the bright one of the three is 1.
Color gear_color(int x, int y, int z) {
  const auto seventh = [](int number) { return 0.01f + static_cast<float>(number % 7) / 7; };
  const Color color(seventh(5 * (3 * x + 2 * y + z + 1)), seventh(3 * (3 * y + 2 * z + x + 1)),
                    seventh(2 * (3 * z + 2 * x + y + 1)));
  return color / std::max({color.x, color.y, color.z});
}

}  // namespace

Scene make_gears(int size) {
  Scene scene = stage("gears", Up::z, {{-1.1, -2.1, 2.6}, {0, 0, 0}, {0, 0, 1}}, {0, 0, 0},
                      {{2, 4, 4}, {-2, 4, 3}, {2, -2.5, 2.5}, {-1, -4, 2}, {-1.111, -2.121, 2.626}});
  const std::uint32_t floor =
      add_geometry(scene, "floor", make_quad_geometry({2, 2, 0}, {-2, 2, 0}, {-2, -2, 0}, {2, -2, 0}));
  place(scene, root_node, "floor", {}, floor, add_surface(scene, "floor", {{1, 0.85f, 0.7f}, 0.3, 0.6}));

  const std::uint32_t gear = add_geometry(scene, "gear", {std::make_shared<const TriangleMesh>(make_gear()), {}, {}});
  const double overlap = 1 - inner_radius;
  const double radius = 1 / (size - (size - 1) * overlap / 2), thickness = std::min(0.1, 0.5 / size);
  const double step = radius * (2 - overlap);
  for (int z = 0; z < size; ++z) {
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const bool is_glass = (4 * x + 2 * y + z) % 5 == 0;
        const Color color = gear_color(x, y, z);
        const std::string name = "gear " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z);
        const std::uint32_t material =
            add_surface(scene, name.c_str(), is_glass ? Surface{color, 0.2, 0, 0.8, 1.1} : Surface{color});
        const Vec3d center(radius - 1 + x * step, radius - 1 + y * step, 1 - static_cast<double>(z) / size);
        const double turn = (x + y + z) % 2 * (180.0 / teeth);
        place(scene, root_node, name,
              Transform::translation(center) * Transform::rotation({0, 0, 1}, turn) *
                  Transform::scaling({radius, radius, thickness}),
              gear, material);
      }
    }
  }
  return scene;
}

}  // namespace sightline::spd
