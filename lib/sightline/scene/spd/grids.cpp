/// Databases whose points stand in rows.

#include <array>
#include <cmath>
#include <numbers>

#include "sightline/scene/round_meshes.h"
#include "sightline/scene/spd/databases.h"
#include "sightline/scene/spd/stage.h"
#include "sightline/scene/teapot.h"
#include "sightline/shape/mesh_builder.h"

namespace sightline::spd {
namespace {

/// A normally distributed number that a seed decides: Box and Muller's polar method on a linear congruential generator,
/// as Press et al., "Numerical Recipes in C", 1988, have them (GASDEV, and the quick generator of modulus 134456).
double gaussian(std::int64_t seed) {
  constexpr std::int64_t modulus = 134'456, factor = 8121, increment = 28'411;
  const auto uniform = [](std::int64_t number) { return 2 * static_cast<double>(number) / modulus - 1; };
  for (std::int64_t second = seed;;) {
    const std::int64_t first = (increment + second * factor) % modulus;
    second = (increment + first * factor) % modulus;
    const double x = uniform(first), y = uniform(second);
    const double square = x * x + y * y;
    if (square < 1) return x * std::sqrt(-2 * std::log(square) / square);
  }
}

/// Heights over (2^levels + 1)^2 points, halving squares.
class Mountain {
 public:
  explicit Mountain(int levels)
      : levels_(levels), cells_(1 << levels), heights_((std::size_t(cells_) + 1) * (std::size_t(cells_) + 1)) {
    for (int width = cells_; width > 1; width /= 2) {
      for (int y = 0; y < cells_; y += width) {
        for (int x = 0; x < cells_; x += width) split(x, y, width);
      }
    }
  }

  TriangleMesh mesh() const {
    std::vector<Vec3f> positions;
    for (int y = 0; y <= cells_; ++y) {
      for (int x = 0; x <= cells_; ++x) positions.emplace_back(Vec3d(place(x), place(y), heights_[index(x, y)]));
    }
    std::vector<TriangleMesh::Corners> triangles;
    for (int y = 0; y < cells_; ++y) {
      for (int x = 0; x < cells_; ++x) {
        const auto a = static_cast<std::uint32_t>(index(x, y)), b = a + 1;
        const auto d = static_cast<std::uint32_t>(index(x, y + 1)), c = d + 1;
        triangles.push_back({a, b, c});
        triangles.push_back({c, d, a});
      }
    }
    return {std::move(positions), std::move(triangles)};
  }

 private:
  static constexpr double extent = 2;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * (static_cast<std::size_t>(cells_) + 1) + static_cast<std::size_t>(x);
  }
  double place(int i) const { return -1 + extent * i / cells_; }

  /// Depends on where the point is, not on how fine the grid is. A number of 16 bits, of which he had whole shifts up
  /// to 7 levels, and which is rounded down beyond.
  double random(int x, int y) const {
    constexpr std::int64_t mountain_number = 21;
    const auto scaled = [this](int coordinate, int bits) {
      const auto value = static_cast<std::uint64_t>(coordinate);
      return bits >= levels_ ? value << (bits - levels_) : value >> (levels_ - bits);
    };
    return gaussian(mountain_number +
                    static_cast<std::int64_t>((scaled(x, 23) + scaled(y, 15) + scaled(x, 7)) & 0xffff));
  }

  /// The dimension of the surface is 2.2.
  void split(int x, int y, int side) {
    const int half = side / 2;
    const double ratio = 2 / std::exp2(1 / 1.2);
    const double rise = half * extent / cells_ * std::sqrt(ratio * ratio - 1);
    const double ll = heights_[index(x, y)], lr = heights_[index(x + side, y)];
    const double ul = heights_[index(x, y + side)], ur = heights_[index(x + side, y + side)];
    const auto raise = [&](int px, int py, double mean, double by) {
      heights_[index(px, py)] = mean + by * random(px, py);
    };
    raise(x + half, y, (ll + lr) / 2, rise);
    raise(x + side, y + half, (lr + ur) / 2, rise);
    raise(x + half, y + side, (ur + ul) / 2, rise);
    raise(x, y + half, (ul + ll) / 2, rise);
    raise(x + half, y + half, (ll + lr + ur + ul) / 4, 1.4142136 * rise);
  }

  int levels_, cells_;
  std::vector<double> heights_;
};

}  // namespace

Scene make_mountain(int levels) {
  Scene scene = stage("mountain", Up::z, {{-1.6, 1.6, 1.7}, {0, 0, 0}, {0, 0, 1}}, {0, 0, 0}, {{-100, -100, 100}});
  const std::uint32_t sphere = add_geometry(scene, "sphere", make_sphere_geometry());
  const NodeId crystal = scene.graph.add(root_node, "crystal", Transform::translation({-0.8, 0.8, 1}));
  scene.graph.set_material(crystal, add_surface(scene, "crystal", {{1, 1, 1}, 0.1, 0.1, 0.9, 1.5}));
  // The corners of a tetrahedron whose edges are two radii.
  constexpr double radius = 0.17;
  const Vec3d top(0, 0, radius * std::sqrt(1.5));
  const Vec3d side = Transform::rotation({1, 1, 0}, std::acos(-1.0 / 3) * (180 / std::numbers::pi)).vector(top);
  const auto add_sphere = [&](const Vec3d& center) {
    place(scene, crystal, "", Transform::translation(center) * Transform::scaling(Vec3d(radius)), sphere);
  };
  add_sphere(top);
  for (const double turn : {0.0, 120.0, 240.0}) add_sphere(Transform::rotation({0, 0, 1}, turn).vector(side));

  const std::uint32_t ground =
      add_geometry(scene, "mountain", {std::make_shared<const TriangleMesh>(Mountain(levels).mesh()), {}, {}});
  place(scene, root_node, "mountain", {}, ground, add_surface(scene, "rock", {{0.5f, 0.45f, 0.35f}}));
  return scene;
}

Scene make_sombrero(int size) {
  Scene scene = stage("sombrero", Up::y, {{0, 5, -8}, {0, 0, 0}, {0, 0, 1}, 40}, {0, 0, 0}, {{10, 10, -10}});
  const int points = 32 << (size - 1);
  std::vector<Vec3f> positions;
  for (int row = 0; row < points; ++row) {
    for (int column = 0; column < points; ++column) {
      // He takes heights from a grid that ends a step short, and stretches it; so the crown is off the middle.
      const Vec3d at(-4 + 8.0 * column / points, 0, -4 + 8.0 * row / points);
      const double radius = glm::length(at);
      const double height = 3 * std::cos(2 * std::numbers::pi * radius) * std::exp(-radius);
      positions.emplace_back(Vec3d(-4 + 8.0 * column / (points - 1), height - 3, -4 + 8.0 * row / (points - 1)));
    }
  }
  std::vector<TriangleMesh::Corners> triangles;
  for (int row = 0; row + 1 < points; ++row) {
    for (int column = 0; column + 1 < points; ++column) {
      const auto a = static_cast<std::uint32_t>(row * points + column), b = a + 1;
      const auto d = static_cast<std::uint32_t>((row + 1) * points + column), c = d + 1;
      triangles.push_back({a, c, b});
      triangles.push_back({a, d, c});
    }
  }
  auto mesh = std::make_shared<const TriangleMesh>(std::move(positions), std::move(triangles));
  std::vector<Vec3f> normals = smooth_normals(*mesh);
  const std::uint32_t hat = add_geometry(scene, "sombrero", {std::move(mesh), std::move(normals), {}});
  place(scene, root_node, "sombrero", {}, hat, add_surface(scene, "red", {{1, 0.1f, 0.1f}, 0.8}));
  return scene;
}

Scene make_teapot_board(int size) {
  Scene scene = stage("teapot-board", Up::z, {{4.86, 7.2, 5.4}, {0, 0, 0}, {0, 0, 1}}, {0, 0, 0},
                      {{-3.1, 9.8, 12.1}, {11.3, 5.1, 8.8}});
  // Ours has y up already.
  auto teapot = std::make_shared<const TriangleMesh>(make_teapot(size));
  std::vector<Vec3f> normals = smooth_normals(*teapot);
  const std::uint32_t pot = add_geometry(scene, "teapot", {std::move(teapot), std::move(normals), {}});
  place(scene, root_node, "teapot", Transform::rotation({1, 0, 0}, 90), pot,
        add_surface(scene, "clay", {{1, 0.5f, 0.1f}, 0.75, 0.25}));
  for (const bool is_white : {true, false}) {
    MeshBuilder builder;
    const auto edge = [size](int i) { return static_cast<float>(4 * (2.0 * i / size - 1)); };
    for (int x = 0; x < size; ++x) {
      for (int y = is_white == (x % 2 == 0) ? 1 : 0; y < size; y += 2) {
        builder.quad({edge(x), edge(y), 0}, {edge(x + 1), edge(y), 0}, {edge(x + 1), edge(y + 1), 0},
                     {edge(x), edge(y + 1), 0});
      }
    }
    const char* name = is_white ? "white squares" : "grey squares";
    const std::uint32_t squares =
        add_geometry(scene, name, {std::make_shared<const TriangleMesh>(builder.take()), {}, {}});
    place(scene, root_node, name, {}, squares, add_surface(scene, name, {Color(is_white ? 1 : 0.5f), 0.5, 0.5}));
  }
  return scene;
}

}  // namespace sightline::spd
