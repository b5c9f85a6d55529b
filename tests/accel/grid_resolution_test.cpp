#include "sightline/accel/grid_resolution.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sightline/math/random.h"

namespace sightline {
namespace {

/// However long and thin the bounds are.
TEST(GridResolution, HasNoMoreCellsThanAskedFor) {
  Random random(1);
  for (int i = 0; i < 100'000; ++i) {
    Aabb bounds;
    for (int axis = 0; axis < 3; ++axis) {
      const float scale = std::ldexp(1.0f, static_cast<int>(random.below(200)) - 100);
      bounds.lo[axis] = scale * random.uniform(-1, 1);
      bounds.hi[axis] = bounds.lo[axis] + (random.below(8) == 0 ? 0 : scale * random.uniform());
    }
    const double cells = std::exp2(30.0 * random.uniform_double());
    const std::array<int, 3> layers = grid_resolution(bounds, cells);
    double product = 1;
    for (const int count : layers) {
      ASSERT_GE(count, 1);
      product *= count;
    }
    ASSERT_LE(product, std::min(cells, 0x1p28)) << layers[0] << " x " << layers[1] << " x " << layers[2];
  }
}

TEST(GridResolution, DividesARodThatIsLongBeyondMeasure) {
  EXPECT_EQ(grid_resolution({{1e30f, -5, -1}, {2e30f, 5, 1}}, 10.8), (std::array<int, 3>{10, 1, 1}));
}

}  // namespace
}  // namespace sightline
