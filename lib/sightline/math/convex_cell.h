#pragma once
/// Convex polyhedra that planes cut: the cells of a binary space partition.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "sightline/math/interval.h"
#include "sightline/math/volumes.h"

namespace sightline {

/// Lowest and highest normal . point.
inline Interval<double> extent_along(std::span<const Vec3d> points, const Vec3d& normal) {
  Interval<double> extent;
  for (const Vec3d& point : points) {
    const double height = glm::dot(normal, point);
    extent.lo = height < extent.lo ? height : extent.lo;
    extent.hi = height > extent.hi ? height : extent.hi;
  }
  return extent;
}

/// A bounded convex polyhedron; flat ones are legal and have an area too (both of their sides).
///   C1  Every face is a convex loop, counter-clockwise when seen from outside; neighbours share vertex numbers.
///   C2  No more than max_vertices: a cut that would make more leaves the cell whole, which is still a superset.
/// Candidates are measured without allocating; only `keep_below` writes a new cell, into storage that can be reused.
class ConvexCell {
 public:
  static constexpr int max_vertices = 256;

  /// Signed heights of the vertices over a plane, in units of its normal.
  struct Heights {
    std::array<double, max_vertices> of;
    double lo, hi;
  };
  struct Areas {
    double below, above;
  };

  static ConvexCell box(const Vec3d& lo, const Vec3d& hi) {
    ConvexCell cell;
    for (int corner = 0; corner < 8; ++corner) {
      cell.vertices_.push_back({corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z});
    }
    constexpr std::uint32_t loops[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& loop : loops) {
      cell.loops_.insert(cell.loops_.end(), loop, loop + 4);
      cell.close_face();
    }
    return cell;
  }

  bool is_empty() const { return faces_.empty(); }
  double area() const { return area_; }

  void measure(const Plane& plane, Heights& heights) const {
    heights.lo = std::numeric_limits<double>::infinity();
    heights.hi = -heights.lo;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      const double height = plane.side(vertices_[v]);
      heights.of[v] = height;
      heights.lo = height < heights.lo ? height : heights.lo;
      heights.hi = height > heights.hi ? height : heights.hi;
    }
  }

  /// Lowest and highest normal . vertex.
  Interval<double> extent(const Vec3d& normal) const { return extent_along(vertices_, normal); }

  /// Area of the cell's projection along a normal of any length.
  double shadow(const Vec3d& normal) const {
    double twice = 0;
    for (const Face& face : faces_) twice += std::fabs(glm::dot(normal, face.doubled));
    return 0.25 * twice / glm::length(normal);
  }

  /// Surface areas of the two parts, each with the section that closes it. A face that the plane crosses is cut at two
  /// points; the section is the sum of the triangles that such pairs make with any point of the plane. Vertices on the
  /// plane count as below it, so that an edge on it is part of the section once: as the cut of the face above.
  Areas areas(const Heights& heights) const {
    double below = 0, above = 0;
    Vec3d section(0), anchor(0);
    bool has_anchor = false;
    for (const Face& face : faces_) {
      const std::uint32_t* loop = loops_.data() + face.first;
      double lowest = heights.of[loop[0]], highest = lowest;
      for (std::uint32_t i = 1; i < face.count; ++i) {
        const double height = heights.of[loop[i]];
        lowest = height < lowest ? height : lowest;
        highest = height > highest ? height : highest;
      }
      if (highest <= 0) {
        below += face.area;
      } else if (lowest > 0) {
        above += face.area;
      } else {
        const auto is_below = [&](std::uint32_t i) { return heights.of[loop[i]] <= 0; };
        const auto after = [&](std::uint32_t i) { return i + 1 == face.count ? 0 : i + 1; };
        std::uint32_t at = 0;
        while (is_below(at) || !is_below(after(at))) ++at;
        // Once around from where the loop comes below, as a fan around that point. Of a face that all but lies on the
        // plane, rounding may put several runs of vertices below.
        const Vec3d start = crossing(heights, loop[at], loop[after(at)]);
        if (!has_anchor) anchor = start;
        has_anchor = true;
        Vec3d previous(0), leave(0), doubled(0);
        const auto go_to = [&](const Vec3d& point) {
          doubled += glm::cross(previous, point - start);
          previous = point - start;
        };
        for (std::uint32_t i = 0; i < face.count; ++i) {
          const std::uint32_t from = at;
          at = after(at);
          if (is_below(from) != is_below(at)) {
            const Vec3d point = crossing(heights, loop[from], loop[at]);
            go_to(point);
            if (is_below(from)) {
              leave = point;
            } else if (i > 0) {
              section += glm::cross(point - anchor, leave - anchor);
            }
          }
          if (is_below(at)) go_to(vertices_[loop[at]]);
        }
        section += glm::cross(start - anchor, leave - anchor);
        const double part = std::min(0.5 * glm::length(doubled), face.area);
        below += part;
        above += face.area - part;
      }
    }
    const double closing = 0.5 * glm::length(section);
    return {below + closing, above + closing};
  }

  /// The part with heights <= 0, into `part`; empty where there is none. Vertices within `tolerance` of the plane count
  /// as lying on it, so that rounding makes no slivers. A face that leaves the tolerance of the plane only just, and on
  /// the side that is kept, stays beside the section that overlaps it: the area is then too large, the part is right.
  void keep_below(const Plane& plane, double tolerance, ConvexCell& part) const {
    Heights heights;
    measure(plane, heights);
    part.clear();
    if (heights.lo >= -tolerance && heights.hi > tolerance) return;
    if (heights.hi <= tolerance || most_kept(heights, tolerance) > max_vertices) {
      part = *this;
      return;
    }
    constexpr std::uint32_t none = ~0u;
    std::array<std::uint32_t, max_vertices> renumbered;
    std::array<std::uint32_t, max_vertices> section;
    std::uint32_t section_size = 0;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      renumbered[v] = none;
      if (heights.of[v] > tolerance) continue;
      renumbered[v] = static_cast<std::uint32_t>(part.vertices_.size());
      if (heights.of[v] >= -tolerance) section[section_size++] = renumbered[v];
      part.vertices_.push_back(vertices_[v]);
    }
    struct CutEdge {
      std::uint32_t lower, upper, vertex;
    };
    std::array<CutEdge, max_vertices> cuts;
    std::size_t cut_count = 0;
    const auto cut_edge = [&](std::uint32_t lower, std::uint32_t upper) {
      for (std::size_t i = 0; i < cut_count; ++i) {
        if (cuts[i].lower == lower && cuts[i].upper == upper) return cuts[i].vertex;
      }
      const auto vertex = static_cast<std::uint32_t>(part.vertices_.size());
      cuts[cut_count++] = {lower, upper, vertex};
      section[section_size++] = vertex;
      part.vertices_.push_back(crossing(heights, lower, upper));
      return vertex;
    };
    for (const Face& face : faces_) {
      const std::uint32_t* loop = loops_.data() + face.first;
      bool reaches_below = false;
      for (std::uint32_t i = 0; i < face.count; ++i) {
        const std::uint32_t from = loop[i], to = loop[i + 1 == face.count ? 0 : i + 1];
        const double from_height = heights.of[from], to_height = heights.of[to];
        reaches_below |= from_height < -tolerance;
        if (renumbered[from] != none) part.loops_.push_back(renumbered[from]);
        if (from_height < -tolerance && to_height > tolerance) part.loops_.push_back(cut_edge(from, to));
        if (to_height < -tolerance && from_height > tolerance) part.loops_.push_back(cut_edge(to, from));
      }
      part.close_face(reaches_below);
    }
    part.close_section(plane.normal, {section.data(), section_size});
  }

  /// The cell moved by `offset`.
  Polyhedron polyhedron(const Vec3d& offset) const {
    Polyhedron solid;
    for (const Vec3d& vertex : vertices_) solid.vertices.push_back(vertex + offset);
    for (const Face& face : faces_) {
      solid.faces.emplace_back(loops_.begin() + face.first, loops_.begin() + face.first + face.count);
    }
    return solid;
  }

 private:
  struct Face {
    std::uint32_t first, count;  ///< In loops_.
    double area;
    Vec3d doubled;  ///< Twice the area, along the normal.
  };

  void clear() {
    vertices_.clear();
    loops_.clear();
    faces_.clear();
    area_ = 0;
  }

  /// No fewer than the vertices that a cut keeps and makes (C2). Each face that shares a cut edge counts it, since
  /// faces that have shrunk to nothing are dropped and an edge may have only one left.
  std::size_t most_kept(const Heights& heights, double tolerance) const {
    std::size_t count = 0;
    for (std::size_t v = 0; v < vertices_.size(); ++v) count += !(heights.of[v] > tolerance);
    for (const Face& face : faces_) {
      const std::uint32_t* loop = loops_.data() + face.first;
      for (std::uint32_t i = 0, from = loop[face.count - 1]; i < face.count; from = loop[i++]) {
        count += std::min(heights.of[from], heights.of[loop[i]]) < -tolerance &&
                 std::max(heights.of[from], heights.of[loop[i]]) > tolerance;
      }
    }
    return count;
  }

  /// Where the edge meets the plane: the same point from whichever end it is asked.
  Vec3d crossing(const Heights& heights, std::uint32_t a, std::uint32_t b) const {
    if (a > b) std::swap(a, b);
    const double from = heights.of[a], to = heights.of[b];
    return vertices_[a] + (from / (from - to)) * (vertices_[b] - vertices_[a]);
  }

  /// Makes the loop numbers not yet in a face one, or drops them.
  void close_face(bool is_kept = true) {
    const std::uint32_t first = faces_.empty() ? 0 : faces_.back().first + faces_.back().count;
    const auto count = static_cast<std::uint32_t>(loops_.size()) - first;
    if (!is_kept || count < 3) {
      loops_.resize(first);
      return;
    }
    const Vec3d& corner = vertices_[loops_[first]];
    Vec3d doubled(0);
    for (std::uint32_t i = first + 1; i + 1 < first + count; ++i) {
      doubled += glm::cross(vertices_[loops_[i]] - corner, vertices_[loops_[i + 1]] - corner);
    }
    faces_.push_back({first, count, 0.5 * glm::length(doubled), doubled});
    area_ += faces_.back().area;
  }

  /// The section is convex, so its vertices are put in order by their angle around their middle.
  void close_section(const Vec3d& normal, std::span<std::uint32_t> section) {
    if (section.size() < 3) return;
    Vec3d middle(0);
    for (const std::uint32_t v : section) middle += vertices_[v];
    middle /= static_cast<double>(section.size());
    const Vec3d size = glm::abs(normal);
    Vec3d axis(0);
    axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
    const Vec3d u = glm::cross(axis, normal), v = glm::cross(normal, u) / glm::length(normal);
    std::array<std::pair<double, std::uint32_t>, max_vertices> ordered;
    for (std::size_t i = 0; i < section.size(); ++i) {
      const Vec3d arm = vertices_[section[i]] - middle;
      ordered[i] = {std::atan2(glm::dot(arm, v), glm::dot(arm, u)), section[i]};
    }
    std::sort(ordered.begin(), ordered.begin() + section.size());
    for (std::size_t i = 0; i < section.size(); ++i) loops_.push_back(ordered[i].second);
    close_face();
  }

  std::vector<Vec3d> vertices_;
  std::vector<std::uint32_t> loops_;  ///< Vertex numbers, face after face.
  std::vector<Face> faces_;
  double area_ = 0;
};

}  // namespace sightline
