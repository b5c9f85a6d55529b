#pragma once
/// How the laws compare structures: with brute force, hit by hit, and with each other, cell by cell.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sightline/accel/brute_force.h"
#include "sightline/query/primitives_of.h"
#include "sightline/query/queries.h"
#include "tests/accel/law_scenes.h"

namespace sightline::laws {

template <class S>
Aabb bounds_of_all(const S& shapes) {
  Aabb bounds;
  for (std::uint32_t id = 0; id < shapes.size(); ++id) bounds.extend(shapes.bounds(id));
  return bounds;
}

template <class T>
std::string text(const Ray<T>& ray) {
  std::ostringstream out;
  out << std::hexfloat << "origin " << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << " direction "
      << ray.direction.x << ' ' << ray.direction.y << ' ' << ray.direction.z << " range " << ray.t_min << ' '
      << ray.t_max;
  return out.str();
}

/// Bit for bit: unlike ==, it tells zeros apart.
template <class T>
bool is_same(const Hit<T>& a, const Hit<T>& b) {
  return a == b && std::signbit(a.t) == std::signbit(b.t) && std::signbit(a.u) == std::signbit(b.u) &&
         std::signbit(a.v) == std::signbit(b.v);
}
template <class T>
bool is_same(const std::vector<Hit<T>>& a, const std::vector<Hit<T>>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return is_same(x, y); });
}

template <class T>
std::string text(const Hit<T>& hit) {
  std::ostringstream out;
  out << std::hexfloat << "id " << hit.prim_id << " t " << hit.t << " u " << hit.u << " v " << hit.v;
  return out.str();
}

/// One line a cell: enough to tell two structures apart.
template <class A>
std::string dump(const A& accel) {
  std::ostringstream out;
  out << std::hexfloat;
  struct Write {
    std::ostream& out;
    void operator()(const Aabb& b) const {
      out << b.lo.x << ' ' << b.lo.y << ' ' << b.lo.z << ' ' << b.hi.x << ' ' << b.hi.y << ' ' << b.hi.z;
    }
    void operator()(const Sphere& s) const {
      out << s.center.x << ' ' << s.center.y << ' ' << s.center.z << ' ' << s.radius;
    }
    void operator()(const Cylinder& c) const {
      out << c.center.x << ' ' << c.axis.x << ' ' << c.axis.y << ' ' << c.radius << ' ' << c.half_length;
    }
    void operator()(const Polyhedron& p) const {
      for (const Vec3d& v : p.vertices) out << v.x << ' ' << v.y << ' ' << v.z << ' ';
    }
  };
  accel.for_each_cell([&](const Cell& cell) {
    std::visit(Write{out}, cell.region);
    out << " d" << cell.depth << " l" << cell.is_leaf << " r" << cell.range.first << '+' << cell.range.count << '\n';
  });
  for (const std::uint32_t id : accel.leaf_order()) out << id << ' ';
  return out.str();
}

/// Queries of the triangles as they are packed give what brute force gives at the same level, bit for bit; at the level
/// `watertight` that is `expected`.
template <Level level, class A>
void expect_packed_hits(const TriangleMesh& mesh, const BruteForce& brute, const A& accel,
                        const std::vector<Ray<float>>& rays) {
  const TriangleBlocks all(mesh, brute), blocks(mesh, accel);
  const PackedLeaves<level> brute_leaves(mesh, all), leaves(mesh, blocks);
  const IndexedLeaves one_by_one(mesh, brute.leaf_order());
  NoProbe probe;
  int failures = 0;
  for (const Ray<float>& ray : rays) {
    const Hit<float> expected = level == Level::watertight ? closest_hit(brute, one_by_one, ray, probe)
                                                           : closest_hit(brute, brute_leaves, ray, probe);
    const Hit<float> found = closest_hit(accel, leaves, ray, probe);
    const bool is_right = is_same(found, expected) && any_hit(accel, leaves, ray, probe) == expected.is_hit();
    EXPECT_TRUE(is_right) << "packed, level " << static_cast<int>(level) << ' ' << text(ray) << "\n  found    "
                          << text(found) << "\n  expected " << text(expected);
    ASSERT_LT(failures += !is_right, 4) << "more of the same left out";
  }
}

/// Every query of every ray gives what brute force gives, bit for bit.
template <class A, class T, Shapes S>
void expect_brute_force_hits(const S& shapes, const std::vector<Ray<T>>& rays,
                             const typename A::Options& options = {}) {
  const PrimitivesOf primitives(shapes);
  const BruteForce brute = BruteForce::build(primitives);
  const A accel = A::build(primitives, options);
  const IndexedLeaves brute_leaves(shapes, brute.leaf_order());
  const IndexedLeaves leaves(shapes, accel.leaf_order());
  NoProbe probe;
  int failures = 0;
  for (const Ray<T>& ray : rays) {
    const auto expected = all_hits(brute, brute_leaves, ray, probe);
    const auto found = all_hits(accel, leaves, ray, probe);
    const Hit<T> closest = closest_hit(accel, leaves, ray, probe);
    const bool is_hit = any_hit(accel, leaves, ray, probe);
    const Hit<T> nearest = expected.empty() ? Hit<T>{} : expected.front();
    EXPECT_EQ(found.size(), expected.size()) << text(ray);
    EXPECT_TRUE(is_same(found, expected)) << text(ray);
    EXPECT_TRUE(is_same(closest, nearest))
        << text(ray) << "\n  found    " << text(closest) << "\n  expected " << text(nearest);
    EXPECT_EQ(is_hit, !expected.empty()) << text(ray);
    if (!is_same(found, expected) || !is_same(closest, nearest) || is_hit == expected.empty()) ++failures;
    ASSERT_LT(failures, 4) << "more of the same left out";
  }
  if constexpr (std::is_same_v<S, TriangleMesh> && std::is_same_v<T, float>) {
    if (!accel.is_order_final()) return;
    expect_packed_hits<Level::watertight>(shapes, brute, accel, rays);
    expect_packed_hits<Level::fast>(shapes, brute, accel, rays);
  }
}

template <class A, Shapes S>
void expect_brute_force_hits_about(const S& shapes, int count, std::uint64_t seed) {
  const Aabb bounds = bounds_of_all(shapes);
  expect_brute_force_hits<A>(shapes, rays_about<float>(bounds, count, seed));
  expect_brute_force_hits<A>(shapes, rays_about<double>(bounds, count, seed));
}

}  // namespace sightline::laws
