#pragma once
/// What a collection of shapes offers to building (bounds, clip, hull, planes) and to queries (a ray made ready,
/// crossings).

#include <concepts>
#include <cstdint>

#include "sightline/math/aabb.h"
#include "sightline/math/hull.h"
#include "sightline/math/ray.h"

namespace sightline {

/// Where the line of a ray crosses a shape. u and v as in Hit.
struct Crossing {
  double t, u, v;
};

namespace detail {
struct AnyReport {
  void operator()(const Crossing&) const;
};
}  // namespace detail

/// All tests run in double, whatever the query's precision; see margin M1 in accel/padded_ray.h for how accurate t must
/// be.
template <class S>
concept Shapes = requires(const S& shapes, std::uint32_t id, const Aabb& box, const Ray<double>& ray,
                          const typename S::PreparedRay& prepared, const typename S::Shape& shape) {
  { shapes.size() } -> std::same_as<std::uint32_t>;
  { shapes[id] } -> std::convertible_to<typename S::Shape>;
  { shapes.bounds(id) } -> std::same_as<Aabb>;
  { shapes.clip(id, box) } -> std::same_as<Aabb>;
  { shapes.hull(id) } -> std::same_as<Hull>;
  { shapes.planes(id) } -> std::same_as<CandidatePlanes>;
  { shapes.prepare(ray) } -> std::same_as<typename S::PreparedRay>;
  prepared.for_each_crossing(shape, detail::AnyReport{});  // in order along the line, behind the origin as well
};

}  // namespace sightline
