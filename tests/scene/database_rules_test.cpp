/// Where things of Haines' databases stand, against his rules as his programs follow them: angle by angle, point by
/// point, z up.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>

#include "sightline/scene/flatten.h"
#include "sightline/scene/scenes.h"

namespace sightline {
namespace {

constexpr double pi = std::numbers::pi;

/// Places of all nodes that show a geometry, from their coordinates to his.
std::vector<Transform> places_of(const Scene& scene, const std::string& name) {
  std::vector<Transform> places;
  const Transform upright = scene.graph.local(root_node).inverted();
  for (const auto& origin : instances_of(scene).origins) {
    if (scene.geometries[scene.graph.geometry(origin.node)].name != name) continue;
    places.push_back(upright * scene.graph.world(origin.node));
  }
  return places;
}

Scene make(const std::string& spec) { return make_scene(spec, "no/such/folder"); }

/// Center and radius.
using Ball = std::array<double, 4>;

std::vector<Ball> balls_of(const Scene& scene) {
  std::vector<Ball> balls;
  for (const Transform& place : places_of(scene, "sphere")) {
    const Vec3d center = place.point({0, 0, 0});
    balls.push_back({center.x, center.y, center.z, glm::length(place.vector({1, 0, 0}))});
  }
  return balls;
}

/// As many, and each of `expected` is there, to 1e-12 in each number.
template <std::size_t size>
void expect_same(const std::vector<std::array<double, size>>& made,
                 const std::vector<std::array<double, size>>& expected) {
  ASSERT_EQ(made.size(), expected.size());
  for (const auto& one : expected) {
    EXPECT_TRUE(std::ranges::any_of(made, [&](const auto& other) {
      for (std::size_t i = 0; i < size; ++i) {
        if (!(std::fabs(one[i] - other[i]) < 1e-12)) return false;
      }
      return true;
    }));
  }
}

Vec3d turned_x(const Vec3d& p, double angle) {
  return {p.x, p.y * std::cos(angle) - p.z * std::sin(angle), p.y * std::sin(angle) + p.z * std::cos(angle)};
}

Vec3d turned_z(const Vec3d& p, double angle) {
  return {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle), p.z};
}

Vec3d turned(const Vec3d& p, const Vec3d& about, double angle) {
  const Vec3d axis = glm::normalize(about);
  return std::cos(angle) * p + std::sin(angle) * glm::cross(axis, p) + (1 - std::cos(angle)) * glm::dot(axis, p) * axis;
}

Ball ball(const Vec3d& center, double radius) { return {center.x, center.y, center.z, radius}; }

/// Three directions tilted and turned about z, and for children's children the shortest way from z.
TEST(DatabaseRules, Balls) {
  std::vector<Vec3d> directions;
  for (const Vec3d& trio : {Vec3d(1, 1, 0), Vec3d(1, 0, -1), Vec3d(0, 1, -1)}) {
    const Vec3d tilted = turned(glm::normalize(trio), {1, -1, 0}, std::asin(2 / std::sqrt(6.0)));
    for (int turn = 0; turn < 3; ++turn) directions.push_back(turned_z(tilted, 2 * pi / 3 * turn));
  }
  std::vector<Ball> expected{ball({0, 0, 0}, 0.5)};
  for (const Vec3d& first : directions) {
    const Vec3d center = (0.5 + 0.5 / 3) * first;
    expected.push_back(ball(center, 0.5 / 3));
    for (const Vec3d& direction : directions) {
      const Vec3d second = turned(direction, glm::cross(Vec3d(0, 0, 1), first), std::acos(first.z));
      expected.push_back(ball(center + (0.5 / 3 + 0.5 / 9) * second, 0.5 / 9));
    }
  }
  expect_same(balls_of(make("balls:2")), expected);
}

TEST(DatabaseRules, Rings) {
  constexpr double radius = 0.07412;
  std::array<Vec3d, 30> corners;
  const double tilt = 2 * std::acos(std::cos(pi / 3) / std::sin(pi / 5));
  for (std::size_t i = 0; i < 30; ++i) {
    const double angle = 2 * pi / 5 * static_cast<double>(i % 5);
    corners[i] = Vec3d(std::cos(angle), std::sin(angle), 0) / (1 + radius);
    const auto ring = static_cast<double>(i / 5);
    if (ring > 0) corners[i] = turned_z(turned_x(corners[i], tilt), pi * (2 * (ring - 1) + 1) / 5);
  }
  std::vector<Ball> balls;
  std::vector<std::array<double, 7>> rods;
  const double distance = 1 / std::sin(pi / 8);
  for (const Vec3d& offset : {Vec3d(0, distance, 0), Vec3d(-1, 2 * distance, -1), Vec3d(1, 2 * distance, -1),
                              Vec3d(-1, 2 * distance, 1), Vec3d(1, 2 * distance, 1)}) {
    for (std::size_t i = 0; i < 30; ++i) {
      const Vec3d from = corners[i] + offset, to = corners[i % 5 == 0 ? i + 4 : i - 1] + offset;
      balls.push_back(ball(from, radius));
      rods.push_back({from.x, from.y, from.z, to.x, to.y, to.z, radius});
    }
  }
  const Scene scene = make("rings:2");
  expect_same(balls_of(scene), balls);
  std::vector<std::array<double, 7>> made;
  for (const Transform& place : places_of(scene, "cylinder")) {
    const Vec3d from = place.point({0, 0, 0}), to = place.point({0, 0, 1});
    made.push_back({from.x, from.y, from.z, to.x, to.y, to.z, glm::length(place.vector({0, 1, 0}))});
  }
  expect_same(made, rods);
}

TEST(DatabaseRules, Tree) {
  std::vector<std::array<double, 7>> expected;
  const auto grow = [&](auto&& again, const std::function<Vec3d(Vec3d)>& frame, double radius, int levels) -> void {
    const Vec3d base = frame({0, 0, 0}), apex = frame({0, 0, 1});
    expected.push_back({base.x, base.y, base.z, apex.x, apex.y, apex.z, radius});
    if (levels == 0) return;
    for (const bool second : {false, true}) {
      const double angle = (second ? 25 : 40) * pi / 180, divergence = (second ? 140 + 90 : 90) * pi / 180;
      const double contraction = second ? 0.7 : 0.65;
      const auto inner = [=](const Vec3d& p) {
        return frame(contraction * turned_z(turned_x(p, angle), divergence) + Vec3d(0, 0, 1));
      };
      again(again, inner, 0.67 * radius, levels - 1);
    }
  };
  grow(
      grow, [](const Vec3d& p) { return p; }, 0.15, 4);
  const Scene scene = make("tree:4");
  std::vector<std::array<double, 7>> made;
  for (const Transform& place : places_of(scene, "cone")) {
    const Vec3d base = place.point({0, 0, 0}), apex = place.point({0, 0, 1});
    made.push_back({base.x, base.y, base.z, apex.x, apex.y, apex.z, glm::length(place.vector({1, 0, 0}))});
  }
  expect_same(made, expected);
  for (const Ball& end : balls_of(scene)) {
    EXPECT_TRUE(std::ranges::any_of(expected, [&](const auto& branch) {
      return std::fabs(branch[3] - end[0]) + std::fabs(branch[4] - end[1]) + std::fabs(branch[5] - end[2]) < 1e-12 &&
             std::fabs(0.67 * branch[6] - end[3]) < 1e-12;
    }));
  }
}

TEST(DatabaseRules, Gears) {
  const Scene scene = make("gears:3");
  const double radius = 1 / (3 - 2 * 0.1 / 2), step = radius * (2 - 0.1);
  std::size_t gear = 0;
  const std::vector<Transform> places = places_of(scene, "gear");
  const auto& mesh = *std::get<MeshGeometry>(scene.geometries[1].shape).mesh;
  ASSERT_EQ(mesh.positions().size(), 288u);
  for (int z = 0; z < 3; ++z) {
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 3; ++x) {
        const Transform& place = places[gear++];
        for (int tooth = 0; tooth < 36; ++tooth) {
          const double offsets[] = {-0.19, 0.19, 0.3, 0.7};
          for (int i = 0; i < 4; ++i) {
            const double angle = (x + y + z) % 2 * pi / 36 + (tooth + offsets[i]) * 2 * pi / 36;
            const double reach = (i < 2 ? 0.995 : 0.9) * radius;
            for (const double height : {1 - z / 3.0, 1 - z / 3.0 - 0.1}) {
              const Vec3d corner(radius - 1 + x * step + reach * std::cos(angle),
                                 radius - 1 + y * step + reach * std::sin(angle), height);
              ASSERT_TRUE(std::ranges::any_of(
                  mesh.positions(), [&](const Vec3f& p) { return glm::length(place.point(Vec3d(p)) - corner) < 1e-6; }))
                  << gear << ' ' << tooth;
            }
          }
        }
      }
    }
  }
}

TEST(DatabaseRules, Shells) {
  std::vector<Ball> expected;
  for (int i = -240; i <= 120; ++i) {
    const double angle = 18 * pi * i / 360, r = std::exp(0.15 * angle);
    expected.push_back({r * std::sin(angle), r * std::cos(angle), -2 * r, r});
  }
  expect_same(balls_of(make("shells:1")), expected);
}

TEST(DatabaseRules, Jacks) {
  const Scene scene = make("jacks:2");
  const auto turn = [](const Vec3d& p) {
    const double angle = -20 * pi / 180;
    const Vec3d around(p.x * std::cos(angle) + p.z * std::sin(angle), p.y,
                       -p.x * std::sin(angle) + p.z * std::cos(angle));
    return turned_x(around, -30 * pi / 180);
  };
  std::vector<Ball> expected;
  const auto jack = [&](const Vec3d& center, double size) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-0.75, 0.75}) {
        Vec3d end(0);
        end[axis] = side;
        expected.push_back(ball(turn(center + size * end), 0.15 * size));
      }
    }
  };
  jack({0, 0, 0}, 1);
  for (int octant = 0; octant < 8; ++octant) {
    jack(Vec3d(octant & 1, (octant >> 1) & 1, octant >> 2) - 0.5, 0.5);
  }
  expect_same(balls_of(scene), expected);
}

TEST(DatabaseRules, Lattice) {
  std::vector<Ball> expected;
  for (int i = 0; i < 27; ++i) expected.push_back(ball(0.5 * Vec3d(i % 3, i / 3 % 3, i / 9), 0.125));
  const Scene scene = make("lattice:2");
  expect_same(balls_of(scene), expected);
  for (const Transform& place : places_of(scene, "cylinder")) {
    EXPECT_NEAR(glm::length(place.vector({1, 0, 0})), 1.0 / 32, 1e-14);
    EXPECT_NEAR(glm::length(place.vector({0, 0, 1})), 0.5 - 2 * 0.125 * 0.5 * 0.99, 1e-14);
  }
}

/// As Haines' program has it, one square after the other to the bottom.
class MountainRule {
 public:
  explicit MountainRule(int levels) : levels_(levels), points_(1 << levels) { grow(points_, 0, 0, 0, 0, 0, 0); }

  std::map<std::pair<int, int>, double> heights;

 private:
  double random(int x, int y) const {
    const auto a = static_cast<unsigned long>(x), b = static_cast<unsigned long>(y);
    long second =
        21 + static_cast<long>(((a << (23 - levels_)) + (b << (15 - levels_)) + (a << (7 - levels_))) & 0xffff);
    double v1, r;
    do {
      const long first = (28411 + second * 8121) % 134456;
      second = (28411 + first * 8121) % 134456;
      v1 = static_cast<double>(first) * 2.0 / 134456 - 1.0;
      const double v2 = static_cast<double>(second) * 2.0 / 134456 - 1.0;
      r = v1 * v1 + v2 * v2;
    } while (r >= 1.0);
    return v1 * std::sqrt(-2.0 * std::log(r) / r);
  }

  void grow(int width, int x, int y, double ll, double lr, double ur, double ul) {
    heights[{x, y}] = ll;
    heights[{x + width, y}] = lr;
    heights[{x + width, y + width}] = ur;
    heights[{x, y + width}] = ul;
    if (width == 1) return;
    const double ratio = 2 / std::exp(std::log(2.0) / (2.2 - 1));
    const int half = width / 2;
    const double rise = half * 2.0 / points_ * std::sqrt(ratio * ratio - 1);
    const double lower = (ll + lr) / 2 + rise * random(x + half, y);
    const double right = (lr + ur) / 2 + rise * random(x + width, y + half);
    const double upper = (ur + ul) / 2 + rise * random(x + half, y + width);
    const double left = (ul + ll) / 2 + rise * random(x, y + half);
    const double middle = (ll + lr + ur + ul) / 4 + 1.4142136 * rise * random(x + half, y + half);
    grow(half, x, y, ll, lower, middle, left);
    grow(half, x + half, y, lower, lr, right, middle);
    grow(half, x + half, y + half, middle, right, ur, upper);
    grow(half, x, y + half, left, middle, upper, ul);
  }

  int levels_, points_;
};

TEST(DatabaseRules, Mountain) {
  const MountainRule rule(7);
  const Scene scene = make("mountain:7");
  const auto& positions = std::get<MeshGeometry>(scene.geometries[1].shape).mesh->positions();
  ASSERT_EQ(positions.size(), 129u * 129);
  ASSERT_EQ(rule.heights.size(), 129u * 129);
  for (const auto& [place, height] : rule.heights) {
    const Vec3f p = positions[static_cast<std::size_t>(place.second * 129 + place.first)];
    ASSERT_NEAR(p.x, -1 + place.first / 64.0, 1e-7);
    ASSERT_NEAR(p.y, -1 + place.second / 64.0, 1e-7);
    ASSERT_NEAR(p.z, height, 1e-6);
  }
  const Vec3d center(-0.8, 0.8, 1), top(0, 0, 0.17 * std::sqrt(1.5));
  const Vec3d side = turned(top, {1, 1, 0}, std::acos(-1.0 / 3));
  std::vector<Ball> expected{ball(center + top, 0.17)};
  for (int i = 0; i < 3; ++i) expected.push_back(ball(center + turned_z(side, 2 * pi / 3 * i), 0.17));
  expect_same(balls_of(scene), expected);
}

TEST(DatabaseRules, Sombrero) {
  const Scene scene = make("sombrero:1");
  const auto& positions = std::get<MeshGeometry>(scene.geometries[0].shape).mesh->positions();
  ASSERT_EQ(positions.size(), 32u * 32);
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) {
      const double r = std::hypot(-4 + j / 4.0, -4 + i / 4.0);
      const Vec3d expected(-4 + j * 8.0 / 31, -3 + 3 * std::cos(2 * pi * r) * std::exp(-r), -4 + i * 8.0 / 31);
      EXPECT_LT(glm::length(Vec3d(positions[static_cast<std::size_t>(32 * i + j)]) - expected), 1e-6);
    }
  }
}

}  // namespace
}  // namespace sightline
