#include "sightline/shape/triangle.h"

#include <array>

#include "sightline/math/expansion.h"
#include "sightline/math/rounding.h"

namespace sightline {
namespace {

constexpr double unit_roundoff = 0x1p-53;

/// With m the largest |vertex - origin| and M the largest sheared coordinate: a sheared coordinate is off by at most 6
/// u m (two rounded differences, a rounded slope, a product, a difference), so an edge function, two products of such
/// coordinates, by 4 * 6 u m M plus 8 u m M for its own roundings. 32 in all; the rest is for terms in u^2.
constexpr double edge_error = 40 * unit_roundoff;

/// The weighted mean of the vertices strays from the ray by 3 edge_error m M * M / |u + v + w|. It must stay below the
/// 2^-35 m that margin M1 grants to double rays, so the sum must exceed this share of M^2.
constexpr double least_weight = 3 * edge_error * 0x1p+35;

/// The height of the origin over the triangle, u a + v b + w c along z, is off by at most this share of m times an edge
/// function's error: 3 for those of u, v and w, 2 for its own roundings; the rest is for terms in u^2. Below that the
/// sign of t is open.
constexpr double height_error = 8;

/// Of a product of three differences, summed over three axes: at most 8 u of the sum of sizes.
constexpr double volume_error = 16 * unit_roundoff;

/// Lines that rise over the triangle by less than that are left to expansions: of others t is off by less than 2^-39 m,
/// half for the height's error and half for that of the slope, 8 u in 2^-10 each.
constexpr double least_slope = 0x1p-10;

/// t by the triangle's normal, from its corner a relative to the origin: errors are small beside the triangle's size
/// and not beside its distance, so this tells on which side of its plane an origin near it is. False where it does not.
bool parameter_by_normal(const Triangle& triangle, const Vec3d& a, const Vec3d& direction, double& t) {
  const Vec3d p = Vec3d(triangle.b) - Vec3d(triangle.a), q = Vec3d(triangle.c) - Vec3d(triangle.a);
  const Vec3d size(std::fabs(p.y * q.z) + std::fabs(p.z * q.y), std::fabs(p.z * q.x) + std::fabs(p.x * q.z),
                   std::fabs(p.x * q.y) + std::fabs(p.y * q.x));
  const Vec3d normal = glm::cross(p, q);
  const double height = glm::dot(a, normal), slope = glm::dot(direction, normal);
  t = height / slope;
  return std::fabs(height) > volume_error * glm::dot(glm::abs(a), size) &&
         std::fabs(slope) > least_slope * max_norm(direction) * (size.x + size.y + size.z);
}

struct ExactVector {
  Expansion<2> x, y, z;
};

ExactVector relative_to(const Vec3d& origin, const Vec3f& p) {
  return {exact_difference(p.x, origin.x), exact_difference(p.y, origin.y), exact_difference(p.z, origin.z)};
}

std::array<Expansion<16>, 3> cross(const ExactVector& p, const ExactVector& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

auto dot(const Vec3d& d, const std::array<Expansion<16>, 3>& n) {
  return Expansion<1>(d.x) * n[0] + Expansion<1>(d.y) * n[1] + Expansion<1>(d.z) * n[2];
}

}  // namespace

TriangleRay::TriangleRay(const Ray<double>& ray, const Aabb& bounds) : origin_(ray.origin), direction_(ray.direction) {
  const Vec3d size = glm::abs(direction_);
  kz_ = largest_axis(size);
  kx_ = (kz_ + 1) % 3;
  ky_ = (kx_ + 1) % 3;
  if (direction_[kz_] < 0) std::swap(kx_, ky_);
  scale_z_ = 1 / direction_[kz_];
  shear_x_ = direction_[kx_] / direction_[kz_];
  shear_y_ = direction_[ky_] / direction_[kz_];
  const double reach = reach_of(origin_, bounds);
  sign_bound_ = 2 * edge_error * reach * reach;  // M <= 2 m, as slopes are at most 1
}

bool TriangleRay::settle(const Triangle& triangle, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Sheared& s,
                         double u, double v, double w, Crossing& crossing) const {
  const double reach = std::max({max_norm(a), max_norm(b), max_norm(c)});
  const double size =
      std::max({std::fabs(s.ax), std::fabs(s.ay), std::fabs(s.bx), std::fabs(s.by), std::fabs(s.cx), std::fabs(s.cy)});
  const double bound = edge_error * reach * size;
  const double lowest = std::min({u, v, w}), highest = std::max({u, v, w});
  if (lowest < -bound && highest > bound) return false;
  const double sum = u + v + w;
  const bool is_settled = (lowest > bound || highest < -bound) && std::fabs(sum) > least_weight * size * size;
  if (!is_settled) return intersect_exactly(triangle, crossing);
  const double height = u * a[kz_] + v * b[kz_] + w * c[kz_];
  crossing.t = height * scale_z_ / sum;
  // A ray that begins on a triangle does not meet it again (Ray): t has the sign that it has in real arithmetic.
  if (std::fabs(height) <= height_error * bound * reach && !parameter_by_normal(triangle, a, direction_, crossing.t)) {
    return intersect_exactly(triangle, crossing);
  }
  crossing.u = v / sum;
  crossing.v = w / sum;
  return true;
}

/// The same edge functions without the shear: u = d . (c x b), v = d . (a x c), w = d . (b x a), relative to the
/// origin. Their sum is the direction's component along the normal, and a . (c x b) the origin's height, both with one
/// factor.
bool TriangleRay::intersect_exactly(const Triangle& triangle, Crossing& crossing) const {
  const ExactVector a = relative_to(origin_, triangle.a);
  const ExactVector b = relative_to(origin_, triangle.b);
  const ExactVector c = relative_to(origin_, triangle.c);
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
