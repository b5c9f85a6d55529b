#pragma once
/// Small fixed-capacity lists that shapes hand to builders.

#include <array>
#include <cassert>

#include "sightline/math/aabb.h"
#include "sightline/math/volumes.h"

namespace sightline {

template <class T, int Capacity>
class SmallList {
 public:
  void push_back(const T& item) {
    assert(size_ < Capacity);
    items_[size_++] = item;
  }
  int size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](int i) const { return items_[i]; }
  T& operator[](int i) { return items_[i]; }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + size_; }

 private:
  std::array<T, Capacity> items_{};
  int size_ = 0;
};

/// Points in whose convex hull a primitive lies. When `is_polygon`, they are the corners of a planar convex polygon in
/// order.
struct Hull {
  SmallList<Vec3f, 8> points;
  bool is_polygon = false;
};

/// At most a polygon's own plane and three edge planes, or the six faces of a box.
using CandidatePlanes = SmallList<Plane, 6>;

inline Hull hull_of(const Aabb& box) {
  Hull hull;
  for (int corner = 0; corner < 8; ++corner) {
    hull.points.push_back(
        {corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y, corner & 4 ? box.hi.z : box.lo.z});
  }
  return hull;
}

inline CandidatePlanes faces_of(const Aabb& box) {
  CandidatePlanes planes;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d normal(0);
    normal[axis] = 1;
    planes.push_back({normal, box.lo[axis]});
    planes.push_back({normal, box.hi[axis]});
  }
  return planes;
}

}  // namespace sightline
