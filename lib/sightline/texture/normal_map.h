#pragma once
/// Normals that dent a surface without moving it: from images of normals, from images of heights, and from noise.
///
/// Directions point away from the surface; normals are of unit length. What would not be a direction leaves the normal
/// as it is. Blinn, "Simulation of Wrinkled Surfaces", 1978; Cohen, Olano and Manocha, "Appearance-Preserving
/// Simplification", 1998; Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010.

#include "sightline/texture/color.h"
#include "sightline/texture/image_texture.h"
#include "sightline/texture/tangent_frame.h"
#include "sightline/texture/uv.h"

namespace sightline {

/// What a color of an image of normals means: 0 to 1 are -1 to 1, of unit length, z not below the surface. `strength`
/// scales x and y: 0 is flat, 1 as it is. The mean of many normals is shorter than they are; its direction is kept.
Vec3d decode_normal(const Color& color, double strength = 1);

/// The same of an image that has only x and y: z is what unit length leaves.
Vec3d decode_normal_xy(double x, double y, double strength = 1);

/// The normal of a surface with derivatives du and dv by u and v, moved along its unit normal n by a height with
/// derivatives `slope` by u and v. In units of length, whatever du and dv are; of small heights.
Vec3d dented_normal(const Vec3d& n, const Vec3d& du, const Vec3d& dv, const glm::dvec2& slope);

/// The same by a height in all of space, such as noise: normalize(n - strength (g - (g . n) n)) with its gradient g.
Vec3d dented_normal(const Vec3d& n, const Vec3d& gradient, double strength = 1);

/// The derivatives of an image of heights by u and v: central differences over the footprint, and over a texel at
/// least, of heights that are filtered as wide. The red channel counts.
glm::dvec2 height_slope(const ImageTexture& heights, const glm::dvec2& uv, const UvFootprint& footprint = {});

/// A shading normal n for a viewer in direction `to_viewer`, who sees the flat surface's side of normal `geometric`.
/// The result r is of unit length with dot(r, to_viewer) > 0 as evaluated:
///   N1  Both normals turn over where the viewer is below the flat surface.
///   N2  n stays as it is where it faces the viewer.
///   N3  Where it does not, it is reflected at the plane across the viewer's direction: as far on this side as it was
///   on
///       the other, and continuous with N2.
///   N4  Where that is no more than nothing, the geometric normal takes its place, and edge-on the viewer's direction.
Vec3d facing_normal(const Vec3d& n, const Vec3d& geometric, const Vec3d& to_viewer);

}  // namespace sightline
