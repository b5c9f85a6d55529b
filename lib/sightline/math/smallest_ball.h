#pragma once
/// The smallest ball, or circle, around many points, to within a thousandth of its radius.
///
/// Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991, with the move-to-front order, finds the smallest
/// ball of a few points. Of many, only those it needs are gathered: the farthest one from the ball so far is added
/// until none lies outside (Gaertner, "Fast and Robust Smallest Enclosing Balls", 1999).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "sightline/math/vec.h"

namespace sightline {

/// Only the center is a result: whoever stores a ball measures its radius from the center as stored. So no rounding
/// here can lose a point, and a ball through points in degenerate position, which may have a NaN, is just not chosen.
class SmallestBall {
 public:
  /// `at(i)` gives point i of `count`, at least one. `support` is the number of points that determine a ball: 4, or 3
  /// when all lie in a plane.
  template <class At>
  static Vec3d center(std::size_t count, const At& at, int support) {
    SmallestBall search(support);
    const Vec3d middle = search.gather(count, at);
    return search.settle(middle, [&](const Vec3d& from) {
      Farthest farthest{Vec3d(0), 0};
      for (std::size_t i = 0; i < count; ++i) {
        const double distance2 = squared_length(at(i) - from);
        if (distance2 <= farthest.distance2) continue;  // keeps a NaN
        farthest = {at(i), distance2};
      }
      return farthest;
    });
  }

  /// Of the smallest ball around balls, at least one; or of the smallest circle around circles in the plane z = 0,
  /// which have a support of 3.
  static Vec3d center_of_balls(std::span<const Vec3d> centers, std::span<const double> radii, int support) {
    SmallestBall search(support);
    const Vec3d middle = search.gather_balls(centers, radii);
    return search.settle(middle, [&](const Vec3d& from) {
      std::size_t which = 0;
      double longest = -1;
      for (std::size_t i = 0; i < centers.size(); ++i) {
        const double reach = std::sqrt(squared_length(centers[i] - from)) + radii[i];
        if (reach <= longest) continue;  // keeps a NaN
        which = i;
        longest = reach;
      }
      const Vec3d way = centers[which] - from;
      const double length = std::sqrt(squared_length(way));
      const Vec3d outward = length > 0 ? way / length : Vec3d(1, 0, 0);
      return Farthest{centers[which] + radii[which] * outward, longest * longest};
    });
  }

 private:
  static constexpr int capacity = 24;
  static constexpr double tightness = 1.002;    // of squared radii
  static constexpr double membership = 1.0005;  // likewise; keeps copies of points on the surface from being added

  struct Ball {
    Vec3d center{0};
    double radius2 = -1;  ///< Negative: holds nothing.

    bool holds(const Vec3d& p) const { return squared_length(p - center) <= radius2 * membership; }
  };

  struct Farthest {
    Vec3d point;
    double distance2;
  };

  explicit SmallestBall(int support) : support_(support) {}

  /// Adds the farthest point from the ball of those gathered, until none lies outside.
  template <class Find>
  Vec3d settle(Vec3d best, const Find& farthest_from) {
    double best_radius2 = std::numeric_limits<double>::infinity();
    while (true) {
      ball_ = enclose(size_, 0);
      const Farthest farthest = farthest_from(ball_.center);
      if (farthest.distance2 < best_radius2) {
        best = ball_.center;
        best_radius2 = farthest.distance2;
      }
      // The smallest ball of those gathered is no larger than that of all.
      if (!(farthest.distance2 > ball_.radius2 * tightness) || size_ == capacity) return best;
      add(farthest.point);
    }
  }

  static double squared_length(const Vec3d& v) { return glm::dot(v, v); }

  void add(const Vec3d& p) { points_[size_++] = p; }

  /// Few points all, of many the extreme ones along the axes; returns the middle of the extremes.
  template <class At>
  Vec3d gather(std::size_t count, const At& at) {
    std::array<Vec3d, 3> lowest, highest;
    lowest.fill(at(0));
    highest.fill(at(0));
    for (std::size_t i = 1; i < count; ++i) {
      const Vec3d p = at(i);
      for (int axis = 0; axis < 3; ++axis) {
        if (p[axis] < lowest[axis][axis]) lowest[axis] = p;
        if (p[axis] > highest[axis][axis]) highest[axis] = p;
      }
    }
    constexpr std::size_t few = capacity / 2;
    if (count <= few) {
      for (std::size_t i = 0; i < count; ++i) add(at(i));
    }
    Vec3d middle;
    for (int axis = 0; axis < 3; ++axis) {
      if (count > few) {
        add(lowest[axis]);
        add(highest[axis]);
      }
      middle[axis] = 0.5 * (lowest[axis][axis] + highest[axis][axis]);
    }
    return middle;
  }

  /// The extreme points along the axes, whose middle is returned.
  Vec3d gather_balls(std::span<const Vec3d> centers, std::span<const double> radii) {
    Vec3d middle(0);
    for (int axis = 0; axis < support_ - 1; ++axis) {
      Vec3d step(0);
      step[axis] = 1;
      Vec3d lowest = centers[0] - radii[0] * step, highest = centers[0] + radii[0] * step;
      for (std::size_t i = 1; i < centers.size(); ++i) {
        const Vec3d low = centers[i] - radii[i] * step, high = centers[i] + radii[i] * step;
        if (low[axis] < lowest[axis]) lowest = low;
        if (high[axis] > highest[axis]) highest = high;
      }
      add(lowest);
      add(highest);
      middle[axis] = 0.5 * (lowest[axis] + highest[axis]);
    }
    return middle;
  }

  /// The smallest ball of the first `count` points with the `fixed` boundary points on its surface.
  Ball enclose(int count, int fixed) {
    Ball ball = circumscribe(std::span(boundary_).first(fixed));
    if (fixed == support_) return ball;
    for (int i = 0; i < count; ++i) {
      if (ball.holds(points_[i])) continue;
      boundary_[fixed] = points_[i];
      ball = enclose(i, fixed + 1);
      std::rotate(points_.begin(), points_.begin() + i, points_.begin() + i + 1);
    }
    return ball;
  }

  /// The smallest ball with all of at most 4 points on its surface.
  static Ball circumscribe(std::span<const Vec3d> on) {
    if (on.empty()) return {};
    if (on.size() == 1) return {on[0], 0};
    const Vec3d a = on[1] - on[0];
    Vec3d to_center = 0.5 * a;
    if (on.size() == 3) {
      const Vec3d b = on[2] - on[0], normal = glm::cross(a, b);
      to_center = (squared_length(a) * glm::cross(b, normal) + squared_length(b) * glm::cross(normal, a)) /
                  (2 * squared_length(normal));
    } else if (on.size() == 4) {
      const Vec3d b = on[2] - on[0], c = on[3] - on[0];
      to_center = (squared_length(a) * glm::cross(b, c) + squared_length(b) * glm::cross(c, a) +
                   squared_length(c) * glm::cross(a, b)) /
                  (2 * glm::dot(a, glm::cross(b, c)));
    }
    return {on[0] + to_center, squared_length(to_center)};
  }

  std::array<Vec3d, capacity> points_;
  std::array<Vec3d, 4> boundary_;
  Ball ball_;
  int size_ = 0;
  int support_;
};

}  // namespace sightline
