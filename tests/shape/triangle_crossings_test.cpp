#include "sightline/shape/triangle_crossings.h"

#include <gtest/gtest.h>

#include "tests/shape/closed_mesh_seeds.h"
#include "tests/shape/crossing_oracle.h"

namespace sightline {
namespace {

void expect_exact(const MeshSeed& seed, const Ray<double>& ray, int& crossed, const Frame* frame = nullptr) {
  const auto found = triangle_crossings(FramedRay(ray, frame), seed.vertices, seed.triangles);
  const CrossingMap expected = expected_crossings(exact(ray, frame ? *frame : Frame()), seed);
  ASSERT_EQ(found.size(), expected.size());
  std::size_t i = 0;
  for (const auto& [t, triangles] : expected) {
    ASSERT_EQ(found[i].triangles, triangles);
    const double below = std::nextafter(found[i].t, -INFINITY), above = std::nextafter(found[i].t, INFINITY);
    const Rational error = abs(t - Rational(found[i].t));
    ASSERT_LE(error, abs(t - Rational(below)));
    ASSERT_LE(error, abs(t - Rational(above)));
    crossed += static_cast<int>(triangles.size());
    ++i;
  }
}

Vec3d lattice_point(Random& random, std::uint32_t size) {
  const auto x = random.below(size), y = random.below(size), z = random.below(size);
  return {double(x), double(y), double(z)};
}
Vec3d any_point(Random& random, double size) {
  const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
  return size * (2.0 * Vec3d(x, y, z) - 1.0);
}

TEST(TriangleCrossings, AreExactOnTheLattice) {
  Random random(1);
  int crossed = 0;
  for (int i = 0; i < 2500; ++i) {
    MeshSeed seed;
    for (int k = 0; k < 8; ++k) seed.vertices.push_back(lattice_point(random, 5));
    for (int k = 0; k < 12; ++k) seed.triangles.push_back({random.below(8), random.below(8), random.below(8)});
    const Vec3d from = lattice_point(random, 5);
    expect_exact(seed, {from, lattice_point(random, 5) - from}, crossed);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(crossed, 2000);
}

TEST(TriangleCrossings, AreExactAtEdgesAndVertices) {
  Random random(2);
  int crossed = 0;
  for (int i = 0; i < 300; ++i) {
    const double size = i % 3 == 0 ? 1e-12 : 1;
    MeshSeed seed = i % 5 == 0 ? double_fan(16) : folded(8, random, [&] { return any_point(random, 1); });
    for (Vec3d& p : seed.vertices) p = size * p + (i % 2 == 0 ? Vec3d(0) : Vec3d(10));
    const auto& corners = seed.triangles[random.below(static_cast<std::uint32_t>(seed.triangles.size()))];
    const Vec3d a = seed.vertices[corners[0]], b = seed.vertices[corners[1]];
    const Vec3d target = a + (i % 4 == 0 ? 0 : random.uniform_double()) * (b - a);
    const Vec3d from = target + any_point(random, size);
    expect_exact(seed, {from, target - from}, crossed);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(crossed, 500);
}

TEST(TriangleCrossings, AreExactInFrames) {
  Random random(3);
  int crossed = 0;
  for (int i = 0; i < 1000; ++i) {
    Frame frame;
    for (auto& row : frame.rows) {
      for (double& x : row) x = i % 2 == 0 ? 0.25 * random.below(9) - 1 : 3 * random.uniform_double() - 1.5;
    }
    const MeshSeed seed = folded(10, random, [&] { return lattice_point(random, 4); });
    const Vec3d from = lattice_point(random, 5);
    expect_exact(seed, {from, lattice_point(random, 5) - from}, crossed, &frame);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(crossed, 300);
}

TEST(TriangleCrossings, TrianglesOfAFanMeetAtItsPole) {
  const MeshSeed fan = double_fan(16);
  const auto found =
      triangle_crossings(FramedRay({Vec3d(0.3, 0.1, 4), Vec3d(-0.3, -0.1, -3)}), fan.vertices, fan.triangles);
  ASSERT_GE(found.size(), 1u);
  EXPECT_EQ(found[0].t, 1);
  EXPECT_EQ(found[0].triangles.size(), 16u);
}

TEST(TriangleCrossings, NeitherLinesInAPlaneNorTrianglesWithoutAreaAreCrossings) {
  int crossed = 0;
  const MeshSeed flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 0, 1}, {1, 1, 1}}};
  for (const Ray<double>& ray : {Ray<double>{{-1, 0.25, 0}, {1, 0, 0}}, Ray<double>{{-1, 0, 0}, {1, 0, 0}},
                                 Ray<double>{{1, 0, 0}, {1, -1, 0}}, Ray<double>{{0, 0, 0}, {0, 0, 0}}}) {
    expect_exact(flat, ray, crossed);
  }
  EXPECT_EQ(crossed, 0);
  expect_exact(flat, {{0.5, 0, -1}, {0, 0, 1}}, crossed);
  EXPECT_EQ(crossed, 1);
  const auto from_float = [](float x, float y, float z) { return Vec3d(Vec3f(x, y, z)); };
  const MeshSeed line{
      {from_float(-1113.45459f, -79.049614f, -56.2431908f), from_float(-1113.45459f, -87.0922699f, -56.2431908f),
       from_float(-1113.45459f, -79.2090149f, -56.2431908f)},
      {{0, 1, 2}}};
  expect_exact(line, {{-1081.47925, 99.9999542, 87.7701111}, {-32.1072998, -183.355865, -144.607635}}, crossed);
  EXPECT_EQ(crossed, 1);
}

TEST(TriangleCrossings, AreFoundHoweverSmallOrLarge) {
  for (const double size : {1e-4, 1e-12, 1e-30, 1e-150, 1e-300, 1e150, 1e300}) {
    const MeshSeed seed{{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}};
    int crossed = 0;
    expect_exact(seed, {{size / 4, size / 4, -1}, {0, 0, 1}}, crossed);
    expect_exact(seed, {{size / 2, size / 2, 0}, {0, 0, 1}}, crossed);
    EXPECT_EQ(crossed, 2) << size;
  }
}

TEST(TriangleCrossings, RoundedOnesAreNearTheExactOnes) {
  Random random(4);
  int agree = 0, crossed = 0;
  for (int i = 0; i < 2000; ++i) {
    const MeshSeed seed = folded(8, random, [&] { return any_point(random, 1); });
    const Ray<double> ray{any_point(random, 3), any_point(random, 1)};
    const auto exact_ones = triangle_crossings(FramedRay(ray), seed.vertices, seed.triangles);
    const auto rounded = rounded_triangle_crossings(FramedRay(ray), seed.vertices, seed.triangles);
    if (exact_ones.size() != rounded.size()) continue;
    ++agree;
    for (std::size_t k = 0; k < rounded.size(); ++k, ++crossed) EXPECT_NEAR(rounded[k].t, exact_ones[k].t, 0.05);
  }
  EXPECT_GT(agree, 1950);
  EXPECT_GT(crossed, 150);
}

}  // namespace
}  // namespace sightline
