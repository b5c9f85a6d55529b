#pragma once
/// Constructive solid geometry as a first program has it: spans are pairs of numbers, each operand's as rounding left
/// them.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "sightline/math/ray.h"
#include "tests/hard_cases/naive_sphere.h"

namespace sightline::hard {

struct NaiveSpan {
  double lo, hi;
};
using NaiveSpans = std::vector<NaiveSpan>;

inline std::vector<double> ends_of(const NaiveSpans& spans) {
  std::vector<double> ends;
  for (const NaiveSpan& span : spans) {
    for (const double t : {span.lo, span.hi}) {
      if (std::isfinite(t)) ends.push_back(t);
    }
  }
  return ends;
}

// ---- Operands, in T throughout

template <class T>
NaiveSpans naive_box(const Vec3d& lo, const Vec3d& hi, const Ray<double>& ray) {
  T from = -std::numeric_limits<T>::infinity(), to = -from;
  for (int axis = 0; axis < 3; ++axis) {
    const T inverse = 1 / static_cast<T>(ray.direction[axis]), origin = static_cast<T>(ray.origin[axis]);
    const T a = (static_cast<T>(lo[axis]) - origin) * inverse, b = (static_cast<T>(hi[axis]) - origin) * inverse;
    from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
  }
  return from < to ? NaiveSpans{{from, to}} : NaiveSpans{};
}

template <class T>
NaiveSpans naive_half(const Vec3d& normal, double offset, const Ray<double>& ray) {
  const Vec3<T> n(normal);
  const T slope = glm::dot(n, Vec3<T>(ray.direction));
  const T t = (static_cast<T>(offset) - glm::dot(n, Vec3<T>(ray.origin))) / slope;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  return slope > 0 ? NaiveSpans{{-infinity, t}} : NaiveSpans{{t, infinity}};
}

template <class T>
NaiveSpans naive_ball(const Vec3d& center, double radius, const Ray<double>& ray) {
  const Ray<T> narrow{Vec3<T>(ray.origin), Vec3<T>(ray.direction)};
  const std::vector<double> roots = naive_sphere_roots(Vec3<T>(center), static_cast<T>(radius), narrow);
  return roots.empty() ? NaiveSpans{} : NaiveSpans{{roots[0], roots[1]}};
}

// ---- Operations

/// Spans no farther apart than `near` become one.
inline NaiveSpans naive_union(NaiveSpans a, const NaiveSpans& b, double near = 0) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end(), [](const NaiveSpan& x, const NaiveSpan& y) { return x.lo < y.lo; });
  NaiveSpans merged;
  for (const NaiveSpan& span : a) {
    if (!merged.empty() && span.lo <= merged.back().hi + near) {
      merged.back().hi = std::max(merged.back().hi, span.hi);
    } else {
      merged.push_back(span);
    }
  }
  return merged;
}

/// What is left counts where it is longer than `shortest`.
inline NaiveSpans naive_difference(NaiveSpans a, const NaiveSpans& b, double shortest = 0) {
  for (const NaiveSpan& cut : b) {
    NaiveSpans left;
    for (const NaiveSpan& span : a) {
      if (cut.lo > span.hi || cut.hi < span.lo) {
        left.push_back(span);
        continue;
      }
      if (cut.lo - span.lo > shortest) left.push_back({span.lo, cut.lo});
      if (span.hi - cut.hi > shortest) left.push_back({cut.hi, span.hi});
    }
    a = std::move(left);
  }
  return a;
}

inline NaiveSpans naive_intersection(const NaiveSpans& a, const NaiveSpans& b) {
  NaiveSpans common;
  for (const NaiveSpan& x : a) {
    for (const NaiveSpan& y : b) {
      const NaiveSpan span{std::max(x.lo, y.lo), std::min(x.hi, y.hi)};
      if (span.lo < span.hi) common.push_back(span);
    }
  }
  return common;
}

}  // namespace sightline::hard
