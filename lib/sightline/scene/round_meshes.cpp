#include "sightline/scene/round_meshes.h"

#include <array>
#include <cassert>
#include <cmath>

#include "sightline/shape/mesh_builder.h"

namespace sightline {
namespace {

constexpr int resolution = 4;  // of Haines, for all of his databases
constexpr int sides = 4 * resolution;

}  // namespace

MeshGeometry make_sphere_geometry() {
  // Tangents of -45, -22.5, ... 45 degrees; symmetric, so that faces of the cube meet.
  const double middle = std::sqrt(2.0) - 1;
  const std::array<double, resolution + 1> steps{-1, -middle, 0, middle, 1};
  MeshBuilder builder;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto point = [&](std::size_t row, std::size_t column) {
        Vec3d p;
        p[axis] = side;
        p[(axis + 1) % 3] = steps[column];
        p[(axis + 2) % 3] = side * steps[row];
        return Vec3f(p / std::sqrt(glm::dot(p, p)));
      };
      for (std::size_t row = 0; row < resolution; ++row) {
        for (std::size_t column = 0; column < resolution; ++column) {
          builder.quad(point(row, column), point(row, column + 1), point(row + 1, column + 1), point(row + 1, column));
        }
      }
    }
  }
  auto mesh = std::make_shared<const TriangleMesh>(builder.take());
  return {mesh, mesh->positions(), {}};
}

MeshGeometry make_frustum_geometry(double top_radius) {
  assert(top_radius > 0);
  std::vector<Vec3f> positions, normals;
  std::vector<TriangleMesh::Corners> triangles;
  const double slope = 1 - top_radius, length = std::sqrt(1 + slope * slope);
  for (const bool is_lid : {false, true}) {
    for (const bool is_top : {false, true}) {
      for (int i = 0; i < sides; ++i) {
        const Vec3d out = Transform::rotation({0, 0, 1}, i * (360.0 / sides)).vector({1, 0, 0});
        positions.push_back(is_top ? Vec3f(Vec3d(top_radius * out.x, top_radius * out.y, 1)) : Vec3f(out));
        const Vec3d lid_normal(0, 0, is_top ? 1 : -1);
        normals.push_back(is_lid ? Vec3f(lid_normal) : Vec3f(Vec3d(out.x, out.y, slope) / length));
      }
    }
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    triangles.push_back({i, next, sides + next});
    triangles.push_back({i, sides + next, sides + i});
  }
  for_each_triangle(sides, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles.push_back({2 * sides + a, 2 * sides + c, 2 * sides + b});
    triangles.push_back({3 * sides + a, 3 * sides + b, 3 * sides + c});
  });
  return {std::make_shared<const TriangleMesh>(std::move(positions), std::move(triangles)), std::move(normals), {}};
}

MeshGeometry make_quad_geometry(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
  MeshBuilder builder;
  builder.quad(a, b, c, d);
  return {std::make_shared<const TriangleMesh>(builder.take()), {}, {}};
}

std::vector<Vec3f> smooth_normals(const TriangleMesh& mesh) {
  std::vector<Vec3d> sums(mesh.positions().size(), Vec3d(0));
  for (std::uint32_t i = 0; i < mesh.size(); ++i) {
    const Triangle t = mesh[i];
    const Vec3d twice_area = glm::cross(Vec3d(t.b) - Vec3d(t.a), Vec3d(t.c) - Vec3d(t.a));
    for (const std::uint32_t corner : mesh.triangles()[i]) sums[corner] += twice_area;
  }
  std::vector<Vec3f> normals;
  normals.reserve(sums.size());
  for (const Vec3d& sum : sums) {
    const double length = std::sqrt(glm::dot(sum, sum));
    normals.push_back(length > 0 ? Vec3f(sum / length) : Vec3f(0, 0, 1));
  }
  return normals;
}

}  // namespace sightline
