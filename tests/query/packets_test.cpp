/// Rays in packets hit triangles where single rays do, bit for bit.

#include "sightline/query/packets.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "sightline/accel/bounding_interval_hierarchy.h"
#include "sightline/accel/kd_tree.h"
#include "sightline/query/primitives_of.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/camera.h"
#include "sightline/scene/scenes.h"

namespace sightline {
namespace {

struct Visits {
  std::uint64_t together = 0, alone = 0;
};

template <class T, class Structure, class Leaves>
Visits expect_hits_of_single_rays(const Structure& structure, const Leaves& leaves, std::span<const Ray<T>> rays) {
  std::vector<Hit<T>> hits(rays.size());
  std::vector<std::uint8_t> is_hit(rays.size(), 2);
  TraversalStats together, alone;
  packet_closest_hits(structure, leaves, rays, std::span(hits), together);
  packet_any_hits(structure, leaves, rays, std::span(is_hit), together);
  std::size_t wrong = 0, wrong_any = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    wrong += hits[i] != closest_hit(structure, leaves, rays[i], alone);
    wrong_any += is_hit[i] != any_hit(structure, leaves, rays[i], alone);
  }
  EXPECT_EQ(wrong, 0u) << "of " << rays.size();
  EXPECT_EQ(wrong_any, 0u) << "of " << rays.size();
  return {together.nodes, alone.nodes};
}

class Packets : public ::testing::Test {
 protected:
  static std::vector<Ray<float>> some_rows(const std::vector<Ray<float>>& picture) {
    std::vector<Ray<float>> rays;
    for (std::size_t i = 0; i < picture.size(); ++i) {
      if (i / 800 % 20 == 10) rays.push_back(picture[i]);
    }
    rays.resize(rays.size() - 5);
    return rays;
  }

  const std::shared_ptr<const TriangleMesh> mesh_ = load_scene("teapot", SIGHTLINE_SOURCE_DIR "/data");
  const BoundingIntervalHierarchy tree_ = BoundingIntervalHierarchy::build(PrimitivesOf(*mesh_));
  const TriangleBlocks blocks_{*mesh_, tree_};

  /// Some rows of a picture, and rays of all kinds; not a multiple of a packet's size.
  std::vector<Ray<float>> camera_ = some_rows(primary_rays(Camera::facing(mesh_->bounds(), 800, 600)));
  std::vector<Ray<float>> any_ = random_rays(mesh_->bounds(), 10'007, 1);
};

TEST_F(Packets, HitTrianglesWhereSingleRaysDo) {
  const PackedLeaves<Level::watertight> exact(*mesh_, blocks_);
  const PackedLeaves<Level::fast> fast(*mesh_, blocks_);
  const Visits visits = expect_hits_of_single_rays<float>(tree_, exact, camera_);
  EXPECT_LT(visits.together, visits.alone / 4) << "few went together";
  expect_hits_of_single_rays<float>(tree_, fast, camera_);
  expect_hits_of_single_rays<float>(tree_, exact, any_);
}

TEST_F(Packets, HitTrianglesWhereSingleRaysDoInDouble) {
  std::vector<Ray<double>> rays;
  for (const Ray<float>& ray : camera_) rays.push_back(to_double(ray));
  for (const Ray<float>& ray : any_) rays.push_back(to_double(ray));
  const IndexedLeaves leaves(*mesh_, tree_.leaf_order());
  expect_hits_of_single_rays<double>(tree_, leaves, rays);
}

TEST_F(Packets, OfRaysToALampStopWhereAllAreFound) {
  const IndexedLeaves leaves(*mesh_, tree_.leaf_order());
  NoProbe probe;
  std::vector<Ray<float>> rays;
  for (const Ray<float>& ray : camera_) {
    const Hit<float> hit = closest_hit(tree_, leaves, ray, probe);
    if (!hit.is_hit()) continue;
    const Vec3f from = ray.at(hit.t), lamp = mesh_->bounds().hi + Vec3f(1);
    rays.push_back({from, lamp - from, 0x1p-10f, 1});
  }
  ASSERT_GT(rays.size(), 2000u);
  expect_hits_of_single_rays<float>(tree_, leaves, rays);
}

TEST_F(Packets, AreSingleRaysToOtherStructuresAndLazyTreesGrow) {
  const auto kd_tree = KdTree::build(PrimitivesOf(*mesh_));
  static_assert(PacketAccelerator<BoundingIntervalHierarchy, float> && !PacketAccelerator<KdTree, float>);
  const Visits visits =
      expect_hits_of_single_rays<float>(kd_tree, IndexedLeaves(*mesh_, kd_tree.leaf_order()), camera_);
  EXPECT_EQ(visits.together, visits.alone);
  const auto lazy = BoundingIntervalHierarchy::build(PrimitivesOf(*mesh_), {.lazy = true});
  expect_hits_of_single_rays<float>(lazy, IndexedLeaves(*mesh_, lazy.leaf_order()), camera_);
  const TriangleMesh empty;
  const auto none = BoundingIntervalHierarchy::build(PrimitivesOf(empty));
  expect_hits_of_single_rays<float>(none, IndexedLeaves(empty, none.leaf_order()), camera_);
}

}  // namespace
}  // namespace sightline
