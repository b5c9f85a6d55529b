#pragma once

#include <array>
#include <cassert>
#include <utility>
#include <vector>

#include "sightline/math/simd.h"
#include "sightline/shape/triangle.h"

namespace sightline {

/// Triangles that share vertices, in the order of their ids. Immutable once made.
///   Indices are below positions().size() and positions are finite: loaders refuse files where they are not.
///   Triangles without area are legal.
class TriangleMesh {
 public:
  using Shape = Triangle;
  using PreparedRay = TriangleRay;
  using Corners = std::array<std::uint32_t, 3>;

  TriangleMesh() = default;
  TriangleMesh(std::vector<Vec3f> positions, std::vector<Corners> triangles)
      : positions_(std::move(positions)), triangles_(std::move(triangles)) {
    for (const Vec3f& p : positions_) bounds_.extend(p);
  }

  const std::vector<Vec3f>& positions() const { return positions_; }
  const std::vector<Corners>& triangles() const { return triangles_; }

  /// Bounds of all vertices.
  const Aabb& bounds() const { return bounds_; }

  std::uint32_t size() const { return static_cast<std::uint32_t>(triangles_.size()); }
  Triangle operator[](std::uint32_t id) const {
    assert(id < size());
    const Corners& corners = triangles_[id];
    return {positions_[corners[0]], positions_[corners[1]], positions_[corners[2]]};
  }

  /// Has the triangle's corners brought near, though not their positions.
  void fetch(std::uint32_t id) const { prefetch(&triangles_[id], sizeof(Corners)); }

  Aabb bounds(std::uint32_t id) const { return bounds_of((*this)[id]); }
  Aabb clip(std::uint32_t id, const Aabb& box) const { return sightline::clip((*this)[id], box); }
  Hull hull(std::uint32_t id) const { return hull_of((*this)[id]); }
  CandidatePlanes planes(std::uint32_t id) const { return planes_of((*this)[id]); }
  TriangleRay prepare(const Ray<double>& ray) const { return {ray, bounds_}; }

 private:
  std::vector<Vec3f> positions_;
  std::vector<Corners> triangles_;
  Aabb bounds_;
};

static_assert(Shapes<TriangleMesh>);

}  // namespace sightline
