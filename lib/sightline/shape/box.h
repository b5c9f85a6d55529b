#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "sightline/shape/shapes.h"

namespace sightline {

/// Axis-aligned solid boxes as primitives; flat ones and single points are legal.
///
/// Slabs by division, so that each plane's parameter is correctly rounded, in an order that keeps a slab whose plane
/// the ray lies in: 0 / 0 is no bound (Kay and Kajiya 1986; Williams et al. 2005).
class BoxSet {
 public:
  using Shape = Aabb;

  class PreparedRay {
   public:
    explicit PreparedRay(const Ray<double>& ray) : origin_(ray.origin), direction_(ray.direction) {}

    /// Where the line enters and where it leaves; equal ones where it only touches.
    template <class Report>
    void for_each_crossing(const Aabb& box, Report&& report) const {
      double enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
      for (int axis = 0; axis < 3; ++axis) {
        const bool is_negative = std::signbit(direction_[axis]);
        const double near = ((is_negative ? box.hi : box.lo)[axis] - origin_[axis]) / direction_[axis];
        const double far = ((is_negative ? box.lo : box.hi)[axis] - origin_[axis]) / direction_[axis];
        enter = near > enter ? near : enter;
        leave = far < leave ? far : leave;
      }
      if (!(enter <= leave)) return;
      report(Crossing{enter, 0, 0});
      report(Crossing{leave, 0, 0});
    }

   private:
    Vec3d origin_, direction_;
  };

  BoxSet() = default;
  explicit BoxSet(std::vector<Aabb> boxes) : boxes_(std::move(boxes)) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(boxes_.size()); }
  const Aabb& operator[](std::uint32_t id) const { return boxes_[id]; }

  Aabb bounds(std::uint32_t id) const { return boxes_[id]; }
  Aabb clip(std::uint32_t id, const Aabb& box) const {
    const Aabb clipped = intersection(boxes_[id], box);
    return clipped.is_empty() ? Aabb{} : clipped;
  }
  Hull hull(std::uint32_t id) const { return hull_of(boxes_[id]); }
  CandidatePlanes planes(std::uint32_t id) const { return faces_of(boxes_[id]); }
  PreparedRay prepare(const Ray<double>& ray) const { return PreparedRay(ray); }

 private:
  std::vector<Aabb> boxes_;
};

static_assert(Shapes<BoxSet>);

}  // namespace sightline
