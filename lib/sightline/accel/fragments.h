#pragma once
/// The parts of primitives that lie in a cell.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "sightline/accel/primitives.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// Where a fragment lies: `below` and `above` are true where it passes the plane by more than the thickness given, so
/// both are false for one that lies on the plane.
struct Sides {
  bool below = false, above = false;
};

/// Each primitive's part as the corners of a convex polygon, clipped by every plane that crossed it; of a primitive
/// that is no polygon, the corners of a box around its part. Coordinates are relative to `center`, so that their
/// rounding is small beside the scene and not beside its distance from the world's origin.
class Fragments {
 public:
  struct Fragment {
    std::uint32_t id;
    std::uint32_t first;  ///< Of its points.
    std::uint32_t count : 31;
    std::uint32_t is_polygon : 1;
  };

  /// One more fragment: the part of primitive `id`, of which `bounds` are known, within a box; none where they are more
  /// than the thickness apart.
  void add_within(std::uint32_t id, const Aabb& bounds, const Aabb& box, double thickness, const Primitives& primitives,
                  const Vec3d& center) {
    const Hull hull = primitives.hull(id);
    if (!hull.is_polygon) {
      for (const Vec3f& p : hull_of(bounds).points) points_.push_back(Vec3d(p) - center);
      return add(id, false);
    }
    std::array<Vec3d, 32> corners, kept;  // a face makes one corner more of a convex polygon's
    int count = 0;
    for (const Vec3f& p : hull.points) corners[count++] = Vec3d(p) - center;
    for (int face = 0; face < 6 && count > 0; ++face) {
      const int axis = face >> 1;
      const double sign = face & 1 ? 1 : -1, offset = double(face & 1 ? box.hi[axis] : box.lo[axis]) - center[axis];
      const auto height = [&](const Vec3d& p) { return sign * (p[axis] - offset); };
      int kept_count = 0;
      for (int i = 0; i < count; ++i) {
        const Vec3d &at = corners[i], &next = corners[i + 1 == count ? 0 : i + 1];
        const double from = height(at), to = height(next);
        assert(kept_count + 2 <= std::ssize(kept));
        if (from <= thickness) kept[kept_count++] = at;
        if ((from < -thickness && to > thickness) || (from > thickness && to < -thickness)) {
          kept[kept_count++] = at + (from / (from - to)) * (next - at);
        }
      }
      corners = kept;
      count = kept_count;
    }
    if (count == 0) return;
    points_.insert(points_.end(), corners.begin(), corners.begin() + count);
    add(id, true);
  }

  void clear() {
    items_.clear();
    points_.clear();
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(items_.size()); }
  const Fragment& operator[](std::uint32_t i) const { return items_[i]; }
  std::span<const Vec3d> points(const Fragment& fragment) const {
    return {points_.data() + fragment.first, fragment.count};
  }

  /// Divides all into those below the plane and those above; what crosses it is cut in two.
  ///   F1  Nothing is lost: the parts of a fragment cover it but for a few roundings.
  ///   F2  What is kept below has heights of at most `thickness`, what is kept above of at least -thickness, but for
  ///       boxes that a plane crosses at an angle, which are kept whole on both sides.
  /// A corner within the thickness counts as lying on the plane, so that no slivers arise.
  void split(const Plane& plane, double thickness, bool keep_on_below, const Primitives& primitives,
             const Vec3d& center, Fragments& below, Fragments& above) const {
    below.clear();
    above.clear();
    std::vector<double>& heights = below.heights_;
    for (const Fragment& item : items_) {
      const std::span<const Vec3d> corners = points(item);
      heights.resize(corners.size());
      Sides sides;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        heights[i] = plane.side(corners[i]);
        sides.below |= heights[i] < -thickness;
        sides.above |= heights[i] > thickness;
      }
      if (!sides.below && !sides.above) (keep_on_below ? sides.below : sides.above) = true;
      if (sides.below != sides.above) {
        Fragments& side = sides.below ? below : above;
        side.points_.insert(side.points_.end(), corners.begin(), corners.end());
        side.add(item.id, item.is_polygon);
      } else if (item.is_polygon) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const std::size_t next = i + 1 == corners.size() ? 0 : i + 1;
          const double from = heights[i], to = heights[next];
          if (from <= thickness) below.points_.push_back(corners[i]);
          if (from >= -thickness) above.points_.push_back(corners[i]);
          if ((from < -thickness && to > thickness) || (from > thickness && to < -thickness)) {
            const Vec3d cut = corners[i] + (from / (from - to)) * (corners[next] - corners[i]);
            below.points_.push_back(cut);
            above.points_.push_back(cut);
          }
        }
        below.add(item.id, true);
        above.add(item.id, true);
      } else {
        below.add_box(item, corners, plane, thickness, 1, primitives, center);
        above.add_box(item, corners, plane, thickness, -1, primitives, center);
      }
    }
  }

 private:
  /// Makes a fragment of the points that are in none yet.
  void add(std::uint32_t id, bool is_polygon) {
    if (points_.size() > std::numeric_limits<std::uint32_t>::max()) {
      throw std::length_error("fragments: more than 2^32 - 1 corners of primitives in a cell");
    }
    const std::uint32_t first = items_.empty() ? 0 : items_.back().first + items_.back().count;
    items_.push_back({id, first, static_cast<std::uint32_t>(points_.size()) - first, is_polygon});
  }

  /// The part of a box on one side (1: below, -1: above) of a plane; an axis plane lets the primitive clip itself.
  void add_box(const Fragment& item, std::span<const Vec3d> corners, const Plane& plane, double thickness, int side,
               const Primitives& primitives, const Vec3d& center) {
    Vec3d lo = corners[0], hi = corners[0];
    for (const Vec3d& p : corners) {
      lo = glm::min(lo, p);
      hi = glm::max(hi, p);
    }
    bool is_axis_plane = false;
    for (int axis = 0; axis < 3; ++axis) {
      if (plane.normal[axis] != 1) continue;
      is_axis_plane = true;
      (side > 0 ? hi : lo)[axis] = plane.offset;
    }
    if (!is_axis_plane) {
      points_.insert(points_.end(), corners.begin(), corners.end());
      return add(item.id, false);
    }
    const Vec3d outer_lo = lo - thickness + center, outer_hi = hi + thickness + center;
    const Aabb part =
        primitives.clip(item.id, {{round_down(outer_lo.x), round_down(outer_lo.y), round_down(outer_lo.z)},
                                  {round_up(outer_hi.x), round_up(outer_hi.y), round_up(outer_hi.z)}});
    if (part.is_empty()) return;
    for (const Vec3f& p : hull_of(part).points) points_.push_back(glm::clamp(Vec3d(p) - center, lo, hi));
    add(item.id, false);
  }

  std::vector<Fragment> items_;
  std::vector<Vec3d> points_;
  std::vector<double> heights_;  ///< Scratch of split.
};

}  // namespace sightline
