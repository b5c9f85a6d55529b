#pragma once
/// Closed surfaces of triangles: the boundaries of solids.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "sightline/math/aabb.h"
#include "sightline/shape/facet.h"
#include "sightline/shape/facet_line.h"

namespace sightline {

/// Immutable once made.
///   C1  Each edge of a triangle is one of another triangle the other way round, and not of more one way than the
///   other.
///       Vertices at one place count as one.
///   C2  So the triangles seen along any line cover each point that is on no edge as often with their front as with
///       their back, however they fold and cut each other.
/// Triangles without area are legal. So are surfaces that cut themselves; what their inside is, their users decide.
class ClosedMesh {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  /// \throws std::invalid_argument naming the first vertex or triangle that is not as it should be.
  ClosedMesh(std::vector<Vec3d> vertices, std::vector<Corners> triangles);

  std::uint32_t size() const { return static_cast<std::uint32_t>(triangles_.size()); }
  const std::vector<Vec3d>& vertices() const { return vertices_; }
  const std::vector<Corners>& triangles() const { return triangles_; }

  solid::Facet facet(std::uint32_t id) const {
    const Corners& corners = triangles_[id];
    return {{vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]}};
  }

  /// Of all triangles, rounded outward.
  Aabb bounds() const { return bounds_; }

  /// A line to hold against any of the triangles.
  FacetLine line(const FramedRay& ray) const { return {ray, lo_, hi_}; }

  /// Calls see(triangle, enters) for each triangle that the line of a ray goes through, in the order of their ids:
  /// FacetLine::passage says which. As many enter as leave (C2).
  template <class See>
  void passages(const FramedRay& ray, See&& see) const {
    const FacetLine ready = line(ray);
    for_each_near(ready, [&](std::uint32_t id) {
      if (const int way = ready.passage(facet(id)); way != 0) see(id, way < 0);
    });
  }

 private:
  static constexpr std::uint32_t block_size = 64;
  using Block = std::array<std::uint8_t, block_size>;

  /// Triangles whose boxes the line meets, and some more that it nearly meets.
  template <class See>
  void for_each_near(const FacetLine& ready, See&& see) const {
    for (std::uint32_t first = 0; first < size(); first += block_size) {
      Block is_near;
      if (!look_near(ready, first, is_near)) continue;
      const std::uint32_t last = std::min(first + block_size, size());
      for (std::uint32_t id = first; id < last; ++id) {
        if (is_near[id - first] != 0) see(id);
      }
    }
  }

  bool look_near(const FacetLine&, std::uint32_t first, Block& is_near) const;
  void set_boxes();

  std::vector<Vec3d> vertices_;
  std::vector<Corners> triangles_;
  Vec3d lo_, hi_;      ///< Of the triangles.
  Vec3d middle_{0};    ///< What boxes are relative to.
  double extent_ = 0;  ///< No box reaches farther from the middle.
  /// By axis: middles of the triangles' boxes, and how far they reach from there, rounded up.
  std::array<std::vector<float>, 3> box_middles_, box_reaches_;
  Aabb bounds_;
};

}  // namespace sightline
