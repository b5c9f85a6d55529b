#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "sightline/math/aabb.h"
#include "sightline/math/rounding.h"
#include "sightline/math/smallest_ball.h"
#include "sightline/math/volumes.h"

namespace sightline {

/// A small cylinder with flat caps around points: chooses an axis among the coordinate axes and the principal axes of
/// the points, and places the cylinder on it.
///   C1  A contained point p has |(p - center) . axis| <= half_length and lies within `radius` of the line of the axis,
///       whether the reader takes the stored axis for a unit vector or normalizes it.
class SmallestCylinder {
 public:
  /// `box` is that of the points, of which there is at least one.
  SmallestCylinder(const Aabb& box, std::span<const Vec3f> points)
      : origin_(0.5 * Vec3d(box.lo) + 0.5 * Vec3d(box.hi)),
        points_(points),
        step_((points.size() + sample_size - 1) / sample_size) {}

  Cylinder smallest() const {
    Vec3d best(0, 0, 1);
    double least = std::numeric_limits<double>::infinity();
    const std::array<Vec3d, 3> principal = principal_axes();
    for (int i = 0; i < 6; ++i) {
      const Vec3d axis = i < 3 ? unit(i) : principal[i - 3];
      const double area = area_along(axis);
      if (!(area < least)) continue;
      least = area;
      best = axis;
    }
    return place(Vec3f(best));
  }

 private:
  static constexpr std::size_t sample_size = 128;  ///< Points of large sets that are asked which axis is best.

  /// Coordinates across an axis and along it.
  struct Frame {
    Vec3d u, v, w;

    explicit Frame(const Vec3d& axis) : w(glm::normalize(axis)) {
      const Vec3d a = glm::abs(w);
      u = glm::normalize(glm::cross(w, unit(a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2)));
      v = glm::cross(w, u);
    }
    Vec3d across(const Vec3d& p) const { return {glm::dot(p, u), glm::dot(p, v), 0}; }
  };

  static Vec3d unit(int axis) {
    Vec3d v(0);
    v[axis] = 1;
    return v;
  }

  Vec3d at(std::size_t i) const { return Vec3d(points_[i]) - origin_; }

  /// Eigenvectors of the sample's covariance, by Jacobi's rotations (Golub and Van Loan, "Matrix Computations", 8.5).
  std::array<Vec3d, 3> principal_axes() const {
    Vec3d mean(0);
    double count = 0;
    for (std::size_t i = 0; i < points_.size(); i += step_, ++count) mean += at(i);
    mean /= count;
    double m[3][3] = {};
    for (std::size_t i = 0; i < points_.size(); i += step_) {
      const Vec3d p = at(i) - mean;
      for (int r = 0; r < 3; ++r) {
        for (int c = r; c < 3; ++c) m[r][c] += p[r] * p[c];
      }
    }
    std::array<Vec3d, 3> axes{unit(0), unit(1), unit(2)};
    constexpr int sweeps = 4;  // converge quadratically; any axes are valid
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (int p = 0; p < 2; ++p) {
        for (int q = p + 1; q < 3; ++q) rotate(m, axes, p, q);
      }
    }
    return axes;
  }

  /// Makes m[p][q] zero. Only the upper triangle of m is kept.
  static void rotate(double (&m)[3][3], std::array<Vec3d, 3>& axes, int p, int q) {
    if (m[p][q] == 0) return;
    const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
    const double t = std::copysign(1.0, theta) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
    const double c = 1 / std::sqrt(t * t + 1), s = t * c;
    m[p][p] -= t * m[p][q];
    m[q][q] += t * m[p][q];
    m[p][q] = 0;
    const int r = 3 - p - q;
    double& rp = m[std::min(r, p)][std::max(r, p)];
    double& rq = m[std::min(r, q)][std::max(r, q)];
    const double old_rp = rp;
    rp = c * old_rp - s * rq;
    rq = s * old_rp + c * rq;
    const Vec3d old_p = axes[p];
    axes[p] = c * old_p - s * axes[q];
    axes[q] = s * old_p + c * axes[q];
  }

  /// Of the sample, about the middle of its extents.
  double area_along(const Vec3d& axis) const {
    const Frame frame(axis);
    Vec3d lo(std::numeric_limits<double>::infinity()), hi(-lo);
    for (std::size_t i = 0; i < points_.size(); i += step_) {
      const Vec3d p = at(i), q(glm::dot(p, frame.u), glm::dot(p, frame.v), glm::dot(p, frame.w));
      lo = glm::min(lo, q);
      hi = glm::max(hi, q);
    }
    const Vec3d middle = 0.5 * (lo + hi);
    double radius2 = 0;
    for (std::size_t i = 0; i < points_.size(); i += step_) {
      const Vec3d p = at(i);
      const double du = glm::dot(p, frame.u) - middle.x, dv = glm::dot(p, frame.v) - middle.y;
      radius2 = std::max(radius2, du * du + dv * dv);
    }
    const double radius = std::sqrt(radius2);
    return radius * (radius + (hi.z - lo.z));
  }

  /// The smallest circle on the axis as stored, and lengths measured from the center as stored.
  Cylinder place(const Vec3f& stored_axis) const {
    const Vec3d axis(stored_axis);
    const Frame frame(axis);
    const Vec3d circle = SmallestBall::center(
        points_.size(), [&](std::size_t i) { return frame.across(at(i)); }, 3);
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double along = glm::dot(at(i), frame.w);
      lowest = std::min(lowest, along);
      highest = std::max(highest, along);
    }
    const Vec3f center(origin_ + circle.x * frame.u + circle.y * frame.v + 0.5 * (lowest + highest) * frame.w);

    double radius2 = 0, half_length = 0;
    const double inverse_length2 = 1 / glm::dot(axis, axis);
    for (const Vec3f& point : points_) {
      const Vec3d p = Vec3d(point) - Vec3d(center);
      const double along = glm::dot(p, axis);
      const Vec3d across = p - (along * inverse_length2) * axis;
      radius2 = std::max(radius2, glm::dot(across, across));
      half_length = std::max(half_length, std::fabs(along));
    }
    // C1: the axis' length is off by less than 2^-23, which also covers all roundings above.
    half_length *= 1 + 0x1p-20;
    const double radius = std::sqrt(radius2) * (1 + 0x1p-40) + 0x1p-20 * half_length;
    return {center, stored_axis, round_up(radius), round_up(half_length)};
  }

  Vec3d origin_;
  std::span<const Vec3f> points_;
  std::size_t step_;
};

}  // namespace sightline
