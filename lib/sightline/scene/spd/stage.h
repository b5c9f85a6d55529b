#pragma once
/// What Haines' databases have in common: how he says where to look from, where light comes from and what shines.

#include <initializer_list>

#include "sightline/scene/scene_parts.h"

namespace sightline::spd {

/// In degrees, of square pictures.
struct View {
  Vec3d from, at, up;
  double angle = 45;
};

enum class Up { y, z };

/// With camera and lights, below a root that turns the database's "up" to y. Haines gives n lights sqrt(n) / (2 n) of
/// the brightness of white, however far they are. Lights here fade with distance, and are as bright as that at
/// `subject`: a white matte surface that faces one there has that share of white, pi times less than it gets.
Scene stage(const char* name, Up up, const View& view, const Vec3d& subject, std::initializer_list<Vec3d> lights);

/// Shares of light that a surface of a color scatters, mirrors and passes on.
struct Surface {
  Color color;
  double diffuse = 1, specular = 0, transmission = 0, refractive_index = 1;
};

/// What mirrors or passes light is smooth. A metal mirrors in its own color, as Haines' surfaces do.
std::uint32_t add_surface(Scene& scene, const char* name, const Surface& surface);

}  // namespace sightline::spd
