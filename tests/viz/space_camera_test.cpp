#include "viz/space_camera.h"

#include <gtest/gtest.h>

#include <vector>

namespace sightline::viz {
namespace {

std::vector<Vec3d> corners_at(const Vec3d& place, double size) {
  std::vector<Vec3d> corners;
  for (int corner = 0; corner < 8; ++corner) {
    corners.push_back(place + size * Vec3d(corner & 1 ? 3 : 0, corner & 2 ? 1 : 0, corner & 4 ? 2 : 0));
  }
  return corners;
}

/// How much of the picture points take: 1 where they reach an edge.
double filled(const SpaceCamera& camera, const std::vector<Vec3d>& points) {
  double most = 0;
  for (const Vec3d& p : points) {
    const auto seen = camera.project(p);
    if (!seen) return 0;
    most = std::max({most, std::abs(seen->x), std::abs(seen->y)});
  }
  return most;
}

TEST(FitCamera, FillsThePictureWhereverThingsAre) {
  for (const double size : {1e-3, 1.0, 1e4}) {
    for (const double away : {0.0, 1.0, 1e3, 1e6}) {
      for (const auto& [azimuth, elevation] : {std::pair(24, 20), {0, 0}, {-130, 70}}) {
        const auto points = corners_at(away * Vec3d(1, -2, 3), size);
        const double share = filled(fit_camera(axes_toward(azimuth, elevation), points, 1.5, 1), points);
        EXPECT_GT(share, 0.9) << size << " at " << away;
        EXPECT_LE(share, 1) << size << " at " << away;
      }
    }
  }
}

TEST(FitCamera, SeesTheSameOfWhatIsMoved) {
  const Axes axes = axes_toward(24, 20);
  const Vec3d away(1e6, -2e6, 5e5);
  const auto here = corners_at(Vec3d(0), 1), there = corners_at(away, 1);
  const SpaceCamera near = fit_camera(axes, here, 1.5, 2), far = fit_camera(axes, there, 1.5, 2);
  for (std::size_t i = 0; i < here.size(); ++i) {
    const auto a = near.project(here[i]), b = far.project(there[i]);
    ASSERT_TRUE(a && b);
    EXPECT_NEAR(a->x, b->x, 1e-8);  // doubles tell 1e6 apart to 1e-10
    EXPECT_NEAR(a->y, b->y, 1e-8);
  }
}

}  // namespace
}  // namespace sightline::viz
