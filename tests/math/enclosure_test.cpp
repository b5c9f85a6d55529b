#include "sightline/math/enclosure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sightline/math/enclosure_image.h"
#include "sightline/math/random.h"
#include "sightline/math/transform.h"
#include "sightline/shape/instances.h"
#include "tests/math/exact.h"

namespace sightline {
namespace {

using exact::Map;
using exact::Point;
using exact::Rational;

struct Dice {
  Random random;

  float number() { return std::ldexp(2 * random.uniform() - 1, static_cast<int>(random.below(4))); }
  Vec3f vector() { return {number(), number(), number()}; }
  std::vector<Vec3f> points(std::size_t count) {
    std::vector<Vec3f> made(count);
    const Vec3f shift = random.below(3) == 0 ? 100.0f * vector() : Vec3f(0);
    const Vec3f scale = random.below(3) == 0 ? Vec3f(100, 1, 0.01f) : Vec3f(1);
    for (Vec3f& p : made) p = shift + scale * vector();
    return made;
  }
  Affine map(int kind) {
    Affine map;
    for (auto& row : map.rows) {
      for (double& x : row) x = number();
    }
    if (kind == 1) map = (Transform::rotation(Vec3d(vector()), 77) * Transform::translation(Vec3d(vector()))).matrix();
    if (kind == 2) map = Transform::scaling(Vec3d(-100, 1, 1)).matrix();
    if (kind == 3) map.rows[0][3] = 0x1p+30;
    if (kind == 4) map.rows[2] = map.rows[1];  // flat
    if (kind == 5) {
      for (auto& row : map.rows) row[1] *= 0x1p-60;
    }
    return map;
  }
};
constexpr int map_kinds = 6;

void expect_holds(const Enclosure& enclosure, const Point& p, int round) {
  ASSERT_TRUE(exact::holds(enclosure.box, p)) << "box, round " << round;
  ASSERT_TRUE(exact::holds(enclosure.sphere, p)) << "sphere, round " << round;
  ASSERT_TRUE(exact::holds(enclosure.cylinder, p)) << "cylinder, round " << round;
}

TEST(Enclosure, HoldsItsPoints) {
  Dice dice{Random(1)};
  for (int round = 0; round < 300; ++round) {
    const std::vector<Vec3f> points = dice.points(1 + dice.random.below(30));
    const Enclosure made = enclosure_of(points), around_box = enclosure_of(made.box);
    for (const Vec3f& p : points) {
      expect_holds(made, exact::point(p), round);
      expect_holds(around_box, exact::point(p), round);
    }
    EXPECT_LE(made.sphere.radius, ball_around(made.box).radius * 1.002f);
  }
}

/// I1 of EnclosureImage: by the map, and by what instances make of it.
TEST(EnclosureImage, HoldsTheImages) {
  Dice dice{Random(2)};
  for (int round = 0; round < 1500; ++round) {
    const std::vector<Vec3f> points = dice.points(1 + dice.random.below(12));
    const Enclosure thing = enclosure_of(points);
    const Affine affine = dice.map(round % map_kinds);
    const EnclosureImage image(affine, thing);
    const Enclosure made{image.box(), image.sphere(), image.cylinder()};
    const Map map(affine);
    const Placement placement(affine, 0);
    for (const Vec3f& p : points) {
      expect_holds(made, map.image(exact::point(p)), round);
      expect_holds(made, exact::point(placement.point(p)), round);
    }
  }
}

/// I2: the bounds of a ball that is turned are no larger than the ball, and those of a box that is not turned no larger
/// than the box; of a stretched ball the box is that of the ellipsoid.
TEST(EnclosureImage, IsAsCloseAsCanBe) {
  const Enclosure ball{{Vec3f(-1), Vec3f(1)}, {Vec3f(0), 1}, {Vec3f(0), Vec3f(0, 0, 1), 1, 1}};
  const Transform turn = Transform::rotation(Vec3d(1, 2, 3), 40);
  const EnclosureImage turned(turn.matrix(), ball);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(turned.box().lo[i], -1, 0x1p-18);
    EXPECT_NEAR(turned.box().hi[i], 1, 0x1p-18);
  }
  EXPECT_NEAR(turned.sphere().radius, 1, 0x1p-18);
  EXPECT_NEAR(turned.cylinder().radius, 1, 0x1p-18);
  EXPECT_NEAR(turned.cylinder().half_length, 1, 0x1p-18);
  EXPECT_NEAR(glm::length(Vec3d(turned.cylinder().axis) - turn.vector({0, 0, 1})), 0, 0x1p-20);
  const EnclosureImage stretched((turn * Transform::scaling({100, 1, 1})).matrix(), ball);
  EXPECT_NEAR(stretched.sphere().radius, 100, 0.01);
  EXPECT_NEAR(stretched.box().hi.x,
              std::hypot(100 * turn.matrix().rows[0][0], turn.matrix().rows[0][1], turn.matrix().rows[0][2]), 0.001);
  const EnclosureImage rod(Transform::scaling({1, 1, 50}).matrix(), ball);
  EXPECT_NEAR(rod.cylinder().radius, 1, 0.001);
  EXPECT_NEAR(rod.cylinder().half_length, 50, 0.001);
}

TEST(EnclosureImage, StretchIsAnUpperBound) {
  Dice dice{Random(3)};
  for (int round = 0; round < 500; ++round) {
    const Affine map = dice.map(0);
    const std::array<Vec3d, 3> columns{map.column(0), map.column(1), map.column(2)};
    double largest = 0;
    Vec3d v(1, 0.7, 0.4);
    for (int i = 0; i < 2000; ++i) {  // von Mises' power iteration, from below
      v = glm::normalize(map.covector(map.vector(v)));
      largest = glm::length(map.vector(v));
    }
    EXPECT_GE(stretch_of(columns), largest * (1 - 0x1p-45));
    EXPECT_LE(stretch_of(columns), largest * 1.01);
  }
}

TEST(EnclosureImage, ExtremesAreHeldByEverythingOrNothing) {
  const Enclosure thing = enclosure_of(std::vector<Vec3f>{{1, 2, 3}, {4, 5, 7}});
  Affine huge;
  huge.rows[0][0] = 1e200;
  const EnclosureImage out(huge, thing), far(Transform::translation(Vec3d(1e39)).matrix(), thing), none(Affine(), {});
  EXPECT_TRUE(is_unbounded(out.box()) && is_unbounded(out.sphere()) && is_unbounded(out.cylinder()));
  EXPECT_TRUE(is_unbounded(far.sphere()) && is_unbounded(far.cylinder()));
  EXPECT_TRUE(is_nothing(none.box()) && is_nothing(none.sphere()) && is_nothing(none.cylinder()));
  const Enclosure all{everything<Aabb>(), everything<Sphere>(), everything<Cylinder>()};
  const EnclosureImage whole(Transform::scaling(Vec3d(2)).matrix(), all);
  EXPECT_TRUE(is_unbounded(whole.box()) && is_unbounded(whole.sphere()) && is_unbounded(whole.cylinder()));
  Affine tiny;
  for (std::size_t i = 0; i < 3; ++i) tiny.rows[i][i] = 0x1p-1040;
  const EnclosureImage point(tiny, thing);
  EXPECT_TRUE(exact::holds(point.sphere(), Map(tiny).image(exact::point(Vec3f(4, 5, 7)))));
  EXPECT_TRUE(exact::holds(point.cylinder(), Map(tiny).image(exact::point(Vec3f(4, 5, 7)))));
}

// ---- Around volumes

Point random_point(Dice& dice, const Sphere& sphere) {  // of its surface, in rational numbers
  const Rational m(dice.number()), n(dice.number()), sum = m * m + n * n;
  const Point direction{2 * m / (sum + 1), 2 * n / (sum + 1), (sum - 1) / (sum + 1)};
  return exact::plus(exact::point(sphere.center), exact::times(Rational(sphere.radius), direction));
}

TEST(Around, HoldsEveryVolume) {
  Dice dice{Random(4)};
  for (int round = 0; round < 300; ++round) {
    std::vector<Aabb> boxes(1 + dice.random.below(8));
    std::vector<Sphere> spheres;
    std::vector<Cylinder> cylinders;
    std::vector<std::vector<Vec3f>> held;
    for (Aabb& box : boxes) {
      held.push_back(dice.points(2 + dice.random.below(4)));
      const Enclosure each = enclosure_of(held.back());
      box = each.box;
      spheres.push_back(each.sphere);
      cylinders.push_back(each.cylinder);
      if (dice.random.below(4) == 0) spheres.back() = cylinders.size() % 2 == 0 ? Sphere{Vec3f(0), -1} : each.sphere;
    }
    const Aabb box = around(boxes);
    const Sphere sphere = around(spheres);
    const Cylinder cylinder = around(cylinders);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_TRUE(box.contains(boxes[i]));
      for (int k = 0; k < 5 && !is_nothing(spheres[i]); ++k) {
        ASSERT_TRUE(exact::holds(sphere, random_point(dice, spheres[i]))) << "round " << round;
      }
      for (const Vec3f& p : held[i]) ASSERT_TRUE(exact::holds(cylinder, exact::point(p))) << "round " << round;
    }
  }
}

TEST(Around, OneAloneAndOneThatHoldsAllStayAsTheyAre) {
  const Sphere large{{1, 2, 3}, 5}, small{{2, 2, 3}, 1};
  const Sphere made = around(std::vector{small, large, small});
  EXPECT_EQ(made.center, large.center);
  EXPECT_EQ(made.radius, large.radius);
  const Cylinder rod{{1, 2, 3}, {0, 0.6f, 0.8f}, 2, 7};
  const Cylinder same = around(std::vector{rod, Enclosure().cylinder});
  EXPECT_EQ(same.axis, rod.axis);
  EXPECT_EQ(same.radius, rod.radius);
  const Sphere two = around(std::vector{Sphere{{-3, 0, 0}, 1}, Sphere{{4, 0, 0}, 2}});
  EXPECT_NEAR(two.radius, 5, 0x1p-18);
  EXPECT_NEAR(two.center.x, 1, 0x1p-18);
}

/// Eight balls at the corners of a cube, and rods side by side: as close as the thousandth that SmallestBall promises.
TEST(Around, IsCloseToTheSmallest) {
  std::vector<Sphere> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({Vec3f(i & 1, i >> 1 & 1, i >> 2), 0.5f});
  EXPECT_NEAR(around(corners).radius, std::sqrt(0.75) + 0.5, 0.003);
  std::vector<Cylinder> rods;
  for (int i = 0; i < 5; ++i) rods.push_back({Vec3f(float(i), 2 * float(i), 0), Vec3f(0.6f, 0, 0.8f), 0.1f, 30});
  const Cylinder bundle = around(rods);
  EXPECT_NEAR(std::fabs(glm::dot(bundle.axis, rods[0].axis)), 1, 0x1p-18);
  EXPECT_LT(bundle.radius, 4.6);
}

}  // namespace
}  // namespace sightline
