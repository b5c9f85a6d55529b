#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "sightline/csg/solid.h"
#include "sightline/math/random.h"

namespace sightline {

/// Convex parts less convex parts, and rays: on a coarse lattice, so that faces coincide and spans abut, and off it.
class Convex {
 public:
  /// With oblique cylinders there are no lanes; scales leave the lattice as it is.
  explicit Convex(std::uint64_t seed)
      : random_(seed),
        may_be_oblique_(seed % 2 == 0),
        scale_(std::ldexp(1.0, seed % 5 == 0   ? -20
                               : seed % 7 == 0 ? 24
                                               : 0)) {}

  SolidTree solid() {
    std::vector<SolidTree> kept, taken;
    for (std::uint32_t i = 0, n = 1 + random_.below(3); i < n; ++i) kept.push_back(shape());
    for (std::uint32_t i = 0, n = random_.below(may_be_oblique_ ? 12 : 7); i < n; ++i) taken.push_back(shape());
    SolidTree body = kept.size() == 1 ? kept[0] : SolidTree(Operation::intersect, kept);
    if (taken.empty()) return body;
    if (random_.below(2) == 0) return body - SolidTree(Operation::unite, taken);
    taken.insert(taken.begin(), body);
    return {Operation::subtract, taken};
  }

  Ray<double> ray() {
    Ray<double> ray;
    ray.origin = point(4);
    do {
      ray.direction = point(2) - (random_.below(2) == 0 ? ray.origin : Vec3d(0));
    } while (ray.direction == Vec3d(0));
    if (random_.below(2) == 0) ray.direction /= scale_;  // t is not scaled
    return ray;
  }

  double coordinate(int size) {
    const double x = (2 * random_.uniform_double() - 1) * size;
    return (is_lattice_ ? std::round(x) : x) * scale_;
  }
  Vec3d point(int size) {
    is_lattice_ = random_.below(3) != 0;
    const double x = coordinate(size), y = coordinate(size), z = coordinate(size);
    return {x, y, z};
  }

 private:
  SolidTree shape() {
    switch (random_.below(3)) {
      case 0:
        return solid::Sphere{point(2), radius()};
      case 1: {
        const Vec3d a = point(2), b = point(2);
        return solid::Box{glm::min(a, b), glm::max(a, b)};
      }
      default: {
        solid::Cylinder cylinder{point(2), point(2), radius()};
        if (!may_be_oblique_ || random_.below(2) == 0) {
          const int axis = static_cast<int>(random_.below(3));
          const double top = cylinder.top[axis];
          cylinder.top = cylinder.base;
          cylinder.top[axis] = top == cylinder.base[axis] ? top + scale_ : top;
        }
        if (cylinder.top == cylinder.base) cylinder.top.z += scale_;
        return cylinder;
      }
    }
  }

  double radius() { return scale_ * (1 + random_.below(2)); }

  Random random_;
  bool is_lattice_ = true, may_be_oblique_;
  double scale_;
};

}  // namespace sightline
