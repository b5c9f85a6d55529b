/// Volumes that the lengths of intervals add up to.
///
/// Rays go in one direction through a grid of squares of side h, one through a random point of each, and the grid
/// itself is moved at random. The sum of h^2 times the length L within the solid is then V on average. It varies by
///   h^4 sum var(L) <= h^4 sum longest / 2 * mean |L(p) - L(q)|
/// with p and q in one square, and moving a solid by w changes no more than |w| times its surface, so that, p and q
/// being 0.5215 h apart on average, the variance is at most 0.261 h^3 longest surface. Six standard deviations are
/// allowed.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sightline/math/random.h"
#include "tests/csg/evaluate.h"

namespace sightline {
namespace {

constexpr double pi = std::numbers::pi;

struct Measured {
  const char* name;
  SolidTree tree;
  double volume;
  double surface;  ///< At least its area.
  double longest;  ///< No line has more of it.
  double radius;   ///< Of a ball around the origin that holds it.
};
[[maybe_unused]] void PrintTo(const Measured& solid, std::ostream* out) { *out << solid.name; }

std::vector<Measured> measured_solids() {
  const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0), root6 = std::sqrt(6.0);
  const auto sphere = [](double x, double radius) { return SolidTree(solid::Sphere{{x, 0, 0}, radius}); };
  const auto cylinder = [](int axis, double radius) {
    Vec3d end(0);
    end[axis] = 2;
    return SolidTree(solid::Cylinder{-end, end, radius});
  };
  const SolidTree left = sphere(-0.5, 1), right = sphere(0.5, 1), cube = solid::Box{};
  const SolidTree rounded = cube & sphere(0, 1.25);
  return {
      {"lens", left & right, 5 * pi / 12, 2 * pi, root3, 1},
      {"union_of_spheres", left | right, 9 * pi / 4, 6 * pi, 3, 1.5},
      {"lune", left - right, 11 * pi / 12, 4 * pi, 2, 1.5},
      {"napkin_ring", sphere(0, 1.25) - cylinder(2, 0.75), 4 * pi / 3, 6.25 * pi + 3 * pi, 2.5, 1.25},
      {"shell", sphere(0, 1) - sphere(0, 0.5), 7 * pi / 6, 5 * pi, 2, 1},
      {"bicylinder", cylinder(0, 1) & cylinder(1, 1), 16.0 / 3, 16, 2 * root2, root3},
      {"tricylinder", SolidTree(Operation::intersect, {cylinder(0, 1), cylinder(1, 1), cylinder(2, 1)}),
       8 * (2 - root2), 24 * (2 - root2), root6, root6 / 2},
      // A ball less six caps of height 1/4.
      {"cube_and_sphere", rounded, 13 * pi / 6, 6.25 * pi, 2.5, 1.25},
      {"cube_less_sphere", cube - sphere(0, 1), 8 - 4 * pi / 3, 24 + 4 * pi, 2 * root3, root3},
      // The cylinders, of radius 1/2, are cut by the cube alone: three of pi / 2, less three bicylinders of 2/3, plus a
      // tricylinder of 2 - sqrt(2).
      {"widget", SolidTree(Operation::subtract, {rounded, cylinder(0, 0.5), cylinder(1, 0.5), cylinder(2, 0.5)}),
       2 * pi / 3 + root2, 6.25 * pi + 6 * pi, 2.5, 1.25},
      {"nothing", rounded - rounded, 0, 0, 0, 1.25},
  };
}

double length_of(const Spans& spans) {
  double sum = 0;
  for_each_span(spans.boundaries, spans.begins_inside,
                [&](double lo, double hi, const Boundary*, const Boundary*) { sum += hi - lo; });
  return sum;
}

/// Exact levels have the same boundaries, to what watertight promises.
void expect_alike(const Spans& a, const Spans& b) {
  ASSERT_EQ(a.boundaries.size(), b.boundaries.size());
  for (std::size_t i = 0; i < a.boundaries.size(); ++i) {
    EXPECT_LE(std::fabs(a.boundaries[i].t - b.boundaries[i].t), 0x1p-45 * std::fabs(b.boundaries[i].t));
  }
}

class Volume : public testing::TestWithParam<Measured> {
 protected:
  void expect_volume(const Vec3d& direction, std::uint64_t seed) const {
    constexpr int cells = 160;  // on a side
    const Measured& measured = GetParam();
    const Solid solid(measured.tree);
    const double h = 2 * measured.radius / (cells - 1), length = glm::length(direction);
    const Vec3d along = direction / length;
    const Vec3d u = glm::normalize(glm::cross(along, Vec3d(0.1, 0.9, 0.2))), v = glm::cross(along, u);
    Random random(seed);
    const double move_u = random.uniform_double(), move_v = random.uniform_double();
    std::array<double, 4> sums{};
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const double a = (i - move_u + random.uniform_double()) * h - measured.radius;
        const double b = (j - move_v + random.uniform_double()) * h - measured.radius;
        const Ray<double> ray{a * u + b * v - 3.0 * along, direction};
        std::array<Spans, 4> spans;
        for (std::size_t l = 0; l < 4; ++l) {
          spans[l] = spans_of(solid, ray, all_levels[l]);
          sums[l] += length_of(spans[l]) * length * h * h;
        }
        expect_alike(spans[1], spans[3]);
        expect_alike(spans[2], spans[3]);
      }
    }
    const double deviation = std::sqrt(0.261 * h * h * h * measured.longest * measured.surface);
    for (std::size_t l = 0; l < 4; ++l) {
      EXPECT_LE(std::fabs(sums[l] - measured.volume), 6 * deviation) << level_infos[l].name;
    }
  }
};

TEST_P(Volume, IsThatOfTheSpansAlongAnAxis) { expect_volume({0, 0, 1}, 1); }
TEST_P(Volume, IsThatOfTheSpansObliquely) { expect_volume({0.3, -0.4, 0.5}, 2); }

INSTANTIATE_TEST_SUITE_P(Known, Volume, testing::ValuesIn(measured_solids()),
                         [](const auto& measured) { return std::string(measured.param.name); });

// ---- Menger's sponge

/// A plane of the lattice that divides [-1, 1] in 27.
double plane(int k) { return 2.0 * k / 27 - 1; }

/// A cube less square bars along all axes, whose ends are in its faces.
SolidTree sponge() {
  std::vector<SolidTree> parts{solid::Box{}};
  for (int step = 27; step > 1; step /= 3) {
    for (int i = step / 3; i < 27; i += step) {
      for (int j = step / 3; j < 27; j += step) {
        for (int axis = 0; axis < 3; ++axis) {
          solid::Box bar;
          const int a = (axis + 1) % 3, b = (axis + 2) % 3;
          bar.lo[a] = plane(i), bar.hi[a] = plane(i + step / 3);
          bar.lo[b] = plane(j), bar.hi[b] = plane(j + step / 3);
          parts.emplace_back(bar);
        }
      }
    }
  }
  return {Operation::subtract, std::move(parts)};
}

/// Along rays that move a whole number of cells aside for each cell of height, the length is linear between the
/// lattice's lines, and so its value in the middle is its mean there: but for rounding the sum is the volume.
TEST(Sponge, HasItsVolume) {
  const Solid solid(sponge());
  for (const int aside : {0, 1, -2}) {
    for (const Level level : all_levels) {
      double sum = 0;
      std::size_t boundaries = 0;
      for (int i = -27 * std::max(aside, 0); i < 27 - 27 * std::min(aside, 0); ++i) {
        for (int j = 0; j < 27; ++j) {
          const Ray<double> ray{{(plane(i) + plane(i + 1)) / 2, (plane(j) + plane(j + 1)) / 2, -1},
                                {double(aside), 0, 1}};
          const Spans spans = spans_of(solid, ray, level);
          sum += length_of(spans) * 4 / 729;
          boundaries += spans.boundaries.size();
        }
      }
      EXPECT_GT(boundaries, 5'000u);
      // Each end is off by some roundings of numbers below 8, origins being rounded as well.
      const double rounding = level == Level::fast ? 0x1p-18 : 0x1p-47;
      EXPECT_NEAR(sum, 8 * std::pow(20.0 / 27, 3), static_cast<double>(boundaries) * rounding * 4 / 729)
          << info_of(level).name << ' ' << aside;
    }
  }
}

}  // namespace
}  // namespace sightline
