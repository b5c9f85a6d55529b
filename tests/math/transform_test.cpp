#include "sightline/math/transform.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "sightline/math/random.h"
#include "sightline/shape/instances.h"
#include "tests/math/exact.h"

namespace sightline {
namespace {

using exact::Map;
using exact::Rational;
using Wide = boost::multiprecision::cpp_bin_float_50;

constexpr double unit = 0x1p-53;

/// Kinds of maps that are hard: mirrored, sheared, scaled 100:1, almost flat, far away, tiny.
Affine hard_map(Random& random, int kind) {
  Affine map;
  const auto number = [&] {
    return std::ldexp(2 * random.uniform_double() - 1, static_cast<int>(random.below(5)) - 2);
  };
  for (auto& row : map.rows) {
    for (double& x : row) x = number();
  }
  const Vec3d scale = kind == 1   ? Vec3d(-1, 1, 1)
                      : kind == 2 ? Vec3d(100, 1, 1)
                      : kind == 3 ? Vec3d(0x1p-300)
                                  : Vec3d(1);
  for (auto& row : map.rows) {
    for (int k = 0; k < 3; ++k) row[static_cast<std::size_t>(k)] *= scale[k];
    if (kind == 4) row[2] = (row[0] + row[1]) * (1 + 0x1p-40 * number());
    if (kind == 5) row[3] *= 0x1p+40;
    if (kind == 6) row[0] += 50 * row[1];
  }
  return map;
}
constexpr int hard_kinds = 7;

TEST(Affine, ProductsAreWithinFourRoundings) {
  Random random(1);
  for (int round = 0; round < 3000; ++round) {
    const Affine a = hard_map(random, round % hard_kinds), b = hard_map(random, round / 3 % hard_kinds),
                 product = a * b;
    const Map truth(Map{a}, Map{b});
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        Rational sum = k == 3 ? abs(Rational(a.rows[i][3])) : Rational(0);
        for (std::size_t j = 0; j < 3; ++j) sum += abs(Rational(a.rows[i][j]) * Rational(b.rows[j][k]));
        ASSERT_LE(abs(Rational(product.rows[i][k]) - truth.rows[i][k]), sum * Rational(4.001 * unit)) << round;
      }
    }
  }
}

/// Cramer's rule in rational numbers; the quotient is rounded three times.
TEST(Transform, InvertsWhateverCanBeInverted) {
  Random random(2);
  for (int round = 0; round < 3000; ++round) {
    const Affine a = hard_map(random, round % hard_kinds);
    const Map map(a);
    const Rational determinant = map.determinant();
    ASSERT_NE(determinant, 0);
    const Transform made = Transform::of(a);
    EXPECT_EQ(made.is_mirroring(), determinant < 0);
    EXPECT_EQ(made.matrix(), a);
    const std::array<exact::Point, 3> columns{exact::cross(map.row(1), map.row(2)),
                                              exact::cross(map.row(2), map.row(0)),
                                              exact::cross(map.row(0), map.row(1))};
    for (std::size_t i = 0; i < 3; ++i) {
      Rational move = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational truth = columns[k][i] / determinant;
        ASSERT_LE(abs(Rational(made.inverse().rows[i][k]) - truth), abs(truth) * Rational(3.001 * unit));
        move -= truth * map.rows[k][3];
      }
      ASSERT_LE(abs(Rational(made.inverse().rows[i][3]) - move), abs(move) * Rational(3.001 * unit));
    }
  }
}

// ---- mat-det-test

TEST(Transform, TellsSmallFromSingular) {
  for (const double scale : {1e-15, 0x1p-300, 0x1p+300}) {  // determinants of 1e-45, and out of the range of double
    Affine map;
    for (std::size_t i = 0; i < 3; ++i) map.rows[i][i] = scale;
    const Transform made = Transform::of(map);
    EXPECT_EQ(made.matrix(), map);
    EXPECT_LE(std::fabs(made.inverse().rows[1][1] * scale - 1), 4 * unit);
  }
  Affine flat;
  flat.rows = {{{1, 2, 3, 0}, {4, 5, 6, 0}, {7, 8, 9, 0}}};
  EXPECT_THROW(Transform::of(flat), std::invalid_argument);
  EXPECT_EQ(determinant_sign(flat), 0);
  flat.rows[2][2] = std::nextafter(9, 10);
  EXPECT_EQ(determinant_sign(flat), -1);  // 5 - 8 of the minor, times what was added
  EXPECT_TRUE(Transform::of(flat).is_mirroring());
  EXPECT_THROW(Transform::scaling({1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(Transform::scaling({1, 0x1p-1074, 1}), std::invalid_argument);
  EXPECT_THROW(Transform::rotation(Vec3d(0), 90), std::invalid_argument);
  EXPECT_THROW(Transform::rotation(glm::dquat(0, 0, 0, 0)), std::invalid_argument);
  flat.rows[0][0] = NAN;
  EXPECT_THROW(Transform::of(flat), std::invalid_argument);
}

// ---- mat-far-translate

TEST(Transform, ComesBackFromFarAway) {
  for (const double far : {1e7, 1e16, 1e300}) {
    const Transform there = Transform::translation(Vec3d(far)), back = there.inverted() * there;
    EXPECT_TRUE(back.matrix().is_identity());
    EXPECT_EQ(back.point(Vec3d(0.125)), Vec3d(0.125));
  }
  const Transform there = Transform::translation(Vec3d(1e7));  // which is exact in double for such places, not in float
  EXPECT_EQ(there.inverted().point(there.point(Vec3d(0.125))), Vec3d(0.125));
}

// ---- mat-reflect

TEST(Transform, MirrorsKeepOutsideOutside) {
  Random random(3);
  const auto whole = [&] { return static_cast<double>(random.below(9)) - 4; };
  int mirrored = 0;
  for (int round = 0; round < 2000; ++round) {
    Affine map;
    for (auto& row : map.rows) {
      for (double& x : row) x = whole();
    }
    if (determinant_sign(map) == 0) continue;
    const Transform transform = Transform::of(map);
    mirrored += transform.is_mirroring();
    const Triangle local{Vec3f(0), Vec3f(1, 0, 2), Vec3f(0, 3, 1)};
    const auto normal = [](const Triangle& t) {  // in whole numbers
      return glm::cross(Vec3d(t.b) - Vec3d(t.a), Vec3d(t.c) - Vec3d(t.a));
    };
    const Vec3d placed = normal(Placement(map, 0).triangle(local)), carried = transform.normal(normal(local));
    ASSERT_GT(glm::dot(placed, carried), 0.99 * glm::length(placed) * glm::length(carried));
  }
  EXPECT_GT(mirrored, 500);
  EXPECT_TRUE(Transform::scaling({-1, 1, 1}).is_mirroring());
  EXPECT_FALSE(Transform::scaling({-1, -1, 1}).is_mirroring());
  EXPECT_FALSE((Transform::scaling({-1, 1, 1}) * Transform::scaling({1, -1, 1})).is_mirroring());
}

/// nm-nonuniform: a plane stays a plane. Of whole numbers, so that only the inverse is rounded.
TEST(Transform, NormalsStayAtRightAngles) {
  const Transform stretch = Transform::scaling({100, 1, 1}) * Transform::rotation(Vec3d(0, 0, 1), 90);
  const Vec3d along(1, 1, 0), normal(1, -1, 0);
  EXPECT_LE(std::fabs(glm::dot(stretch.vector(along), stretch.normal(normal))), 2 * 100 * unit);
}

// ---- Rotations

TEST(Transform, QuarterTurnsAreExact) {
  const Transform turn = Transform::rotation(Vec3d(0, 0, 5), 90);
  EXPECT_EQ(turn.point({1, 2, 3}), Vec3d(-2, 1, 3));
  EXPECT_TRUE((turn * turn * turn * turn).matrix().is_identity());
  EXPECT_TRUE((turn * turn.inverted()).matrix().is_identity());
  EXPECT_EQ(Transform::rotation(Vec3d(0, 0, 5), -270), turn);
  EXPECT_EQ(Transform::rotation(Vec3d(0, 0, 5), 3690), turn);
}

/// Rodrigues' formula in 50 digits. The angle in radians is off by two roundings of at most pi, which sine and cosine
/// pass on; the rest is ten roundings of numbers up to 1.
TEST(Transform, RotationsAreWithinSixteenRoundings) {
  Random random(4);
  const Wide degree = boost::math::constants::pi<Wide>() / 180;
  for (int round = 0; round < 500; ++round) {
    const Vec3d axis(random.uniform_double() - 0.5, random.uniform_double() - 0.5, random.uniform_double() - 0.5);
    const double degrees = 720 * random.uniform_double() - 360;
    const Affine made = Transform::rotation(axis, degrees).matrix();
    const Wide c = cos(degrees * degree), s = sin(degrees * degree);
    const Wide x(axis.x), y(axis.y), z(axis.z), length = sqrt(x * x + y * y + z * z);
    const std::array<Wide, 3> a{x / length, y / length, z / length};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        Wide truth = a[i] * a[k] * (1 - c) + (i == k ? c : Wide(0));
        if ((i + 1) % 3 == k) truth -= a[(i + 2) % 3] * s;
        if ((k + 1) % 3 == i) truth += a[(i + 1) % 3] * s;
        ASSERT_LE(abs(Wide(made.rows[i][k]) - truth), Wide(16 * unit));
      }
    }
  }
}

/// mat-chain. A product's entries are off by three roundings of sums that are at most sqrt(3) long a row, so by 9 units
/// in the norm of matrices, which changes a determinant of 1 by 16 at most; what the rotation itself is off, each step
/// adds.
TEST(Transform, AMillionSmallTurnsKeepTheVolume) {
  constexpr int steps = 1'000'000;
  const Transform step = Transform::rotation(Vec3d(1, 2, 3), 0.0572957795130823);
  const double own = std::fabs(static_cast<double>(Map(step.matrix()).determinant() - 1));
  Transform turned;
  for (int i = 0; i < steps; ++i) turned = turned * step;
  const double bound = steps * (own + 16 * unit);
  EXPECT_LT(bound, 0x1p-28);
  EXPECT_LE(std::fabs(static_cast<double>(Map(turned.matrix()).determinant() - 1)), bound);
  EXPECT_LE(std::fabs(static_cast<double>(Map(turned.inverse()).determinant() - 1)), bound);
  // Twice the sine of one step's angle from what is skew in it; the trace is 1 + 2 cos of the whole angle.
  const auto& one = step.matrix().rows;
  const auto& all = turned.matrix().rows;
  const Wide x = Wide(one[2][1]) - one[1][2], y = Wide(one[0][2]) - one[2][0], z = Wide(one[1][0]) - one[0][1];
  const Wide trace = 1 + 2 * cos(steps * asin(sqrt(x * x + y * y + z * z) / 2));
  EXPECT_LE(abs(Wide(all[0][0]) + all[1][1] + all[2][2] - trace), Wide(2 * bound));
}

}  // namespace
}  // namespace sightline
