/// Pictures of holes whose caps coincide with those of the box that they are in: where tracers that tell faces apart by
/// an epsilon show speckles.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/csg/exact_solid.h"

namespace sightline {
namespace {

constexpr int size = 256;

/// A box and the hole through it: the cylinder is as long as the box is high, or longer by `overshoot` on both sides.
struct Holed {
  SolidTree box, cutter;

  Holed(double overshoot, const Frame& frame)
      : box(solid::Box{Vec3d(-1), Vec3d(1)}),
        cutter(solid::Cylinder{{0, 0, -1 - overshoot}, {0, 0, 1 + overshoot}, 0.6}) {
    box.frame = cutter.frame = frame;
  }
};

/// Some rotation, as rounded: what a frame says is what the solid is.
Frame rotation() {
  const Vec3d x = glm::normalize(Vec3d(0.8, 0.3, -0.4)), z = glm::normalize(glm::cross(x, Vec3d(0.2, 1.0, 0.3)));
  const Vec3d y = glm::cross(z, x);
  return {{{{x.x, x.y, x.z, 0}, {y.x, y.y, y.z, 0}, {z.x, z.y, z.z, 0}}}};
}

/// Where a pixel's ray meets the plane of the top, but for rounding, in the coordinates of the box.
Vec3d aim_of(int x, int y) { return {2.6 * (x + 0.5) / size - 1.3, 2.6 * (y + 0.5) / size - 1.3, 1}; }

/// From above, aside. The transposed frame takes the box's coordinates back, being a rotation.
Ray<double> ray_through(const Vec3d& aim, const Frame& frame) {
  const Vec3d eye(1.1, -0.9, 5);
  const auto turned = [&](const Vec3d& v) {
    Vec3d sum(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& row = frame.rows[i];
      sum += v[static_cast<int>(i)] * Vec3d(row[0], row[1], row[2]);
    }
    return sum;
  };
  return {turned(eye), turned(aim - eye)};
}

struct Count {
  int mouth = 0;    ///< Pixels whose rays go into the hole.
  int through = 0;  ///< And out at its other end.
  int wrong = 0;
};

/// A ray goes into the hole where it enters the box within the cutter, exactly. There must be nothing then: its first
/// boundary is the wall of the hole, or none.
void count_mouth(const Holed& holed, const Ray<double>& ray, const std::optional<Boundary>& first, Count& count) {
  const auto box = oracle::exact_spans(holed.box, ray), cutter = oracle::exact_spans(holed.cutter, ray);
  if (cutter.ends.empty() || cutter.ends[0].compare(box.ends[0]) > 0 || cutter.ends[1].compare(box.ends[0]) <= 0)
    return;
  const bool goes_through = cutter.ends[1].compare(box.ends[1]) >= 0;
  const auto is_wall = [&](const Boundary& boundary) {
    return boundary.primitive == 1 && boundary.face == 0 && boundary.is_flipped &&
           oracle::is_within(cutter.ends[1], boundary.t, boundary.radius);
  };
  ++count.mouth, count.through += goes_through;
  count.wrong += goes_through ? first.has_value() : !first || !is_wall(*first);
}

Count count_wrong(const Holed& holed, Level level) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::uint32_t top = 5;
  const Solid solid(holed.box - holed.cutter);
  Count count;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Vec3d aim = aim_of(x, y);
      const Ray<double> ray = ray_through(aim, holed.box.frame);
      const auto first = first_of(solid, ray, 0, infinity, level);
      const double from_axis = std::hypot(aim.x, aim.y), from_middle = std::max(std::fabs(aim.x), std::fabs(aim.y));
      if (from_axis < 0.61) {
        count_mouth(holed, ray, first, count);
      } else if (from_middle < 0.99) {
        count.wrong += !first || first->primitive != 0 || first->face != top;
      }
    }
  }
  return count;
}

class Hole : public testing::TestWithParam<double> {};

TEST_P(Hole, HasNoCapAlongTheAxes) {
  const Count count = count_wrong({GetParam(), Frame()}, Level::watertight);
  EXPECT_GT(count.mouth, 8'000);
  EXPECT_GT(count.through, 500);
  EXPECT_EQ(count.wrong, 0);
}

TEST_P(Hole, HasNoCapTurned) {
  const Count count = count_wrong({GetParam(), rotation()}, Level::watertight);
  EXPECT_GT(count.mouth, 8'000);
  EXPECT_GT(count.through, 500);
  EXPECT_EQ(count.wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(Overshoot, Hole, testing::Values(0.0, 1e-12, 1e-9), [](const auto& overshoot) {
  return overshoot.param == 0 ? "none" : overshoot.param < 1e-10 ? "tiny" : "small";
});

}  // namespace
}  // namespace sightline
