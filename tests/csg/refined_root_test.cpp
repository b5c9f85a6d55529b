// Roots that are known roughly, refined, against a hundred digits.
#include "sightline/csg/refined_root.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <optional>

#include "sightline/csg/solid.h"
#include "sightline/math/random.h"

namespace sightline {
namespace {

using Real = boost::multiprecision::cpp_bin_float_100;

/// Of a sphere, or of a cylinder along `axis`; none where the ray misses.
std::optional<std::array<Real, 2>> exact_roots(const Vec3d& center, int axis, double radius, const Ray<double>& ray) {
  Real a = 0, b = 0, c = -Real(radius) * radius;
  for (int i = 0; i < 3; ++i) {
    if (i == axis) continue;
    const Real d = ray.direction[i], q = Real(ray.origin[i]) - center[i];
    a += d * d, b += q * d, c += q * q;
  }
  const Real discriminant = b * b - a * c;
  if (a == 0 || discriminant <= 0) return std::nullopt;
  const Real root = sqrt(discriminant);
  return std::array<Real, 2>{Real((-b - root) / a), Real((-b + root) / a)};
}

TEST(RefinedRoot, IsWithinItsRadius) {
  Random random(7);
  const auto coordinate = [&](double size) { return (2 * random.uniform_double() - 1) * size; };
  const auto point = [&](double size) {
    const double x = coordinate(size), y = coordinate(size), z = coordinate(size);
    return Vec3d(x, y, z);
  };
  std::size_t found = 0, by_newton = 0;
  for (int i = 0; i < 60'000; ++i) {
    const double far = std::ldexp(1.0, static_cast<int>(random.below(20)) - 4);
    const Vec3d center = point(2), origin = point(far), aim = center + point(1.2);
    const double radius = 0.05 + random.uniform_double();
    const int axis = static_cast<int>(random.below(4)) - 1;
    Vec3d top = center;
    if (axis >= 0) top[axis] += random.below(2) == 0 ? 3 : -0.7;
    const SolidTree tree =
        axis < 0 ? SolidTree(solid::Sphere{center, radius}) : SolidTree(solid::Cylinder{center, top, radius});
    const Ray<double> ray{origin, (aim - origin) * std::ldexp(1.0, static_cast<int>(random.below(9)) - 4)};
    const auto exact = exact_roots(center, axis, radius, ray);
    const QuickRay<Level::watertight> quick(ray);
    if (!exact) continue;
    const Solid solid(tree);
    for (const std::uint32_t index : {0u, 1u}) {
      const Real& truth = (*exact)[index];
      // As far off as what is refined may be.
      const double near =
          static_cast<double>(truth) * (1 + coordinate(std::ldexp(1.0, -static_cast<int>(35 + random.below(14)))));
      Root root;
      if (detail::refine_round<Level::watertight>(center, axis, radius, ray, index, near, root)) {
        ++by_newton;
        EXPECT_LE(abs(truth - root.t), Real(root.radius)) << i;
        EXPECT_FALSE(detail::refine_round<Level::watertight>(center, axis, radius, ray, 1 - index, near, root))
            << "the other root " << i;
      }
      const Root refined = refined_root<Level::watertight>(solid.primitives()[0], 0, index, near, quick, nullptr);
      ++found;
      EXPECT_LE(abs(truth - refined.t), abs(truth) * 0x1p-46) << i;
    }
  }
  EXPECT_GT(found, 20'000u);
  EXPECT_GT(by_newton, found * 9 / 10);
}

}  // namespace
}  // namespace sightline
