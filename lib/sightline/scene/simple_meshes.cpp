#include "sightline/scene/simple_meshes.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace sightline {
namespace {

/// Collects vertices, none of which are joined.
class Builder {
 public:
  std::uint32_t vertex(const Vec3d& p, const Vec3d& normal, const glm::dvec2& uv) {
    positions_.emplace_back(p);
    if (!is_finite(positions_.back())) throw std::invalid_argument("expected lengths finite as floats, found more");
    normals_.emplace_back(normal);
    uvs_.emplace_back(uv);
    return static_cast<std::uint32_t>(positions_.size() - 1);
  }
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangles_.push_back({a, b, c});
    triangles_.push_back({a, c, d});
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles_.push_back({a, b, c}); }
  MeshGeometry take() {
    auto mesh = std::make_shared<const TriangleMesh>(std::move(positions_), std::move(triangles_));
    return {std::move(mesh), std::move(normals_), std::move(uvs_)};
  }

 private:
  std::vector<Vec3f> positions_, normals_;
  std::vector<glm::vec2> uvs_;
  std::vector<TriangleMesh::Corners> triangles_;
};

void check_segments(int segments) {
  if (segments >= 3 && segments <= most_segments) return;
  throw std::invalid_argument("expected 3 to " + std::to_string(most_segments) + " segments, found " +
                              std::to_string(segments));
}

/// To the right of the way up.
glm::dvec2 outward(const glm::dvec2& from, const glm::dvec2& to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  return length > 0 ? glm::dvec2((to.y - from.y) / length, (from.x - to.x) / length) : glm::dvec2(0);
}

glm::dvec2 unit_or(const glm::dvec2& v, const glm::dvec2& otherwise) {
  const double length = std::hypot(v.x, v.y);
  return length > 0 ? glm::dvec2(v.x / length, v.y / length) : otherwise;
}

}  // namespace

MeshGeometry make_lathe(std::span<const glm::dvec2> profile, int segments, bool is_smooth) {
  check_segments(segments);
  if (profile.size() < 2) throw std::invalid_argument("expected a profile of at least 2 points");
  std::vector<double> along{0};
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!(profile[i].x >= 0) || !std::isfinite(profile[i].x) || !std::isfinite(profile[i].y)) {
      throw std::invalid_argument("expected distances from the axis of at least 0, found another in point " +
                                  std::to_string(i));
    }
    if (i > 0)
      along.push_back(along.back() + std::hypot(profile[i].x - profile[i - 1].x, profile[i].y - profile[i - 1].y));
  }
  if (!(along.back() > 0) || !std::isfinite(along.back()))
    throw std::invalid_argument("expected a profile of finite length");

  Builder builder;
  const auto ring = [&](std::size_t point, const glm::dvec2& normal) {
    std::vector<std::uint32_t> vertices;
    for (int k = 0; k <= segments; ++k) {
      const double turn = k == segments ? 0 : 2 * std::numbers::pi * k / segments;  // closed without a gap
      const double c = std::cos(turn), s = -std::sin(turn);
      const auto [radius, height] = std::pair(profile[point].x, profile[point].y);
      vertices.push_back(builder.vertex({radius * c, height, radius * s}, {normal.x * c, normal.y, normal.x * s},
                                        {double(k) / segments, along[point] / along.back()}));
    }
    return vertices;
  };
  bool has_surface = false;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const glm::dvec2 flat = outward(profile[i], profile[i + 1]);
    glm::dvec2 lower = flat, upper = flat;
    if (is_smooth && i > 0) lower = unit_or(flat + outward(profile[i - 1], profile[i]), flat);
    if (is_smooth && i + 2 < profile.size()) upper = unit_or(flat + outward(profile[i + 1], profile[i + 2]), flat);
    if (flat == glm::dvec2(0) || (profile[i].x == 0 && profile[i + 1].x == 0)) continue;
    const auto below = ring(i, lower), above = ring(i + 1, upper);
    has_surface = true;
    for (std::size_t k = 0; k < static_cast<std::size_t>(segments); ++k) {
      if (profile[i].x > 0) builder.triangle(below[k], below[k + 1], above[k + 1]);
      if (profile[i + 1].x > 0) builder.triangle(below[k], above[k + 1], above[k]);
    }
  }
  if (!has_surface) throw std::invalid_argument("expected a profile off its axis");
  return builder.take();
}

MeshGeometry make_sphere(double radius, int segments) {
  check_segments(segments);
  if (!(radius > 0) || !std::isfinite(radius)) throw std::invalid_argument("expected a radius above 0");
  const int rings = (segments + 1) / 2;
  Builder builder;
  const auto vertex = [&](int ring, int k) {
    const double turn = k == segments ? 0 : 2 * std::numbers::pi * k / segments;
    const double rise = std::numbers::pi * ring / rings;
    const double across = ring == 0 || ring == rings ? 0 : std::sin(rise);
    const Vec3d normal(across * std::cos(turn),
                       ring == 0       ? -1
                       : ring == rings ? 1
                                       : -std::cos(rise),
                       -across * std::sin(turn));
    return builder.vertex(radius * normal, normal, {double(k) / segments, double(ring) / rings});
  };
  for (int ring = 0; ring <= rings; ++ring) {
    for (int k = 0; k <= segments; ++k) vertex(ring, k);
  }
  const auto at = [&](int ring, int k) { return static_cast<std::uint32_t>(ring * (segments + 1) + k); };
  for (int ring = 0; ring < rings; ++ring) {
    for (int k = 0; k < segments; ++k) {
      if (ring > 0) builder.triangle(at(ring, k), at(ring, k + 1), at(ring + 1, k + 1));
      if (ring + 1 < rings) builder.triangle(at(ring, k), at(ring + 1, k + 1), at(ring + 1, k));
    }
  }
  return builder.take();
}

MeshGeometry make_box(const Vec3d& lo, const Vec3d& hi) {
  if (!is_finite(lo) || !is_finite(hi) || !glm::all(glm::lessThan(lo, hi))) {
    throw std::invalid_argument("expected a box whose \"lo\" is below its \"hi\"");
  }
  Builder builder;
  for (int axis = 0; axis < 3; ++axis) {
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    for (const bool is_upper : {false, true}) {
      Vec3d normal(0);
      normal[axis] = is_upper ? 1 : -1;
      const auto corner = [&](bool right, bool above) {
        Vec3d p = is_upper ? hi : lo;
        p[next] = right ? hi[next] : lo[next];
        p[last] = above ? hi[last] : lo[last];
        return builder.vertex(p, normal, {right == is_upper ? 1 : 0, above ? 1 : 0});
      };
      const auto a = corner(false, false), b = corner(true, false), c = corner(true, true), d = corner(false, true);
      is_upper ? builder.quad(a, b, c, d) : builder.quad(d, c, b, a);
    }
  }
  return builder.take();
}

MeshGeometry make_quad(double width, double height, double repeat) {
  for (const double each : {width, height, repeat}) {
    if (!(each > 0) || !std::isfinite(each)) throw std::invalid_argument("expected lengths above 0");
  }
  Builder builder;
  const Vec3d up(0, 1, 0);
  const double x = width / 2, z = height / 2;
  const auto a = builder.vertex({-x, 0, z}, up, {0, 0}), b = builder.vertex({x, 0, z}, up, {repeat, 0});
  const auto c = builder.vertex({x, 0, -z}, up, {repeat, repeat}), d = builder.vertex({-x, 0, -z}, up, {0, repeat});
  builder.quad(a, b, c, d);
  return builder.take();
}

}  // namespace sightline
