#pragma once
/// A solid as its own evaluator sees it: in space, and cut open along a ray.

#include <vector>

#include "sightline/scene/camera.h"
#include "viz/canvas.h"
#include "viz/csg_ladder.h"

namespace sightline::viz {

/// Whether the solid goes on without end toward the camera, which then stands in it, and sees its holes.
bool is_endless(const LadderSolid& solid);

/// Around all of the solid's bounded parts, with a margin: as far as ghosts of the others are shown.
Aabb scene_box(const LadderSolid& solid);

/// Sees all of the solid's bounded parts, y upward.
Camera camera_for(const LadderSolid& solid, int width, int height);

/// Of a pixel, x and y counted from the top left; in between they may be fractions. Pixel centers are at halves.
Ray<double> ray_through(const Camera& camera, double x, double y);

/// The solid, shaded, and as ghosts the primitives that it does not show; of those without a box what is in the
/// scene's.
struct SolidView {
  ColorGrid colors;
  std::vector<double> depths;  ///< t of ray_through the pixel's center; infinity where nothing is.
};
SolidView trace_solid(const LadderSolid& solid, const std::vector<std::uint32_t>& ghosts, const Camera& camera,
                      Level level);

/// A plane through the ray: t runs to the right, and `up` upward, as far from the ray as t runs along it.
struct SectionPlane {
  double t_min, t_max;
  Vec3d up;  ///< Of unit length, at right angles to the ray.
};
ColorGrid trace_section(const LadderSolid& solid, const std::vector<std::uint32_t>& outlined, const Ray<double>& ray,
                        const SectionPlane& plane, int width, int height, Level level);

/// At most `count` of the primitives, those on the ray first, and of these those with a box.
std::vector<std::uint32_t> primitives_to_show(const LadderSolid& solid, const Ladder& ladder, std::size_t count);

}  // namespace sightline::viz
