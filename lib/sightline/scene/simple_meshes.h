#pragma once
/// Meshes with normals and places in images, for scenes of everyday things.

#include <glm/vec2.hpp>
#include <span>

#include "sightline/scene/scene.h"

namespace sightline {

inline constexpr int most_segments = 1024;

/// Turns a profile around the y axis: points (distance from the axis, height) from bottom to top make a surface that
/// faces outward. u goes once around, v along the profile by its length. Segments that are smooth share normals; those
/// that are not have edges between rings, as a cone's base has. Points on the axis make poles.
/// \throws std::invalid_argument for fewer than 2 points, a negative or infinite number, fewer than 3 segments or more
/// than most_segments, and a profile that has no surface.
MeshGeometry make_lathe(std::span<const glm::dvec2> profile, int segments, bool is_smooth);

/// Around the origin, y up, `segments` around and half as many from pole to pole. \throws std::invalid_argument.
MeshGeometry make_sphere(double radius, int segments);

/// Six faces, each with all of an image. \throws std::invalid_argument where lo is not below hi.
MeshGeometry make_box(const Vec3d& lo, const Vec3d& hi);

/// A rectangle around the origin in the plane y = 0 that faces up, u along x, v along -z, both from 0 to `repeat`.
/// \throws std::invalid_argument.
MeshGeometry make_quad(double width, double height, double repeat);

}  // namespace sightline
