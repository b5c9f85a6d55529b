#include "bench/verify.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>

namespace sightline::bench {
namespace {

bool is_same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

/// An upper bound of |cross(a, b)| for vectors within these absolute components.
Vec3d cross_bound(const Vec3d& a, const Vec3d& b) {
  return {a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
}

}  // namespace

bool is_same(const Hit<float>& a, const Hit<float>& b) {
  return a.prim_id == b.prim_id && is_same_bits(a.t, b.t) && is_same_bits(a.u, b.u) && is_same_bits(a.v, b.v);
}

std::string hit_text(const Hit<float>& hit) {
  if (!hit.is_hit()) return "no hit";
  char text[128];
  std::snprintf(text, sizeof text, "t %.9g on triangle %u (u %.9g, v %.9g)", hit.t, hit.prim_id, hit.u, hit.v);
  return text;
}

/// With N the computed normal, dN its error, and P the true point: N.(a - O) / N.D - t = N.(a - P) / N.D, where the
/// true normal is at right angles to a - P. So dN counts only over that short distance, and what remains is the
/// rounding of the two dot products and of the quotient. u is the unit roundoff; second-order terms are covered by the
/// factor 2.
double t_error_bound(const Triangle& triangle, const Ray<float>& ray) {
  constexpr double u = 0x1p-24;
  const Vec3d origin(ray.origin), direction(ray.direction);
  const Vec3d a = Vec3d(triangle.a) - origin, b = Vec3d(triangle.b) - origin, c = Vec3d(triangle.c) - origin;
  const Vec3d normal = glm::cross(b - a, c - a);
  const Vec3d edge = glm::abs(b - a) + glm::abs(c - a);  // bounds all three
  const Vec3d edge_error = u * (edge + glm::abs(a) + glm::abs(b) + glm::abs(c));
  const Vec3d normal_error = 2.0 * cross_bound(edge, edge_error) + 3 * u * cross_bound(edge, edge);

  const double slope = glm::dot(normal, direction);
  const double slope_rounding = 3 * u * glm::dot(glm::abs(normal), glm::abs(direction));
  const double slope_error = glm::dot(normal_error, glm::abs(direction)) + slope_rounding;
  if (!(std::fabs(slope) > 2 * slope_error)) return std::numeric_limits<double>::infinity();
  const double t = glm::dot(normal, a) / slope;
  const double error = glm::dot(normal_error, glm::abs(a - t * direction)) +
                       4 * u * glm::dot(glm::abs(normal), glm::abs(a)) + std::fabs(t) * slope_rounding;
  return 2 * error / (std::fabs(slope) - slope_error) + 6 * u * std::fabs(t);
}

bool agrees(const TriangleMesh& mesh, const Ray<float>& ray, const Hit<float>& ours, const Hit<float>& peer) {
  if (ours.is_hit() != peer.is_hit()) return false;
  if (!ours.is_hit()) return true;
  if (peer.prim_id >= mesh.size()) return false;
  double bound = t_error_bound(mesh[peer.prim_id], ray);
  if (peer.prim_id != ours.prim_id) bound += t_error_bound(mesh[ours.prim_id], ray);
  return std::fabs(static_cast<double>(ours.t) - peer.t) <= bound;
}

}  // namespace sightline::bench
