#pragma once
/// The laws that every structure keeps. Instantiate them with
///   INSTANTIATE_TYPED_TEST_SUITE_P(Name, Laws, ::testing::Types<Structure>);

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "tests/accel/law_checks.h"

namespace sightline::laws {

template <class A>
class Laws : public ::testing::Test {};
TYPED_TEST_SUITE_P(Laws);

TYPED_TEST_P(Laws, EqualsBruteForceOnSoup) {
  expect_brute_force_hits_about<TypeParam>(soup(1500, 0.05f, 1), 1500, 2);
  expect_brute_force_hits_about<TypeParam>(soup(300, 1.0f, 3), 500, 4);
}

TYPED_TEST_P(Laws, EqualsBruteForceOnTheLattice) {
  const TriangleMesh mesh = lattice(600, 6, 5);
  expect_brute_force_hits<TypeParam>(mesh, lattice_rays<float>(6, 6000, 6));
  expect_brute_force_hits<TypeParam>(mesh, lattice_rays<double>(6, 3000, 7));
  expect_brute_force_hits<TypeParam>(walls(8), lattice_rays<float>(8, 4000, 8));
  expect_brute_force_hits<TypeParam>(walls(8), lattice_rays<double>(8, 2000, 9));
}

TYPED_TEST_P(Laws, EqualsBruteForceAtEdgesAndCorners) {
  for (const TriangleMesh& mesh : {walls(10), lattice(400, 5, 10), soup(400, 0.2f, 11)}) {
    expect_brute_force_hits<TypeParam>(mesh, rays_at_edges<float>(mesh, 1500, 12));
    expect_brute_force_hits<TypeParam>(mesh, rays_at_edges<double>(mesh, 1500, 13));
  }
}

TYPED_TEST_P(Laws, EqualsBruteForceOnFlatThinAndUnevenScenes) {
  expect_brute_force_hits_about<TypeParam>(flat(300, 14), 600, 15);
  expect_brute_force_hits<TypeParam>(flat(300, 14), lattice_rays<float>(8, 1000, 16));
  expect_brute_force_hits_about<TypeParam>(sticks(500, 17), 800, 18);
  expect_brute_force_hits_about<TypeParam>(small_in_large(), 500, 19);
  const TriangleMesh uneven = small_in_large();
  const Aabb middle{Vec3f(499.5f), Vec3f(501.5f)};
  expect_brute_force_hits<TypeParam>(uneven, rays_about<float>(middle, 1000, 20));
  expect_brute_force_hits<TypeParam>(uneven, rays_about<double>(middle, 1000, 21));
}

TYPED_TEST_P(Laws, EqualsBruteForceFarAwayHugeAndTiny) {
  const TriangleMesh mesh = soup(300, 0.1f, 22);
  for (const float scale : {1e-30f, 1e-20f, 1e-5f, 1e15f}) {
    expect_brute_force_hits_about<TypeParam>(transformed(mesh, scale, Vec3f(0)), 400, 23);
  }
  const TriangleMesh far = transformed(mesh, 10, {1e6f, -2e6f, 3e5f});
  expect_brute_force_hits_about<TypeParam>(far, 600, 24);
  expect_brute_force_hits<TypeParam>(far, rays_at_edges<float>(far, 600, 25));
  expect_brute_force_hits<TypeParam>(far, rays_at_edges<double>(far, 600, 26));
}

TYPED_TEST_P(Laws, EqualsBruteForceOnSpheresAndBoxes) {
  expect_brute_force_hits_about<TypeParam>(spheres(500, 27), 1000, 28);
  const BoxSet boxes = lattice_boxes(200, 8, 29);
  expect_brute_force_hits_about<TypeParam>(boxes, 500, 30);
  expect_brute_force_hits<TypeParam>(boxes, lattice_rays<float>(8, 1500, 31));
}

/// Ranges that end, or start, exactly at a hit, or one step before it.
template <class T, Shapes S>
std::vector<Ray<T>> rays_ending_at_hits(const S& shapes, int count, std::uint64_t seed) {
  const PrimitivesOf primitives(shapes);
  const BruteForce brute = BruteForce::build(primitives);
  const IndexedLeaves leaves(shapes, brute.leaf_order());
  constexpr T infinity = std::numeric_limits<T>::infinity();
  NoProbe probe;
  std::vector<Ray<T>> rays;
  for (Ray<T> ray : rays_about<T>(bounds_of_all(shapes), count, seed)) {
    ray.t_min = -infinity;
    ray.t_max = infinity;
    for (const Hit<T>& hit : all_hits(brute, leaves, ray, probe)) {
      rays.push_back({ray.origin, ray.direction, -infinity, hit.t});
      rays.push_back({ray.origin, ray.direction, -infinity, std::nextafter(hit.t, -infinity)});
      rays.push_back({ray.origin, ray.direction, hit.t, infinity});
    }
  }
  return rays;
}

TYPED_TEST_P(Laws, KeepsTheRangeOfTheRay) {
  const TriangleMesh mesh = soup(400, 0.1f, 32);
  const auto rays = rays_ending_at_hits<float>(mesh, 1000, 33);
  ASSERT_GT(rays.size(), 300u);
  expect_brute_force_hits<TypeParam>(mesh, rays);
  expect_brute_force_hits<TypeParam>(mesh, rays_ending_at_hits<double>(mesh, 1000, 34));
  const SphereSet balls = spheres(200, 35);
  expect_brute_force_hits<TypeParam>(balls, rays_ending_at_hits<float>(balls, 150, 36));
  const BoxSet boxes = lattice_boxes(100, 8, 37);
  expect_brute_force_hits<TypeParam>(boxes, rays_ending_at_hits<float>(boxes, 150, 38));
}

/// Where planes of any orientation suit a scene best, and rays end on what lies in them.
TYPED_TEST_P(Laws, EqualsBruteForceOnTurnedWalls) {
  for (const TriangleMesh& mesh : {turned(walls(8)), turned(lattice(400, 5, 55))}) {
    expect_brute_force_hits<TypeParam>(mesh, rays_ending_at_hits<float>(mesh, 300, 56));
    expect_brute_force_hits<TypeParam>(mesh, rays_ending_at_hits<double>(mesh, 300, 57));
    expect_brute_force_hits<TypeParam>(mesh, rays_at_edges<float>(mesh, 400, 58));
    expect_brute_force_hits<TypeParam>(mesh, rays_at_edges<double>(mesh, 400, 59));
  }
}

/// Directions nearly as long as floats go, in a scene so small that parameters underflow.
TYPED_TEST_P(Laws, EqualsBruteForceWhereParametersUnderflow) {
  const TriangleMesh mesh = transformed(soup(400, 0.2f, 53), 1e-9f, Vec3f(0));
  auto rays = rays_about<float>(mesh.bounds(), 3000, 54);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const int exponent = 122 - std::ilogb(max_norm(rays[i].direction));
    for (int axis = 0; axis < 3; ++axis) rays[i].direction[axis] = std::ldexp(rays[i].direction[axis], exponent);
    rays[i].t_min = i % 2 == 0 ? 0 : -std::numeric_limits<float>::infinity();
  }
  expect_brute_force_hits<TypeParam>(mesh, rays);
}

TYPED_TEST_P(Laws, EqualsBruteForceForLongAndShortDirections) {
  const TriangleMesh mesh = soup(300, 0.1f, 50);
  for (const float scale : {1e-9f, 1e-6f, 1.f}) {
    const TriangleMesh scaled = transformed(mesh, scale, Vec3f(0));
    const auto rays = rays_about<float>(scaled.bounds(), 300, 51);
    for (const float factor : {0x1p-120f, 0x1p-60f, 0x1p+60f, 0x1p+120f}) {
      expect_brute_force_hits<TypeParam>(scaled, stretched(rays, factor));
    }
    const auto wide_rays = rays_about<double>(scaled.bounds(), 300, 52);
    for (const double factor : {0x1p-450, 0x1p+450}) {
      expect_brute_force_hits<TypeParam>(scaled, stretched(wide_rays, factor));
    }
  }
}

TYPED_TEST_P(Laws, HitsNothingWithBrokenRays) {
  const TriangleMesh mesh = soup(2000, 0.2f, 34);
  const TypeParam accel = TypeParam::build(PrimitivesOf(mesh), {});
  const auto check = [&]<class T>(const std::vector<Ray<T>>& rays) {
    for (const Ray<T>& ray : rays) {
      int leaves = 0;
      TraversalStats stats;
      accel.traverse(
          ray,
          [&](LeafRange) {
            ++leaves;
            return ray.t_max;
          },
          stats);
      EXPECT_EQ(leaves, 0) << text(ray);
      EXPECT_LE(stats.nodes, 1u) << text(ray);
    }
  };
  check(broken_rays<float>());
  check(broken_rays<double>());
}

TYPED_TEST_P(Laws, HoldsNothingOneAndManyEqual) {
  const TriangleMesh none;
  expect_brute_force_hits<TypeParam>(none, lattice_rays<float>(2, 50, 35));
  const TypeParam empty = TypeParam::build(PrimitivesOf(none), {});
  EXPECT_TRUE(empty.leaf_order().empty());
  empty.for_each_cell([](const Cell&) { ADD_FAILURE() << "a cell of nothing"; });

  expect_brute_force_hits<TypeParam>(copies(1), lattice_rays<float>(2, 500, 36));
  expect_brute_force_hits<TypeParam>(copies(1000), lattice_rays<float>(2, 50, 37));
  MeshMaker point;
  for (int i = 0; i < 50; ++i) point.add({1, 1, 1}, {1, 1, 1}, {1, 1, 1});
  expect_brute_force_hits<TypeParam>(point.make(), lattice_rays<float>(2, 200, 38));
}

TYPED_TEST_P(Laws, EndsOnAHundredThousandCopies) {
  const TriangleMesh mesh = copies(100'000);
  const TypeParam accel = TypeParam::build(PrimitivesOf(mesh), {});
  EXPECT_LE(accel.leaf_order().size(), 1'600'000u);
  EXPECT_LE(accel.memory_bytes(), 16'000'000u);
  const IndexedLeaves leaves(mesh, accel.leaf_order());
  NoProbe probe;
  const Ray<float> ray{{0.25f, 0.25f, -1}, {0, 0, 1}};
  const Hit<float> hit = closest_hit(accel, leaves, ray, probe);
  EXPECT_EQ(hit.prim_id, 0u);
  EXPECT_EQ(hit.t, 1.1875f);
}

struct Holds {
  const Vec3d& point;
  double slack;
  bool operator()(const Aabb& box) const { return box.contains(Vec3f(point)); }
  bool operator()(const Sphere& sphere) const { return glm::distance(Vec3d(sphere.center), point) <= sphere.radius; }
  bool operator()(const Cylinder& cylinder) const {
    const Vec3d axis = glm::normalize(Vec3d(cylinder.axis)), from_center = point - Vec3d(cylinder.center);
    const double along = glm::dot(axis, from_center);
    return std::fabs(along) <= cylinder.half_length && glm::length(from_center - along * axis) <= cylinder.radius;
  }
  bool operator()(const Polyhedron& cell) const {
    for (const auto& face : cell.faces) {
      const Vec3d a = cell.vertices[face[0]];
      Vec3d normal(0);  // Newell's, which small edges do not spoil
      for (std::size_t i = 0; i < face.size(); ++i) {
        normal += glm::cross(cell.vertices[face[i]] - a, cell.vertices[face[(i + 1) % face.size()]] - a);
      }
      const double length = glm::length(normal);
      if (length > slack * slack && glm::dot(normal, point - a) > slack * length) return false;
    }
    return true;
  }
};

/// Each corner of each primitive lies in a leaf's cell that holds the primitive, and the leaves share out the order.
TYPED_TEST_P(Laws, CoversEveryPrimitive) {
  for (const TriangleMesh& mesh : {soup(600, 0.1f, 40), lattice(300, 5, 41), flat(100, 42)}) {
    const TypeParam accel = TypeParam::build(PrimitivesOf(mesh), {});
    std::vector<Cell> cells;
    std::set<std::pair<std::uint32_t, std::uint32_t>> ranges;
    std::size_t held = 0;
    accel.for_each_cell([&](const Cell& cell) {
      if (!cell.is_leaf) {
        EXPECT_EQ(cell.range.count, 0u);
        return;
      }
      held += cell.range.count;
      EXPECT_TRUE(cell.range.count == 0 || ranges.insert({cell.range.first, cell.range.count}).second);
      cells.push_back(cell);
    });
    EXPECT_EQ(held, accel.leaf_order().size());
    std::uint32_t next = 0;
    for (const auto& [first, count] : ranges) {
      EXPECT_EQ(first, next);
      next = first + count;
    }
    // A general plane is rounded to float, so its cell is only as exact as float is beside the scene's size.
    const double slack = 0x1p-20 * glm::length(Vec3d(mesh.bounds().extent()));
    std::vector<std::set<int>> found(mesh.size());
    for (const Cell& cell : cells) {
      for (std::uint32_t i = cell.range.first; i < cell.range.first + cell.range.count; ++i) {
        const std::uint32_t id = accel.leaf_order()[i];
        const Triangle triangle = mesh[id];
        int corner = 0;
        for (const Vec3f& p : {triangle.a, triangle.b, triangle.c}) {
          const Vec3d point(p);
          if (std::visit(Holds{point, slack}, cell.region)) found[id].insert(corner);
          ++corner;
        }
      }
    }
    for (std::uint32_t id = 0; id < mesh.size(); ++id) EXPECT_EQ(found[id].size(), 3u) << "triangle " << id;
  }
}

TYPED_TEST_P(Laws, ReallyDivides) {
  if (TypeParam::name == BruteForce::name) return;
  for (const TriangleMesh& mesh : {soup(2000, 0.02f, 43), lattice(2000, 12, 44)}) {
    const TypeParam accel = TypeParam::build(PrimitivesOf(mesh), {});
    std::size_t leaves = 0, largest = 0;
    accel.for_each_cell([&](const Cell& cell) {
      leaves += cell.is_leaf && cell.range.count > 0;
      largest = std::max<std::size_t>(largest, cell.range.count);
    });
    EXPECT_GT(leaves, 100u);
    EXPECT_LT(largest, 100u);
    TraversalStats stats;
    const IndexedLeaves all(mesh, accel.leaf_order());
    const auto rays = rays_about<float>(mesh.bounds(), 200, 45);
    for (const Ray<float>& ray : rays) closest_hit(accel, all, ray, stats);
    EXPECT_LT(stats.candidates, rays.size() * 400);
  }
}

TYPED_TEST_P(Laws, BuildsTheSameWithAnyNumberOfThreads) {
  for (const TriangleMesh& mesh : {soup(20'000, 0.01f, 46), lattice(5000, 10, 47)}) {
    const PrimitivesOf primitives(mesh);
    std::string expected;
    for (const std::size_t threads : {1, 1, 2, 4}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      const std::string built = dump(TypeParam::build(primitives, {}));
      if (expected.empty()) expected = built;
      ASSERT_TRUE(built == expected) << threads << " threads";
    }
  }
}

TYPED_TEST_P(Laws, RecordsTheWalkThatItCounts) {
  const TriangleMesh mesh = soup(1000, 0.05f, 48);
  const TypeParam accel = TypeParam::build(PrimitivesOf(mesh), {});
  const IndexedLeaves leaves(mesh, accel.leaf_order());
  std::set<std::uint32_t> known;
  accel.for_each_cell([&](const Cell& cell) { known.insert(cell.node); });
  for (const Ray<float>& ray : rays_about<float>(mesh.bounds(), 200, 49)) {
    TraversalStats counted, recounted;
    WalkRecorder walk;
    const Hit<float> hit = closest_hit(accel, leaves, ray, counted);
    EXPECT_TRUE(closest_hit(accel, leaves, ray, walk) == hit);
    for (const auto& step : walk.steps) {
      if (step.event == WalkRecorder::Event::node) recounted.node(step.node, step.t);
      if (step.event == WalkRecorder::Event::leaf) recounted.leaf(step.node, step.range, step.t);
      if (step.event == WalkRecorder::Event::cull) recounted.cull(step.node, step.t);
      EXPECT_TRUE(step.event != WalkRecorder::Event::leaf || known.contains(step.node)) << step.node;
    }
    EXPECT_TRUE(recounted == counted);
  }
}

TYPED_TEST_P(Laws, RefusesOptionsOutOfRange) {
  using Options = typename TypeParam::Options;
  const TriangleMesh mesh = copies(3);
  for (const auto& field : Options::fields()) {
    const auto refuses = [&](auto value) {
      Options options;
      std::visit(
          [&]<class M>(M Options::*member) {
            if constexpr (!std::is_same_v<M, bool>) options.*member = static_cast<M>(value);
          },
          field.member);
      if (std::holds_alternative<bool Options::*>(field.member)) return;
      try {
        TypeParam::build(PrimitivesOf(mesh), options);
        ADD_FAILURE() << field.name << " = " << value << " was taken";
      } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(TypeParam::name), std::string::npos) << message;
        EXPECT_NE(message.find(field.name), std::string::npos) << message;
      }
    };
    refuses(field.lowest - 1);
    refuses(std::holds_alternative<float Options::*>(field.member) ? field.highest * 2 + 1 : field.highest + 1);
    if (std::holds_alternative<float Options::*>(field.member)) refuses(std::numeric_limits<double>::quiet_NaN());
  }
}

REGISTER_TYPED_TEST_SUITE_P(Laws, EqualsBruteForceOnSoup, EqualsBruteForceOnTheLattice,
                            EqualsBruteForceAtEdgesAndCorners, EqualsBruteForceOnFlatThinAndUnevenScenes,
                            EqualsBruteForceFarAwayHugeAndTiny, EqualsBruteForceForLongAndShortDirections,
                            EqualsBruteForceWhereParametersUnderflow, EqualsBruteForceOnSpheresAndBoxes,
                            EqualsBruteForceOnTurnedWalls, KeepsTheRangeOfTheRay, HitsNothingWithBrokenRays,
                            HoldsNothingOneAndManyEqual, EndsOnAHundredThousandCopies, CoversEveryPrimitive,
                            ReallyDivides, BuildsTheSameWithAnyNumberOfThreads, RecordsTheWalkThatItCounts,
                            RefusesOptionsOutOfRange);

/// Names the tests after the structures.
struct NameOf {
  template <class A>
  static std::string GetName(int) {
    std::string name(A::name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};

}  // namespace sightline::laws
