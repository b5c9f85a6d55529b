#include "sightline/accel/reference_split.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <set>
#include <span>

#include "sightline/accel/bounding_volume_tree.h"
#include "sightline/accel/wide_tree.h"
#include "sightline/scene/procedural.h"
#include "tests/accel/law_variants.h"
#include "tests/accel/laws.h"

namespace sightline {
namespace laws {

constexpr auto split = [](auto& options) { options.splits = 300; };

using SplitTrees = ::testing::Types<Changed<WideTree, split>, Changed<BoxTree, split>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Split, Laws, SplitTrees);

}  // namespace laws

namespace {

/// Straws of all lengths and directions, most of them thin.
TriangleMesh straws(int count) {
  Random random(80);
  laws::MeshMaker maker;
  for (int i = 0; i < count; ++i) {
    const Vec3f p = laws::random_point(random, 0, 10);
    const Vec3f along = random.uniform(0.1f, 4) * laws::random_point(random, -1, 1);
    const float width = i % 3 == 0 ? 0.0f : 0.01f;
    maker.add(p, p + along, p + along + laws::random_point(random, -width, width));
  }
  return maker.make();
}

TEST(ReferenceSplit, KeepsTheBudget) {
  const TriangleMesh mesh = straws(2000);
  const PrimitivesOf primitives(mesh);
  std::size_t before = 0;
  for (const int percent : {0, 1, 25, 50, 100, 400, 1000}) {
    const auto references = references_of(primitives, percent);
    const std::size_t most = mesh.size() + mesh.size() * static_cast<std::size_t>(percent) / 100;
    EXPECT_LE(references.size(), most);
    if (percent >= 25) {
      EXPECT_GE(references.size() - mesh.size(), (most - mesh.size()) / 2);
    }
    EXPECT_GE(references.size(), before);
    before = references.size();
    std::set<std::uint32_t> ids;
    for (std::size_t i = 0; i < references.size(); ++i) {
      ids.insert(references[i].id);
      EXPECT_TRUE(i == 0 || references[i - 1].id <= references[i].id);
    }
    EXPECT_EQ(ids.size(), mesh.size());
  }
  EXPECT_EQ(references_of(primitives, 1000, 2100).size(), references_of(primitives, 5).size());
  EXPECT_EQ(references_of(primitives, 1000, 2000).size(), mesh.size());
}

TEST(ReferenceSplit, TreatsAlikeWhatIsAlike) {
  Random random(86);
  laws::MeshMaker maker;
  for (int i = 0; i < 500; ++i) {
    const Vec3f p = laws::random_point(random, 0, 10), q = p + Vec3f(1.3f, 1.3f, 0);
    maker.add(p, q, q + laws::random_point(random, -0.005f, 0.005f));
  }
  const TriangleMesh mesh = maker.make();
  EXPECT_EQ(references_of(PrimitivesOf(mesh), 75).size(), 500u);
  EXPECT_EQ(references_of(PrimitivesOf(mesh), 175).size(), 1000u);
  EXPECT_EQ(references_of(PrimitivesOf(mesh), 200).size(), 1500u);
}

TEST(ReferenceSplit, CoversEveryPoint) {
  Random random(81);
  const TriangleMesh near = straws(500);
  for (const TriangleMesh& mesh : {near, laws::transformed(near, 1e-20f, Vec3f(0)),
                                   laws::transformed(near, 10, Vec3f(1e6f, -2e6f, 3e5f)), laws::sticks(500, 82)}) {
    const auto references = references_of(PrimitivesOf(mesh), 500);
    ASSERT_GT(references.size(), 2 * mesh.size());
    std::size_t end = 0;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
      const std::size_t begin = end;
      while (end < references.size() && references[end].id == id) ++end;
      const Triangle triangle = mesh[id];
      const Vec3d a(triangle.a), b(triangle.b), c(triangle.c);
      for (int i = 0; i < 200; ++i) {
        double u = random.uniform(0, 1), v = random.uniform(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vec3d p = i == 0 ? a : i == 1 ? b : i == 2 ? c : a + u * (b - a) + v * (c - a);
        bool is_covered = false;
        for (std::size_t k = begin; k < end; ++k) {
          const Aabb& box = references[k].box;
          is_covered |=
              glm::all(glm::lessThanEqual(Vec3d(box.lo), p)) && glm::all(glm::lessThanEqual(p, Vec3d(box.hi)));
        }
        EXPECT_TRUE(is_covered) << "triangle " << id;
      }
    }
  }
}

TEST(ReferenceSplit, LeavesWholeWhatIsNoLine) {
  const TriangleMesh terrain = make_terrain(40);
  EXPECT_EQ(references_of(PrimitivesOf(terrain), 100).size(), terrain.size());
  const SphereSet balls = laws::spheres(200, 83);
  EXPECT_EQ(references_of(PrimitivesOf(balls), 1000).size(), balls.size());
  const BoxSet boxes = laws::lattice_boxes(200, 8, 84);
  EXPECT_EQ(references_of(PrimitivesOf(boxes), 1000).size(), boxes.size());
  const TriangleMesh none;
  EXPECT_EQ(references_of(PrimitivesOf(none), 1000).size(), 0u);
}

template <class Tree>
void expect_less_work_and_no_repeats() {
  const TriangleMesh mesh = straws(3000);
  const auto rays = laws::rays_about<float>(mesh.bounds(), 1000, 85);
  std::uint64_t candidates = std::numeric_limits<std::uint64_t>::max();
  for (const int percent : {0, 100, 400}) {
    typename Tree::Options options;
    options.splits = percent;
    const Tree tree = Tree::build(PrimitivesOf(mesh), options);
    const std::span<const std::uint32_t> order = tree.leaf_order();
    EXPECT_EQ(order.size() > mesh.size(), percent > 0);
    for_each_leaf(tree, [&](LeafRange leaf) {
      const auto ids = order.subspan(leaf.first, leaf.count);
      EXPECT_EQ(std::set<std::uint32_t>(ids.begin(), ids.end()).size(), leaf.count);
    });
    const IndexedLeaves leaves(mesh, order);
    TraversalStats stats;
    for (const Ray<float>& ray : rays) closest_hit(tree, leaves, ray, stats);
    EXPECT_LT(stats.candidates, 0.8 * static_cast<double>(candidates)) << Tree::name << ' ' << percent;
    candidates = stats.candidates;
  }
}

TEST(ReferenceSplit, SavesWorkOnSticks) {
  expect_less_work_and_no_repeats<WideTree>();
  expect_less_work_and_no_repeats<BoxTree>();
}

TEST(ReferenceSplit, BuildsTheSameWithAnyNumberOfThreads) {
  const TriangleMesh mesh = straws(20'000);
  const PrimitivesOf primitives(mesh);
  std::string expected;
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const std::string built = laws::dump(WideTree::build(primitives, {.splits = 100}));
    if (expected.empty()) expected = built;
    ASSERT_TRUE(built == expected) << threads << " threads";
  }
}

}  // namespace
}  // namespace sightline
