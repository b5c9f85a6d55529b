#pragma once
/// Lines of rays in any type of numbers, and in the frames that shapes stand in.

#include <array>
#include <cstddef>

#include "sightline/math/affine.h"
#include "sightline/math/ray.h"
#include "sightline/math/triple.h"

namespace sightline {

template <class N>
struct Line {
  Triple<N> origin, direction;
};

/// Where a shape stands: the map from the world to the shape's own coordinates. These doubles say where, exactly. A ray
/// keeps its t.
using Frame = Affine;

/// A ray as a shape in a frame sees it. Refers to both; without a frame the shape stands in the world.
class FramedRay {
 public:
  explicit FramedRay(const Ray<double>& ray, const Frame* frame = nullptr) : ray_(&ray), frame_(frame) {}

  const Ray<double>& ray() const { return *ray_; }
  const Frame* frame() const { return frame_; }

  /// The line in the world.
  template <class N>
  Line<N> in_world() const {
    return {triple<N>(ray_->origin), triple<N>(ray_->direction)};
  }

  /// The line in the frame, computed in N: exact where N is.
  template <class N>
  Line<N> in() const {
    const Line<N> world = in_world<N>();
    if (!frame_) return world;
    Line<N> local;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& row = frame_->rows[i];
      const Triple<N> axes{N(row[0]), N(row[1]), N(row[2])};
      local.direction[i] = dot(axes, world.direction);
      local.origin[i] = dot(axes, world.origin) + N(row[3]);
    }
    return local;
  }

 private:
  const Ray<double>* ray_;
  const Frame* frame_;
};

}  // namespace sightline
