/// The qualities of the hierarchies that divide primitives by the surface area heuristic.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <span>
#include <string>

#include "sightline/accel/bounding_volume_tree.h"
#include "sightline/accel/reference_sweep.h"
#include "sightline/accel/wide_tree.h"
#include "sightline/scene/procedural.h"
#include "tests/accel/law_variants.h"
#include "tests/accel/laws.h"

namespace sightline {
namespace laws {

constexpr auto fast = [](auto& options) { options.quality = Quality::fast; };
constexpr auto best = [](auto& options) { options.quality = Quality::best; };

using QualityTrees = ::testing::Types<Changed<WideTree, fast>, Changed<WideTree, best>, Changed<BoxTree, fast>,
                                      Changed<BoxTree, best>, Changed<SphereTree, best>, Changed<CylinderTree, fast>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Quality, Laws, QualityTrees);

}  // namespace laws

namespace {

float cost_of(std::span<const BoundsReference> below, std::span<const BoundsReference> above) {
  const auto area_times_count = [](std::span<const BoundsReference> items) {
    return static_cast<float>(half_area(bounds_of(items).box.box())) * static_cast<float>(items.size());
  };
  return area_times_count(below) + area_times_count(above);
}

TEST(ReferenceSweep, FindsTheCheapestOfAllCuts) {
  for (const int count : {2, 63, 64, 65, 128, 500}) {
    const TriangleMesh mesh = laws::soup(count, 0.2f, 300 + static_cast<std::uint64_t>(count));
    const PrimitivesOf primitives(mesh);
    const ObjectSplitCosts costs{1, 1, 1, 32};
    ReferenceSweep<HalfArea> sweep(references_of(primitives), costs);
    const auto part = sweep.whole();
    float least = std::numeric_limits<float>::max();
    for (const auto& order : part.orders) {
      for (std::size_t place = 1; place < order.size(); ++place) {
        least = std::min(least, cost_of(order.first(place), order.subspan(place)));
      }
    }
    const auto halves = sweep.cheapest(part);
    ASSERT_TRUE(halves);
    EXPECT_NEAR(cost_of(halves->below.references(), halves->above.references()), least, 1e-5f * least) << count;
    // P1, and sorted still.
    for (const auto& half : {halves->below, halves->above}) {
      for (int axis = 0; axis < 3; ++axis) {
        std::set<std::uint32_t> expected, ids;
        for (const BoundsReference& item : half.orders[0]) expected.insert(item.id);
        float last = -std::numeric_limits<float>::infinity();
        for (const BoundsReference& item : half.orders[axis]) {
          ids.insert(item.id);
          EXPECT_LE(last, ReferenceCenter::on(item, axis));
          last = ReferenceCenter::on(item, axis);
        }
        EXPECT_EQ(ids, expected);
        EXPECT_EQ(half.orders[axis].size(), half.count());
      }
      EXPECT_EQ(half.box(), bounds_of(half.references()).box.box());
    }
    EXPECT_EQ(halves->below.count() + halves->above.count(), static_cast<std::uint32_t>(count));
  }
}

template <class Tree>
TraversalStats work_of(const TriangleMesh& mesh, Quality quality, std::size_t* references = nullptr) {
  const Tree tree = Tree::build(PrimitivesOf(mesh), {.quality = quality});
  if (references) *references = tree.leaf_order().size();
  const IndexedLeaves leaves(mesh, tree.leaf_order());
  TraversalStats stats;
  for (const Ray<float>& ray : laws::rays_about<float>(mesh.bounds(), 2000, 90)) closest_hit(tree, leaves, ray, stats);
  return stats;
}

template <class Tree>
void expect_better_with_quality() {
  const TriangleMesh mesh = make_terrain(100);
  const auto fast = work_of<Tree>(mesh, Quality::fast), balanced = work_of<Tree>(mesh, Quality::balanced);
  std::size_t references = 0;
  const auto best = work_of<Tree>(mesh, Quality::best, &references);
  EXPECT_EQ(references, mesh.size());  // nothing to split
  EXPECT_LT(static_cast<double>(fast.nodes), 1.15 * static_cast<double>(balanced.nodes)) << Tree::name;
  EXPECT_LT(static_cast<double>(fast.candidates), 1.3 * static_cast<double>(balanced.candidates)) << Tree::name;
  EXPECT_LT(static_cast<double>(best.nodes), 1.02 * static_cast<double>(balanced.nodes)) << Tree::name;
  EXPECT_LT(static_cast<double>(best.candidates), 1.02 * static_cast<double>(balanced.candidates)) << Tree::name;
}

TEST(ObjectQuality, FastIsLittleWorseAndBestNot) {
  expect_better_with_quality<WideTree>();
  expect_better_with_quality<BoxTree>();
  expect_better_with_quality<SphereTree>();
  expect_better_with_quality<CylinderTree>();
}

TEST(ObjectQuality, BestSplitsLines) {
  const TriangleMesh mesh = make_sticks(5000);
  std::size_t references = 0;
  const auto best = work_of<WideTree>(mesh, Quality::best, &references);
  EXPECT_GT(references, mesh.size());
  EXPECT_LE(references, 3 * std::size_t{mesh.size()});
  EXPECT_LT(static_cast<double>(best.candidates),
            0.5 * static_cast<double>(work_of<WideTree>(mesh, Quality::balanced).candidates));
  const auto rays = laws::rays_about<float>(mesh.bounds(), 300, 92);
  laws::expect_brute_force_hits<WideTree>(mesh, rays, {.quality = Quality::best});
  laws::expect_brute_force_hits<BoxTree>(mesh, rays, {.quality = Quality::best});
  laws::expect_brute_force_hits<WideTree>(mesh, rays, {.quality = Quality::fast, .splits = 100});
}

template <class Tree>
void expect_same_with_any_number_of_threads(const TriangleMesh& mesh, Quality quality) {
  std::string expected;
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const std::string built = laws::dump(Tree::build(PrimitivesOf(mesh), {.quality = quality}));
    if (expected.empty()) expected = built;
    ASSERT_TRUE(built == expected) << Tree::name << ", " << threads << " threads";
  }
}

/// Enough triangles for everything that runs in parallel.
TEST(ObjectQuality, BuildsTheSameWithAnyNumberOfThreads) {
  const TriangleMesh mesh = laws::soup(70'000, 0.01f, 91);
  for (const Quality quality : {Quality::fast, Quality::best}) {
    expect_same_with_any_number_of_threads<WideTree>(mesh, quality);
    expect_same_with_any_number_of_threads<BoxTree>(mesh, quality);
  }
}

}  // namespace
}  // namespace sightline
