/// Surfaces of triangles, at any tilt and mirrored.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sightline/scene/simple_meshes.h"
#include "tests/render/little_scenes.h"

namespace sightline::test {
namespace {

constexpr int size = 24;

/// A plane under a distant lamp has one color all over: albedo / pi times the cosine. None of its rays to the lamp ends
/// in the triangle that it leaves.
TEST(MeshSurfaces, DoNotShadowThemselves) {
  constexpr double albedo = 0.5, intensity = 3;
  for (int i = 0; i < 8; ++i) {
    const Transform place = Transform::translation({0.1 * i, -0.07 * i, 0.3}) *
                            Transform::rotation({0.2, 0.1 * i, 1}, 9.0 * i) *
                            Transform::rotation({1, 0, 0}, 60 + 5.0 * i);
    Scene scene;
    add_shape(scene, "plane", make_quad(99, 99, 1), add_material(scene, lambert(albedo)), place);
    const Transform lamp = Transform::rotation({1, 0.3, 0}, -21);
    add_light(scene, DirectionalLight{}, intensity, lamp);
    add_camera(scene, 8, 20);
    const Vec3d to_lamp = glm::normalize(lamp.vector({0, 0, 1}));
    const double cosine = glm::dot(glm::normalize(place.normal({0, 1, 0})), to_lamp);
    ASSERT_GT(cosine, 0.2);
    const double expected = albedo / std::numbers::pi * intensity * cosine;
    const Rendered picture = render(scene, small(size, size));
    for (std::size_t pixel = 0; pixel < size * size; ++pixel) {
      ASSERT_NEAR(picture.mean(pixel).x, expected, 0x1p-18 * expected) << "tilt " << i << ", pixel " << pixel;
    }
  }
}

/// What is mirrored in the scene is mirrored in the picture: places in triangles keep their normals.
TEST(MeshSurfaces, MirroredInstancesAreMirroredInThePicture) {
  const auto picture_of = [](bool is_mirrored) {
    const Transform place = Transform::translation({0.4, 0.1, 0}) * Transform::rotation({1, 2, 3}, 40);
    Scene scene;
    add_shape(scene, "ball", make_sphere(1, 6), add_material(scene, lambert(0.8)),
              is_mirrored ? Transform::scaling({-1, 1, 1}) * place : place);
    add_light(scene, PointLight{}, 50, Transform::translation({0, 4, 5}));
    add_camera(scene, 8, 25);
    return render(scene, small(size, size));
  };
  const Rendered one = picture_of(false), other = picture_of(true);
  int lit = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      EXPECT_NEAR(one.mean(x, y).x, other.mean(size - 1 - x, y).x, 1e-5) << x << ", " << y;
      lit += one.mean(x, y).x > 0;
    }
  }
  EXPECT_GT(lit, 50);
}

/// A wall above a lamp hides nothing of it below, and each sample below asks the lamp once.
TEST(ShadowRays, EndAtTheLamp) {
  for (const bool has_wall : {false, true}) {
    Scene scene;
    const std::uint32_t white = add_material(scene, lambert(1));
    add_shape(scene, "floor", SolidTree(solid::Box{Vec3d(-9, -9, -1), Vec3d(9, 9, 0)}), white);
    // The camera is below it.
    if (has_wall) add_shape(scene, "ceiling", SolidTree(solid::Box{Vec3d(-9, -9, 5), Vec3d(9, 9, 6)}), white);
    add_light(scene, PointLight{}, 4 * std::numbers::pi, Transform::translation({0, 0, 2}));
    add_camera(scene, 4, 0x1p-10);
    const Rendered picture = render(scene, small(1, 1, 16));
    EXPECT_NEAR(picture.mean(0).x, 1, 0x1p-18) << has_wall;
    EXPECT_EQ(picture.counters[Effect::direct_light], 16u);
    EXPECT_EQ(picture.counters[Effect::hard_shadow], 16u);
  }
}

}  // namespace
}  // namespace sightline::test
