#pragma once
/// Round shapes as triangles: closed, facing outward, with the normals of what they stand for.

#include "sightline/scene/scene.h"

namespace sightline {

/// The unit sphere around the origin, the faces of a cube pushed out to it: 6 * 2 * 4^2 triangles between great circles
/// 22.5 degrees apart, as Haines' Standard Procedural Databases cut theirs. Vertices lie on the sphere, and no point of
/// a triangle is nearer to the center than 0.948.
MeshGeometry make_sphere_geometry();

/// Along z from 0, where its radius is 1, to 1, where it is `top_radius`: a cylinder, or a cone cut off. 16 sides,
/// again as Haines' are cut, and lids on both ends, which his have not: 60 triangles. `top_radius` is more than 0.
MeshGeometry make_frustum_geometry(double top_radius = 1);

/// Two triangles, facing where a, b, c and d go around counter-clockwise.
MeshGeometry make_quad_geometry(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d);

/// Of each vertex: the mean over its triangles by their area. A vertex without any area has +z.
std::vector<Vec3f> smooth_normals(const TriangleMesh& mesh);

/// Calls triangle(i, j, k) for a convex polygon of `corners` corners, halving it so that few triangles are thin.
template <class Triangle>
void for_each_triangle(std::uint32_t corners, Triangle&& triangle) {
  const auto halve = [&](auto&& again, std::uint32_t first, std::uint32_t last) -> void {
    if (last - first < 2) return;
    const std::uint32_t middle = first + (last - first) / 2;
    triangle(first, middle, last);
    again(again, first, middle);
    again(again, middle, last);
  };
  halve(halve, 0, corners - 1);
}

}  // namespace sightline
