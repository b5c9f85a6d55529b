#pragma once
/// Roots that are known roughly, as accurately as a level asks for.

#include <cmath>

#include "sightline/csg/face_roots.h"

namespace sightline {

namespace detail {

/// By the same polynomial from a point of the ray next to the root, where little cancels. False where that does not
/// tell enough.
template <Level level, class S>
[[gnu::flatten, gnu::noinline]] bool refine_root(const S& surface, const QuickRay<level>& ray, const Frame* frame,
                                                 std::uint32_t index, double near, Root& root) {
  if (!(std::fabs(near) <= SizedDouble::largest)) return false;
  Line<BoundedDouble> line = frame ? FramedRay(ray.ray(), frame).template in<BoundedDouble>()
                                   : FramedRay(ray.ray()).template in_world<BoundedDouble>();
  for (std::size_t i = 0; i < 3; ++i) line.origin[i] = line.origin[i] + BoundedDouble(near) * line.direction[i];
  const RootList list = roots_of(solid::form_of(surface, line));
  if (!list.is_certain || list.count != 2) return false;
  const Root& offset = index == 0 ? list.roots[0] : list.roots[1];
  root.t = near + offset.t;
  root.radius = (offset.radius + std::fabs(root.t) * 0x1p-53) * (1 + 0x1p-40);
  root.multiplicity = 1;
  return is_accurate(root.t, root.radius, level);
}

/// The same for a sphere, or an infinite cylinder along a coordinate axis, in the world: one step of Newton's from the
/// point next to the root, with p that point less the center, without the axis' own component,
///   A t^2 + 2 B t + C = 0,  A = d . d,  B = p . d,  C = p . p - r^2,  t = -C / 2 B.
///   N1  Each component of p is three times rounded, of the product, the sum and the difference; C besides at most six
///       times (Z1 of sized_double.h).
///   N2  The root near 0 is -C / (B + B sqrt(1 - A C / B^2)): where A C is at most 2^-20 of B^2, by no more than that
///       part another one; and it is the upper one where B > 0.
template <Level level>
[[gnu::noinline]] bool refine_round(const Vec3d& center, int axis, double radius, const Ray<double>& ray,
                                    std::uint32_t index, double near, Root& root) {
  if (!(std::fabs(near) <= SizedDouble::largest)) return false;
  constexpr double unit = 0x1p-53;
  double squares = 0, slope = 0, speed = 0, error_c = 0, error_b = 0;
  for (int i = 0; i < 3; ++i) {
    if (i == axis) continue;
    const double direction = ray.direction[i], way = near * direction, at = ray.origin[i] + way;
    const double p = at - center[i], size = std::fabs(p);
    const double error = (std::fabs(way) + std::fabs(at) + size) * unit;  // N1
    squares += p * p, slope += p * direction, speed += direction * direction;
    error_c += error * (2 * size + error);
    error_b += std::fabs(direction) * (error + size * (4 * unit));
  }
  const double square = radius * radius, c = squares - square, size_b = std::fabs(slope);
  error_c = (error_c + (squares + square) * (6 * unit)) * (1 + 0x1p-40) + SizedDouble::step;
  const bool is_simple = speed * std::fabs(c) <= 0x1p-21 * (slope * slope) &&  // N2, and room for rounding
                         error_b + SizedDouble::step <= 0x1p-21 * size_b && (slope > 0) == (index == 1);
  if (!is_simple) return false;
  const double half = 0.5 / slope, offset = -c * half;
  root.t = near + offset;
  root.radius = error_c * std::fabs(half) * (1 + 0x1p-18) + std::fabs(offset) * 0x1p-18 + std::fabs(root.t) * unit;
  root.radius *= 1 + 0x1p-40;
  root.multiplicity = 1;
  return is_accurate(root.t, root.radius, level);
}

template <Level level>
bool refine_root(const solid::Sphere& sphere, const QuickRay<level>& ray, std::uint32_t index, double near,
                 Root& root) {
  return refine_round<level>(sphere.center, -1, sphere.radius, ray.ray(), index, near, root);
}
template <Level level>
bool refine_root(const solid::Cylinder& cylinder, const QuickRay<level>& ray, std::uint32_t index, double near,
                 Root& root) {
  const int axis = axis_across(cap_of(cylinder, true));
  return axis >= 0 && refine_round<level>(cylinder.base, axis, cylinder.radius, ray.ray(), index, near, root);
}

}  // namespace detail

/// A root that quick_roots has found near t, as accurate as the level asks for.
template <Level level>
[[gnu::noinline]] Root refined_root(const Primitive& primitive, std::uint32_t face, std::uint32_t index, double t,
                                    const QuickRay<level>& ray, const Frame* frame) {
  Root root;
  if (level == Level::watertight && face == 0 && primitive.is_moderate && ray.is_moderate()) {
    const auto* sphere = std::get_if<solid::Sphere>(&primitive.shape);
    const auto* cylinder = std::get_if<solid::Cylinder>(&primitive.shape);
    if (!frame && sphere && detail::refine_root(*sphere, ray, index, t, root)) return root;
    if (!frame && cylinder && detail::refine_root(*cylinder, ray, index, t, root)) return root;
    if (sphere && detail::refine_root(*sphere, ray, frame, index, t, root)) return root;
    if (cylinder && detail::refine_root(*cylinder, ray, frame, index, t, root)) return root;
  }
  const LocalRay<level> local(ray.ray(), frame);
  return std::visit(
      [&]<class S>(const S& surface) {
        if constexpr (std::is_same_v<S, solid::Torus> || level == Level::fast) {
          return face_roots<level>(surface, local).roots[index];
        } else {
          const RootList list = roots_of(solid::form_of(surface, local.line()));
          const Root& rough = list.roots[index];
          if (list.is_certain && is_accurate(rough.t, rough.radius, level)) return rough;
          return settled_root(surface, local, level, index);
        }
      },
      surface_of(primitive.shape, face));
}

}  // namespace sightline
