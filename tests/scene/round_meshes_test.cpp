#include "sightline/scene/round_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scene/closed.h"

namespace sightline {
namespace {

/// Of vertices, as their neighbors' faces have them: more than 0 where the normal looks outward.
void expect_normals_look_outward(const MeshGeometry& geometry) {
  const TriangleMesh& mesh = *geometry.mesh;
  ASSERT_EQ(geometry.normals.size(), mesh.positions().size());
  for (const Vec3f& normal : geometry.normals) EXPECT_NEAR(glm::length(normal), 1, 1e-6);
  for (std::uint32_t i = 0; i < mesh.size(); ++i) {
    const Triangle t = mesh[i];
    const Vec3f face = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
    for (const std::uint32_t corner : mesh.triangles()[i]) EXPECT_GT(glm::dot(face, geometry.normals[corner]), 0.9f);
  }
}

TEST(RoundMeshes, Sphere) {
  const MeshGeometry sphere = make_sphere_geometry();
  EXPECT_EQ(sphere.mesh->size(), 192u);
  EXPECT_EQ(sphere.mesh->positions().size(), 98u);
  EXPECT_TRUE(is_closed(*sphere.mesh));
  EXPECT_GT(volume(*sphere.mesh), 0.93 * 4 / 3 * std::numbers::pi);
  expect_normals_look_outward(sphere);
  double nearest = 1;
  for (std::uint32_t i = 0; i < sphere.mesh->size(); ++i) {
    const Triangle t = (*sphere.mesh)[i];
    const Vec3d normal = glm::normalize(glm::cross(Vec3d(t.b) - Vec3d(t.a), Vec3d(t.c) - Vec3d(t.a)));
    nearest = std::fmin(nearest, glm::dot(normal, Vec3d(t.a)));
  }
  EXPECT_GT(nearest, 0.948);
  EXPECT_LT(nearest, 0.949);
  for (const Vec3f& p : sphere.mesh->positions()) EXPECT_NEAR(glm::length(p), 1, 1e-6);
}

TEST(RoundMeshes, CylindersAndCones) {
  for (const double top : {1.0, 0.67, 0.25}) {
    const MeshGeometry frustum = make_frustum_geometry(top);
    EXPECT_EQ(frustum.mesh->size(), 60u);
    EXPECT_TRUE(is_closed(*frustum.mesh));
    EXPECT_NEAR(volume(*frustum.mesh), std::numbers::pi / 3 * (1 + top + top * top), 0.09);
    expect_normals_look_outward(frustum);
    EXPECT_EQ(frustum.mesh->bounds().lo, Vec3f(-1, -1, 0));
    EXPECT_EQ(frustum.mesh->bounds().hi, Vec3f(1, 1, 1));
  }
}

TEST(RoundMeshes, QuadsFaceWhereTheyGoAround) {
  const MeshGeometry quad = make_quad_geometry({0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0});
  EXPECT_EQ(quad.mesh->size(), 2u);
  for (const Vec3f& normal : smooth_normals(*quad.mesh)) EXPECT_EQ(normal, Vec3f(0, 0, 1));
}

TEST(RoundMeshes, PolygonsOfAnySize) {
  for (std::uint32_t corners = 3; corners < 80; ++corners) {
    std::vector<Vec3f> positions;
    for (std::uint32_t i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      positions.emplace_back(Vec3d(std::cos(angle), std::sin(angle), 0));
    }
    positions.emplace_back(0, 0, -1);
    std::vector<TriangleMesh::Corners> triangles;
    for_each_triangle(corners, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      triangles.push_back({a, b, c});
    });
    EXPECT_EQ(triangles.size(), corners - 2);
    for (std::uint32_t i = 0; i < corners; ++i) triangles.push_back({(i + 1) % corners, i, corners});
    EXPECT_TRUE(is_closed(TriangleMesh(positions, triangles))) << corners;
  }
}

}  // namespace
}  // namespace sightline
