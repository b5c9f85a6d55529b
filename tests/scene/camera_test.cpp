#include "sightline/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sightline/math/random.h"

namespace sightline {
namespace {

void expect_frame(const Camera& camera, const Vec3d& forward) {
  ASSERT_TRUE(is_finite(camera.right) && is_finite(camera.up));
  const Vec3d f = glm::normalize(camera.forward), r = glm::normalize(camera.right), u = glm::normalize(camera.up);
  ASSERT_LE(glm::length(f - glm::normalize(forward)), 0x1p-50);
  ASSERT_LE(std::fabs(glm::dot(f, r)), 0x1p-30);
  ASSERT_LE(std::fabs(glm::dot(f, u)), 0x1p-30);
  ASSERT_LE(std::fabs(glm::dot(u, r)), 0x1p-30);
  ASSERT_GT(glm::dot(glm::cross(r, u), f), -1.001);  // right-handed: right x up is back
  ASSERT_LT(glm::dot(glm::cross(r, u), f), -0.999);
}

/// mat-lookat: up along the direction, exactly, in opposite directions, and but for rounding.
TEST(Camera, LooksAlongUp) {
  Random random(1);
  for (int round = 0; round < 2000; ++round) {
    Vec3d way(2 * random.uniform_double() - 1, 2 * random.uniform_double() - 1, 2 * random.uniform_double() - 1);
    if (round < 9) way = {double(round % 3 == 0), double(round % 3 == 1), double(round % 3 == 2)};
    const double sign = round % 2 == 0 ? 1 : -1, length = round % 5 == 0 ? 0x1p-600 : round % 5 == 1 ? 3 : 1;
    expect_frame(Camera::looking_at(Vec3d(0), way, sign * length * way, 40, 4, 3), way);
    const Vec3d nearly = way + Vec3d(random.uniform_double(), 0, random.uniform_double()) * std::ldexp(1., -round % 60);
    expect_frame(Camera::looking_at(Vec3d(0), way, nearly, 40, 4, 3), way);
  }
  const Camera down = Camera::looking_at({0, 5, 0}, Vec3d(0), {0, 1, 0}, 90, 2, 2);
  EXPECT_NEAR(down.right.x, 1, 0x1p-40);
  const Camera along_x = Camera::looking_at({5, 0, 0}, Vec3d(0), {1, 0, 0}, 90, 2, 2);
  EXPECT_NEAR(along_x.right.y, 1, 0x1p-40);
  expect_frame(Camera::looking_at(Vec3d(0), {1, 2, 3}, Vec3d(0), 40, 4, 3), {1, 2, 3});
}

TEST(Camera, LeavesOthersAsTheyAre) {
  const Camera camera = Camera::looking_at({0, 0, 5}, Vec3d(0), {0, 1, 0}, 90, 2, 1);
  EXPECT_EQ(camera.forward, Vec3d(0, 0, -1));
  EXPECT_NEAR(camera.right.x, 2, 0x1p-50);
  EXPECT_NEAR(camera.up.y, 1, 0x1p-50);
}

}  // namespace
}  // namespace sightline
