// Whether roots are as near as their radii say.
#include "sightline/math/sized_double.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "sightline/math/random.h"

namespace sightline {
namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<400>>;

/// |q|^2 - r^2 along q + t d: a sphere, in any numbers.
template <class N>
struct Sphere {
  N a, b, c;

  Sphere(const double (&origin)[3], const double (&direction)[3], const double (&center)[3], double radius) {
    N o[3], d[3];
    for (int i = 0; i < 3; ++i) o[i] = N(origin[i]) - N(center[i]), d[i] = N(direction[i]);
    a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    b = o[0] * d[0] + o[1] * d[1] + o[2] * d[2];
    c = o[0] * o[0] + o[1] * o[1] + o[2] * o[2] - N(radius) * N(radius);
  }
};

/// Random rays toward spheres, most of which nearly touch.
template <class N, class See>
void for_random_spheres(See&& see) {
  Random random(7);
  const auto number = [&](double size) { return (2 * random.uniform_double() - 1) * size; };
  for (int i = 0; i < 20'000; ++i) {
    const double far = std::ldexp(1.0, static_cast<int>(random.below(20)));
    double origin[3], direction[3], center[3];
    for (int k = 0; k < 3; ++k) origin[k] = number(far), center[k] = number(1), direction[k] = center[k] - origin[k];
    direction[random.below(3)] += number(1.5);
    const Sphere<Wide> plain(origin, direction, center, 0);
    // At the distance where the line passes the center, but for few parts of it.
    const Wide touching = sqrt(plain.c - plain.b * plain.b / plain.a);
    const double radius =
        static_cast<double>(touching) * (1 + std::ldexp(number(1), -static_cast<int>(random.below(54))));
    see(Sphere<N>(origin, direction, center, radius), Sphere<Wide>(origin, direction, center, radius));
  }
}

template <class N>
void check_spheres() {
  int certain = 0, with_roots = 0;
  for_random_spheres<N>([&](const Sphere<N>& rounded, const Sphere<Wide>& exact) {
    EXPECT_LE(abs(exact.a - rounded.a.value), rounded.a.error());
    EXPECT_LE(abs(exact.b - rounded.b.value), rounded.b.error());
    EXPECT_LE(abs(exact.c - rounded.c.value), rounded.c.error());
    const RootList list = quadratic_roots(rounded.a, rounded.b, rounded.c);
    if (!list.is_certain) return;
    ++certain;
    const Wide discriminant = exact.b * exact.b - exact.a * exact.c;
    ASSERT_EQ(list.count, discriminant > 0 ? 2 : 0);
    ASSERT_FALSE(list.begins_negative);
    if (list.count == 0) return;
    ++with_roots;
    const Wide low = (-exact.b - sqrt(discriminant)) / exact.a, high = (-exact.b + sqrt(discriminant)) / exact.a;
    EXPECT_LE(abs(low - list.roots[0].t), list.roots[0].radius);
    EXPECT_LE(abs(high - list.roots[1].t), list.roots[1].radius);
  });
  EXPECT_GT(certain, 10'000);
  EXPECT_GT(with_roots, 5'000);
}

TEST(SizedDouble, EnclosesRootsOfSpheres) { check_spheres<SizedDouble>(); }
TEST(BoundedDouble, EnclosesRootsOfSpheres) { check_spheres<BoundedDouble>(); }

template <class N>
void check_lines() {
  Random random(3);
  for (int i = 0; i < 20'000; ++i) {
    double v[6];
    for (double& x : v)
      x = (2 * random.uniform_double() - 1) * std::ldexp(1.0, static_cast<int>(random.below(30)) - 15);
    const N slope = N(v[0]) * N(v[1]) - N(v[2]) * N(v[3]), level = N(v[4]) * N(v[5]) + N(v[0]);
    const Wide exact_slope = Wide(v[0]) * v[1] - Wide(v[2]) * v[3], exact_level = Wide(v[4]) * v[5] + v[0];
    const RootList list = linear_roots(slope, level);
    if (!list.is_certain) continue;
    ASSERT_EQ(list.count, 1);
    EXPECT_EQ(list.begins_negative, exact_slope > 0);
    EXPECT_LE(abs(-exact_level / exact_slope - list.roots[0].t), list.roots[0].radius);
  }
}

TEST(SizedDouble, EnclosesRootsOfLines) { check_lines<SizedDouble>(); }
TEST(BoundedDouble, EnclosesRootsOfLines) { check_lines<BoundedDouble>(); }

TEST(SizedDouble, IsUncertainOfWhatItCannotTell) {
  const SizedDouble third = SizedDouble(1.0 / 3) * SizedDouble(3) - SizedDouble(1);
  EXPECT_FALSE(linear_roots(third, SizedDouble(1)).is_certain);
  // A line that touches the unit sphere.
  EXPECT_FALSE(quadratic_roots(SizedDouble(1), SizedDouble(1), SizedDouble(1)).is_certain);
  const RootList none = linear_roots(SizedDouble(0), SizedDouble(-2));
  EXPECT_TRUE(none.is_certain);
  EXPECT_EQ(none.count, 0);
  EXPECT_TRUE(none.begins_negative);
}

}  // namespace
}  // namespace sightline
