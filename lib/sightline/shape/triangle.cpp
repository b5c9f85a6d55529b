#include "sightline/shape/triangle.h"

#include <array>

#include "sightline/math/algebraic_root.h"
#include "sightline/math/expansion.h"
#include "sightline/math/rounding.h"
#include "sightline/shape/line.h"
#include "sightline/shape/solid_shape.h"

namespace sightline {
namespace {

struct ExactVector {
  Expansion<2> x, y, z;
};

ExactVector relative_to(const Vec3d& origin, const Vec3f& p) {
  return {exact_difference(p.x, origin.x), exact_difference(p.y, origin.y), exact_difference(p.z, origin.z)};
}

std::array<Expansion<16>, 3> cross(const ExactVector& p, const ExactVector& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

/// How far the origin is from a triangle's plane, in units of the normal's length, as a vertex relative to the origin
/// over the plane's own normal. That is rounded by its edges, which are short where the origin is next to it: with the
/// absolute values of the products in place of the products, the normal by 4 u, and the sum by 4 u more; u = 2^-53.
struct Height {
  double value, bound;

  Height(const Triangle& triangle, const Vec3d& a) {
    const Vec3d p = Vec3d(triangle.b) - Vec3d(triangle.a), q = Vec3d(triangle.c) - Vec3d(triangle.a);
    const Vec3d size_p = glm::abs(p), size_q = glm::abs(q), size_a = glm::abs(a);
    value = glm::dot(a, glm::cross(p, q));
    bound = 10 * 0x1p-53 *
            (size_a.x * (size_p.y * size_q.z + size_p.z * size_q.y) +
             size_a.y * (size_p.z * size_q.x + size_p.x * size_q.z) +
             size_a.z * (size_p.x * size_q.y + size_p.y * size_q.x));
  }
};

auto dot(const Vec3d& d, const std::array<Expansion<16>, 3>& n) {
  return Expansion<1>(d.x) * n[0] + Expansion<1>(d.y) * n[1] + Expansion<1>(d.z) * n[2];
}

}  // namespace

/// T3 for an origin next to the plane, where the signs of the edge functions are sure.
bool TriangleRay::settle_next_to(const Triangle& ordered, const Vec3d& a, double sum, double bound,
                                 Crossing& crossing) const {
  const Height own(ordered, a);
  const double share = std::fabs(sum), squared = direction_.z * direction_.z;
  const bool is_sure = std::fabs(own.value) > own.bound && own.bound * squared <= 0x1p-37 * reach_ * share;
  if (!is_sure || bound > 0x1p-20 * share) return intersect_exactly(ordered, crossing);
  crossing.t = -own.value * direction_.z / sum;
  return true;
}

/// The same edge functions without the shear: u = d . (c x b), v = d . (a x c), w = d . (b x a), relative to the
/// origin. Their sum is the direction's component along the normal, and a . (c x b) the origin's height, both with one
/// factor.
bool TriangleRay::intersect_exactly(const Triangle& ordered, Crossing& crossing) const {
  const ExactVector a = relative_to(origin_, ordered.a);
  const ExactVector b = relative_to(origin_, ordered.b);
  const ExactVector c = relative_to(origin_, ordered.c);
  const auto c_cross_b = cross(c, b);
  const auto u = dot(direction_, c_cross_b);
  const auto v = dot(direction_, cross(a, c));
  const auto w = dot(direction_, cross(b, a));
  const bool has_negative = u.sign() < 0 || v.sign() < 0 || w.sign() < 0;
  const bool has_positive = u.sign() > 0 || v.sign() > 0 || w.sign() > 0;
  if (has_negative == has_positive) return false;  // outside, or edge-on where all three vanish
  const double sum = (u + v + w).estimate();
  const auto height = a.x * c_cross_b[0] + a.y * c_cross_b[1] + a.z * c_cross_b[2];
  crossing.t = height.estimate() / sum;
  crossing.u = v.estimate() / sum;
  crossing.v = w.estimate() / sum;
  return true;
}

double TriangleRay::nearest_t(const Triangle& triangle) const {
  const Ray<double> ray{origin_, direction_};
  const solid::Facet facet{{Vec3d(in_order(triangle.a)), Vec3d(in_order(triangle.b)), Vec3d(in_order(triangle.c))}};
  const auto [slope, level] = solid::form_of(facet, FramedRay(ray).in<Dyadic>());
  return real_roots({level, slope}).front().nearest();
}

Aabb clip(const Triangle& triangle, const Aabb& box) {
  const Aabb whole = bounds_of(triangle);
  if (box.contains(whole)) return whole;
  Aabb clipped = intersection(whole, box);
  if (clipped.is_empty()) return {};

  // Relative to a corner of the box, so that rounding is small beside the sizes involved and not beside their distance
  // from the world's origin.
  const Vec3d corner(box.lo);
  std::array<Vec3d, 9> polygon{Vec3d(triangle.a) - corner, Vec3d(triangle.b) - corner, Vec3d(triangle.c) - corner};
  std::array<Vec3d, 9> kept;
  int count = 3;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool is_upper : {false, true}) {
      const double plane = (is_upper ? double(box.hi[axis]) : double(box.lo[axis])) - corner[axis];
      int kept_count = 0;
      for (int i = 0; i < count; ++i) {
        const Vec3d& from = polygon[i];
        const Vec3d& to = polygon[(i + 1) % count];
        const double from_side = is_upper ? plane - from[axis] : from[axis] - plane;
        const double to_side = is_upper ? plane - to[axis] : to[axis] - plane;
        if (from_side >= 0) kept[kept_count++] = from;
        if ((from_side > 0 && to_side < 0) || (from_side < 0 && to_side > 0)) {
          Vec3d cut = from + (from_side / (from_side - to_side)) * (to - from);
          cut[axis] = plane;
          kept[kept_count++] = cut;
        }
      }
      count = kept_count;
      polygon = kept;
    }
  }
  if (count == 0) return {};
  Aabb tight;
  for (int i = 0; i < count; ++i) {
    const Vec3d p = polygon[i] + corner;
    tight.extend(Vec3f(round_down(p.x), round_down(p.y), round_down(p.z)));
    tight.extend(Vec3f(round_up(p.x), round_up(p.y), round_up(p.z)));
  }
  clipped = intersection(clipped, tight);
  return clipped;
}

Hull hull_of(const Triangle& triangle) {
  Hull hull;
  hull.points.push_back(triangle.a);
  hull.points.push_back(triangle.b);
  hull.points.push_back(triangle.c);
  hull.is_polygon = true;
  return hull;
}

CandidatePlanes planes_of(const Triangle& triangle) {
  const std::array<Vec3d, 3> corners{Vec3d(triangle.a), Vec3d(triangle.b), Vec3d(triangle.c)};
  const Vec3d normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (!(glm::dot(normal, normal) > 0)) return faces_of(bounds_of(triangle));
  CandidatePlanes planes;
  const auto add = [&](const Vec3d& direction, const Vec3d& point) {
    const Vec3d unit = glm::normalize(direction);
    planes.push_back({unit, glm::dot(unit, point)});
  };
  add(normal, corners[0]);
  for (int i = 0; i < 3; ++i) add(glm::cross(normal, corners[(i + 1) % 3] - corners[i]), corners[i]);
  return planes;
}

}  // namespace sightline
