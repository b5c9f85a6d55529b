#include "sightline/shape/triangle_crossings.h"

#include <algorithm>
#include <compare>
#include <limits>

#include "sightline/math/algebraic_root.h"
#include "sightline/shape/solid_shape.h"

namespace sightline {
namespace {

/// A crossing where slope t + level is 0; the slope is positive, the level is not.
struct Crossed {
  std::uint32_t triangle;
  Dyadic slope, level;
  DoubleBall t;
};

std::strong_ordering compare(const Crossed& a, const Crossed& b) {
  if (const Sign sign = sign_of(a.t - b.t); sign.is_certain && sign.value != 0) return sign.value <=> 0;
  return b.level * a.slope <=> a.level * b.slope;
}

double nearest(const Crossed& crossed) { return real_roots({crossed.level, crossed.slope}).front().nearest(); }

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
    auto [slope, level] = solid::form_of(facet, exact);
    if (slope.sign() < 0) {
      slope = -slope;
      level = -level;
    }
    if (level.sign() > 0) return;
    const auto near = solid::form_of(facet, bounded);
    crossed.push_back({id, slope, level, -near.level / near.slope});
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
      const auto a = triple<float>(facet.vertices[i]), b = triple<float>(facet.vertices[(i + 1) % 3]);
      const float side = dot(line.direction, cross(difference(a, line.origin), difference(b, line.origin)));
      least = std::min(least, side);
      most = std::max(most, side);
    }
    if (least < 0 && most > 0) return;
    const auto [slope, level] = solid::form_of(facet, line);
    if (const float t = -level / slope; slope != 0 && t >= 0) crossed.push_back({t, id});
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
