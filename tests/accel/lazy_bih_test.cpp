/// The lazy bounding interval hierarchy under threads: whatever rays reach first, whoever makes a node, hits and tree
/// are those of the eager build.

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <barrier>
#include <cmath>
#include <cstdlib>
#include <new>
#include <random>
#include <thread>
#include <vector>

#include "sightline/accel/bounding_interval_hierarchy.h"
#include "sightline/query/primitives_of.h"
#include "sightline/query/queries.h"
#include "sightline/shape/mesh.h"

namespace {

/// Allocations on this thread until one fails, once; below zero, none does.
thread_local int allocations_left = -1;

}  // namespace

// Not inlined, where GCC would take the pairs for mismatched.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (allocations_left >= 0 && allocations_left-- == 0) throw std::bad_alloc();
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace sightline {
namespace {

using Options = BoundingIntervalHierarchy::Options;
constexpr int thread_count = 4;

/// Builds on the calling thread alone. What is tested are the threads started here, and the thread sanitizer cannot see
/// how the TBB library, which is not compiled for it, orders the work of its own.
BoundingIntervalHierarchy build_alone(const Primitives& primitives, const Options& options = {}) {
  return tbb::task_arena(1).execute([&] { return BoundingIntervalHierarchy::build(primitives, options); });
}

TriangleMesh random_mesh(std::uint32_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(0, 1), offset(-0.03f, 0.03f);
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3f center(place(random), place(random), place(random));
    for (int corner = 0; corner < 3; ++corner) {
      positions.push_back(center + Vec3f(offset(random), offset(random), offset(random)));
    }
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return {positions, triangles};
}

std::vector<Ray<float>> random_rays(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(0, 1);
  std::vector<Ray<float>> rays(count);
  for (Ray<float>& ray : rays) {
    const Vec3f target(place(random), place(random), place(random));
    ray.origin = {4 * place(random) - 2, 4 * place(random) - 2, -1};
    ray.direction = target - ray.origin;
  }
  return rays;
}

std::vector<Hit<float>> hits_of(const BoundingIntervalHierarchy& tree, const TriangleMesh& mesh,
                                const std::vector<Ray<float>>& rays) {
  const IndexedLeaves leaves(mesh, tree.leaf_order());
  NoProbe probe;
  std::vector<Hit<float>> hits;
  for (const Ray<float>& ray : rays) hits.push_back(closest_hit(tree, leaves, ray, probe));
  return hits;
}

/// The tree without its node numbers, which name the same nodes in another order.
struct Shown {
  Aabb region;
  int depth;
  bool is_leaf;
  std::uint32_t first, count;
  friend bool operator==(const Shown&, const Shown&) = default;
};

std::vector<Shown> cells_of(const BoundingIntervalHierarchy& tree) {
  std::vector<Shown> cells;
  tree.for_each_cell([&](const Cell& cell) {
    cells.push_back({std::get<Aabb>(cell.region), cell.depth, cell.is_leaf, cell.range.first, cell.range.count});
  });
  return cells;
}

std::vector<std::uint32_t> order_of(const BoundingIntervalHierarchy& tree) {
  return {tree.leaf_order().begin(), tree.leaf_order().end()};
}

/// Reaches every node: the visitor takes nothing as a hit, and the margin of a ray from far away is as wide as the
/// scene.
void touch_all(const BoundingIntervalHierarchy& tree) {
  NoProbe probe;
  const Ray<float> wide{{0.5f, 0.5f, -1e8f}, {0, 0, 1}};
  std::size_t reached = 0;
  tree.traverse(
      wide,
      [&](LeafRange leaf) {
        reached += leaf.count;
        return wide.t_max;
      },
      probe);
  EXPECT_EQ(reached, tree.leaf_order().size());
}

/// Runs work(thread) on all threads, started together.
template <class Work>
void together(Work&& work) {
  std::barrier start(thread_count);
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < thread_count; ++thread) {
    threads.emplace_back([&, thread] {
      start.arrive_and_wait();
      work(thread);
    });
  }
}

TEST(LazyBih, ConcurrentRaysGiveTheEagerHitsAndTree) {
  const TriangleMesh mesh = random_mesh(6000);
  const PrimitivesOf primitives(mesh);
  for (const int max_leaf_size : {1, 4, 100}) {
    const auto eager = build_alone(primitives, {.max_leaf_size = max_leaf_size});
    const auto lazy = build_alone(primitives, {.max_leaf_size = max_leaf_size, .lazy = true});
    EXPECT_TRUE(eager.is_order_final());
    EXPECT_FALSE(lazy.is_order_final());

    // Two threads each send the same rays, so that they meet at the same nodes.
    std::vector<Hit<float>> hits[thread_count];
    together([&](int thread) { hits[thread] = hits_of(lazy, mesh, random_rays(1000, thread / 2)); });
    for (int thread = 0; thread < thread_count; ++thread) {
      EXPECT_EQ(hits[thread], hits_of(eager, mesh, random_rays(1000, thread / 2)));
    }

    together([&](int) { touch_all(lazy); });
    EXPECT_EQ(cells_of(lazy), cells_of(eager));
    EXPECT_EQ(order_of(lazy), order_of(eager));
  }
}

TEST(LazyBih, CellsMayBeShownWhileRaysMakeThem) {
  const TriangleMesh mesh = random_mesh(6000);
  const auto lazy = build_alone(PrimitivesOf(mesh), {.lazy = true});
  together([&](int thread) {
    if (thread > 0) {
      hits_of(lazy, mesh, random_rays(500, thread));
      return;
    }
    for (int round = 0; round < 20; ++round) {
      std::uint32_t next = 0;
      lazy.for_each_cell([&](const Cell& cell) {
        if (!cell.is_leaf) return;
        EXPECT_EQ(cell.range.first, next);
        next += cell.range.count;
      });
      EXPECT_EQ(next, mesh.size());
    }
  });
}

TEST(LazyBih, FirstRaysMakeFewNodes) {
  const TriangleMesh mesh = random_mesh(20000);
  const PrimitivesOf primitives(mesh);
  const auto eager = build_alone(primitives);
  const auto lazy = build_alone(primitives, {.lazy = true});
  EXPECT_EQ(cells_of(lazy).size(), 1u);
  const std::size_t bytes_before = lazy.memory_bytes();

  const auto rays = random_rays(5, 1);
  EXPECT_EQ(hits_of(lazy, mesh, rays), hits_of(eager, mesh, rays));
  const std::size_t nodes_after = cells_of(lazy).size(), all_nodes = cells_of(eager).size();
  EXPECT_GT(nodes_after, 1u);
  EXPECT_LT(nodes_after, all_nodes / 4);
  const std::size_t bytes_after = lazy.memory_bytes();
  EXPECT_GE(bytes_after, bytes_before + (nodes_after - 1) * BoundingIntervalHierarchy::node_bytes);

  // What is made stays as it is: the same rays make nothing.
  hits_of(lazy, mesh, rays);
  EXPECT_EQ(lazy.memory_bytes(), bytes_after);
}

TEST(LazyBih, ShowsEveryPrimitiveHoweverMuchIsMade) {
  const TriangleMesh mesh = random_mesh(3000);
  const auto lazy = build_alone(PrimitivesOf(mesh), {.lazy = true});
  for (const std::size_t ray_count : {0, 1, 2, 20}) {
    hits_of(lazy, mesh, random_rays(ray_count, 3));
    std::vector<int> seen(mesh.size());
    lazy.for_each_cell([&](const Cell& cell) {
      for (std::uint32_t i = 0; i < cell.range.count; ++i) {
        const std::uint32_t id = lazy.leaf_order()[cell.range.first + i];
        ++seen[id];
        EXPECT_TRUE(std::get<Aabb>(cell.region).contains(mesh.bounds(id)));
      }
    });
    EXPECT_EQ(seen, std::vector<int>(mesh.size(), 1));
  }
}

TEST(LazyBih, GoesOnAfterBeingMoved) {
  const TriangleMesh mesh = random_mesh(3000);
  const PrimitivesOf primitives(mesh);
  const auto rays = random_rays(200, 5);
  const auto eager = build_alone(primitives);
  auto lazy = build_alone(primitives, {.lazy = true});
  hits_of(lazy, mesh, {rays[0]});
  BoundingIntervalHierarchy moved = std::move(lazy);
  EXPECT_EQ(hits_of(moved, mesh, rays), hits_of(eager, mesh, rays));
  BoundingIntervalHierarchy assigned = build_alone(primitives, {.lazy = true});
  assigned = std::move(moved);
  touch_all(assigned);
  EXPECT_EQ(cells_of(assigned), cells_of(eager));
}

/// Whoever makes a node may run out of memory: that ray throws, the others go on, and nobody waits for a node that is
/// not being made. All threads are short of memory, since none can be made the first to reach the root.
TEST(LazyBih, OutlivesAFailedAllocation) {
  const TriangleMesh mesh = random_mesh(20000);
  const PrimitivesOf primitives(mesh);
  const auto eager = build_alone(primitives);
  int failures = 0;
  for (int round = 0; round < 8; ++round) {
    const auto lazy = build_alone(primitives, {.lazy = true});
    std::atomic<int> thrown = 0;
    together([&](int thread) {
      NoProbe probe;
      const IndexedLeaves leaves(mesh, lazy.leaf_order());
      const auto rays = random_rays(100, static_cast<unsigned>(thread / 2));
      std::vector<Hit<float>> expected = hits_of(eager, mesh, rays);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i == 0) allocations_left = round;
        try {
          EXPECT_EQ(closest_hit(lazy, leaves, rays[i], probe), expected[i]);
        } catch (const std::bad_alloc&) {
          ++thrown;
        }
      }
      allocations_left = -1;
    });
    failures += thrown;
    std::uint32_t next = 0;
    for (const Shown& cell : cells_of(lazy)) next += cell.count;
    EXPECT_EQ(next, mesh.size());
  }
  EXPECT_GT(failures, 0);
}

TEST(LazyBih, NoPrimitivesOrInseparableOnes) {
  const TriangleMesh none;
  const auto empty = build_alone(PrimitivesOf(none), {.lazy = true});
  EXPECT_TRUE(cells_of(empty).empty());
  touch_all(empty);

  const TriangleMesh same({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, std::vector<TriangleMesh::Corners>(1000, {0, 1, 2}));
  const auto lazy = build_alone(PrimitivesOf(same), {.lazy = true});
  together([&](int) { touch_all(lazy); });
  EXPECT_EQ(cells_of(lazy).size(), 1u);
}

}  // namespace
}  // namespace sightline
