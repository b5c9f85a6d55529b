#include "sightline/shape/triangle_crossings.h"

#include <algorithm>
#include <compare>
#include <limits>

#include "sightline/math/algebraic_root.h"

namespace sightline {
namespace {

template <class N>
using Triple = std::array<N, 3>;

template <class N>
Triple<N> difference(const Vec3d& a, const Triple<N>& b) {
  return {N(a.x) - b[0], N(a.y) - b[1], N(a.z) - b[2]};
}
template <class N>
Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class N>
N dot(const Triple<N>& a, const Triple<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The triangle's plane along the line: slope t = rise.
template <class N>
struct PlaneAlong {
  N slope, rise;
};

template <class N>
PlaneAlong<N> plane_along(const Line<N>& line, const solid::Facet& facet) {
  const auto& [a, b, c] = facet.vertices;
  const Triple<N> from{N(a.x), N(a.y), N(a.z)};
  const Triple<N> normal = cross(difference(b, from), difference(c, from));
  return {dot(normal, line.direction), dot(normal, difference(a, line.origin))};
}

/// A crossing at rise / slope; the slope is positive.
struct Crossed {
  std::uint32_t triangle;
  Dyadic slope, rise;
  DoubleBall t;
};

std::strong_ordering compare(const Crossed& a, const Crossed& b) {
  if (const Sign sign = sign_of(a.t - b.t); sign.is_certain && sign.value != 0) return sign.value <=> 0;
  return a.rise * b.slope <=> b.rise * a.slope;
}

double nearest(const Crossed& crossed) { return real_roots({-crossed.rise, crossed.slope}).front().nearest(); }

template <class See>
void for_each_facet(std::span<const Vec3d> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
                    See&& see) {
  for (std::uint32_t id = 0; id < triangles.size(); ++id) {
    const auto [a, b, c] = triangles[id];
    see(id, solid::Facet{{vertices[a], vertices[b], vertices[c]}});
  }
}

}  // namespace

std::vector<TriangleCrossing> triangle_crossings(const FramedRay& ray, std::span<const Vec3d> vertices,
                                                 std::span<const std::array<std::uint32_t, 3>> triangles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3d lo(infinity), hi(-infinity);
  for (const Vec3d& p : vertices) {
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
  const FacetLine line(ray, lo, hi);
  const auto exact = ray.in<Dyadic>();
  const auto bounded = ray.in<DoubleBall>();
  std::vector<Crossed> crossed;
  for_each_facet(vertices, triangles, [&](std::uint32_t id, const solid::Facet& facet) {
    if (!line.crosses(facet)) return;
    auto [slope, rise] = plane_along(exact, facet);
    if (slope.sign() < 0) {
      slope = -slope;
      rise = -rise;
    }
    if (rise.sign() < 0) return;
    const auto near = plane_along(bounded, facet);
    crossed.push_back({id, slope, rise, near.rise / near.slope});
  });
  std::stable_sort(crossed.begin(), crossed.end(), [](const auto& a, const auto& b) { return compare(a, b) < 0; });
  std::vector<TriangleCrossing> crossings;
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    if (i == 0 || compare(crossed[i - 1], crossed[i]) != 0) crossings.push_back({nearest(crossed[i]), {}});
    crossings.back().triangles.push_back(crossed[i].triangle);
  }
  return crossings;
}

std::vector<TriangleCrossing> rounded_triangle_crossings(const FramedRay& ray, std::span<const Vec3d> vertices,
                                                         std::span<const std::array<std::uint32_t, 3>> triangles) {
  const auto line = ray.in<float>();
  struct Rounded {
    float t;
    std::uint32_t triangle;
  };
  std::vector<Rounded> crossed;
  for_each_facet(vertices, triangles, [&](std::uint32_t id, const solid::Facet& facet) {
    float least = 0, most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const float side = dot(line.direction, cross(difference(facet.vertices[i], line.origin),
                                                   difference(facet.vertices[(i + 1) % 3], line.origin)));
      least = std::min(least, side);
      most = std::max(most, side);
    }
    if (least < 0 && most > 0) return;
    const auto [slope, rise] = plane_along(line, facet);
    if (const float t = rise / slope; slope != 0 && t >= 0) crossed.push_back({t, id});
  });
  std::stable_sort(crossed.begin(), crossed.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  std::vector<TriangleCrossing> crossings;
  for (const auto& [t, triangle] : crossed) {
    if (crossings.empty() || crossings.back().t != static_cast<double>(t)) crossings.push_back({t, {}});
    crossings.back().triangles.push_back(triangle);
  }
  return crossings;
}

}  // namespace sightline
