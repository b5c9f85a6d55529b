#pragma once
/// Lab 03: normals from images, on surfaces that stay as flat as they are.

#include <glm/vec2.hpp>

#include "sightline/math/vec.h"

namespace student {

using namespace sightline;

/// The direction that a color stands for: bytes 0 to 255 are -1 to 1 of x, y and z. Of unit length.
inline Vec3d decode(int red, int green, int blue) {
  // lab:hole decode | 1. A color is a direction
  return glm::normalize(Vec3d(red, green, blue) * 2.0 / 255.0 - 1.0);
  // lab:end
}

using Corners = std::array<Vec3d, 3>;
using Uvs = std::array<glm::dvec2, 3>;

/// Twice the area that the triangle has in the image; below 0 where the image is mirrored on it.
inline double uv_area(const Uvs& uv) {
  const glm::dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
  return a.x * b.y - a.y * b.x;
}

/// The way in which u grows along a triangle, at right angles to the unit normal n, of unit length. n may be
/// interpolated, and need not be the triangle's own. uv_area() is not 0, and u does not grow along n.
inline Vec3d tangent_of(const Corners& corners, const Uvs& uv, const Vec3d& n) {
  // lab:hole tangent_of | 2. Which way u grows
  const glm::dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
  const Vec3d along = b.y * (corners[1] - corners[0]) - a.y * (corners[2] - corners[0]);
  const Vec3d du = uv_area(uv) < 0 ? -along : along;
  return glm::normalize(du - glm::dot(du, n) * n);
  // lab:end
}

/// The third axis, at right angles to the unit vectors n and tangent: on the side where v grows.
inline Vec3d bitangent_of(const Vec3d& n, const Vec3d& tangent, bool is_mirrored) {
  // lab:hole bitangent_of | 3. Left hands
  const Vec3d right_hand = glm::cross(n, tangent);
  return is_mirrored ? -right_hand : right_hand;
  // lab:end
}

/// A direction of the image, in space.
inline Vec3d to_world(const Vec3d& local, const Vec3d& tangent, const Vec3d& bitangent, const Vec3d& n) {
  // lab:hole to_world | 4. Into space
  return local.x * tangent + local.y * bitangent + local.z * n;
  // lab:end
}

/// The unit normal of a map of heights at (x, y), in its own frame; heights lie one unit apart, row by row with y
/// growing, and the map repeats in both directions. By central differences.
inline Vec3d normal_of_heights(const std::vector<double>& heights, int width, int x, int y) {
  const int rows = static_cast<int>(heights.size()) / width;
  // lab:hole normal_of_heights | 5. From heights to normals
  const auto height = [&](int i, int j) {
    return heights[static_cast<std::size_t>((j + rows) % rows * width + (i + width) % width)];
  };
  const double along_x = (height(x + 1, y) - height(x - 1, y)) / 2;
  const double along_y = (height(x, y + 1) - height(x, y - 1)) / 2;
  return glm::normalize(Vec3d(-along_x, -along_y, 1));
  // lab:end
}

/// The unit normal n where it faces the viewer; reflected at the plane across the viewer's direction where it faces
/// away. Both have unit length.
inline Vec3d facing(const Vec3d& n, const Vec3d& to_viewer) {
  // lab:hole facing | 6. Normals that face away
  const double cosine = glm::dot(n, to_viewer);
  return cosine < 0 ? n - 2 * cosine * to_viewer : n;
  // lab:end
}

}  // namespace student
