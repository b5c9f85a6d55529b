#include "sightline/accel/wide_tree_packet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sightline/accel/wide_tree.h"
#include "sightline/query/leaves.h"
#include "sightline/query/primitives_of.h"
#include "sightline/query/stream.h"
#include "sightline/scene/camera.h"
#include "tests/accel/law_scenes.h"

namespace sightline {
namespace {

/// Parallel rays through the bounds and past them, row by row.
std::vector<Ray<float>> beam(const Aabb& bounds, const Vec3f& direction, int side) {
  std::vector<Ray<float>> rays;
  const Vec3f extent = bounds.extent();
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const Vec3f share(1.2f * static_cast<float>(x) / static_cast<float>(side) - 0.1f,
                        1.2f * static_cast<float>(y) / static_cast<float>(side) - 0.1f, 0.5f);
      rays.push_back({bounds.lo + share * extent - 2 * glm::length(extent) * glm::normalize(direction), direction});
    }
  }
  return rays;
}

/// How the rays of packets fared before they went on alone.
struct Fates {
  int coherent = 0;
  int met = 0;
  int unmet = 0;
};

template <class T>
Fates fates_of(const WideTree& tree, std::span<const Ray<T>> rays) {
  Fates fates;
  tree.with_view([&]<class View>(const View& view) {
    if constexpr (Packing<View, T>) {
      using Packet = typename View::template Packet<T>;
      for (std::size_t first = 0; first < rays.size(); first += Packet::size) {
        const std::size_t count = std::min(Packet::size, rays.size() - first);
        const Packet packet(view, rays.subspan(first, count));
        if (!packet.is_coherent()) continue;
        ++fates.coherent;
        for (std::size_t ray = 0; ray < count; ++ray) ++(packet.is_met(ray) ? fates.met : fates.unmet);
        for (std::size_t ray = count; ray < Packet::size; ++ray) EXPECT_FALSE(packet.is_met(ray));
      }
    }
  });
  return fates;
}

template <Level level>
void expect_hits_of_single_rays(const TriangleMesh& mesh, const WideTree& tree, std::span<const Ray<float>> rays) {
  const TriangleBlocks blocks(mesh, tree);
  const PackedLeaves<level> leaves(mesh, blocks);
  std::vector<Hit<float>> hits(rays.size());
  std::vector<std::uint8_t> is_hit(rays.size());
  closest_hits(tree, leaves, rays, std::span(hits));
  any_hits(tree, leaves, rays, std::span(is_hit));
  NoProbe probe;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_TRUE(hits[i] == closest_hit(tree, leaves, rays[i], probe)) << i;
    EXPECT_EQ(is_hit[i] != 0, any_hit(tree, leaves, rays[i], probe)) << i;
  }
}

/// The rays, and those that end or begin at a hit, or a little before or behind it.
std::vector<Ray<float>> with_ranges(const TriangleMesh& mesh, const WideTree& tree, std::vector<Ray<float>> rays) {
  const IndexedLeaves leaves(mesh, tree.leaf_order());
  NoProbe probe;
  for (std::size_t i = 0; i < rays.size(); i += 3) {
    const Hit<float> hit = closest_hit(tree, leaves, rays[i], probe);
    if (!hit.is_hit()) continue;
    if (i % 2 == 0) {
      rays[i].t_max = i % 4 == 0 ? hit.t : std::nextafter(hit.t, 0.0f);
    } else {
      rays[i].t_min = hit.t;
    }
  }
  return rays;
}

TEST(WidePacket, GivesTheHitsOfSingleRays) {
  for (const TriangleMesh& mesh :
       {laws::soup(4000, 0.05f, 98), laws::walls(12), laws::flat(500, 99), laws::sticks(800, 100),
        laws::transformed(laws::soup(2000, 0.1f, 101), 10, {1e6f, -2e6f, 3e5f}), laws::copies(500)}) {
    const Aabb bounds = mesh.bounds();
    for (const bool compressed : {false, true}) {
      const WideTree tree = WideTree::build(PrimitivesOf(mesh), {.compressed = compressed});
      std::vector<Ray<float>> rays = primary_rays(Camera::facing(bounds, 61, 40));
      for (const Vec3f& direction :
           {Vec3f(0, 0, 1), Vec3f(-0.f, 0, 2), Vec3f(1e-12f, -1e-30f, 1), Vec3f(0.3f, -0.2f, 5)}) {
        for (const Ray<float>& ray : beam(bounds, direction, 20)) rays.push_back(ray);
      }
      if (wide_has_slabs<float>) {
        const Fates fates = fates_of<float>(tree, rays);
        EXPECT_GT(fates.coherent, 100);
        EXPECT_GT(fates.met, 100);
        EXPECT_GT(fates.unmet, 100);
      }
      expect_hits_of_single_rays<Level::watertight>(mesh, tree, rays);
      expect_hits_of_single_rays<Level::fast>(mesh, tree, rays);
      expect_hits_of_single_rays<Level::watertight>(mesh, tree, with_ranges(mesh, tree, rays));
    }
  }
}

TEST(WidePacket, TakesAnyNumberOfRays) {
  const TriangleMesh mesh = laws::soup(2000, 0.05f, 102);
  const WideTree tree = WideTree::build(PrimitivesOf(mesh));
  const std::vector<Ray<float>> rays = beam(mesh.bounds(), {0.3f, -0.2f, 5}, 8);
  for (const std::size_t count : {1, 2, 15, 16, 17, 37}) {
    expect_hits_of_single_rays<Level::watertight>(mesh, tree, std::span(rays).first(count));
  }
}

TEST(WidePacket, LeavesToSingleRaysWhatIsNotCoherent) {
  const TriangleMesh mesh = laws::soup(2000, 0.05f, 103);
  const WideTree tree = WideTree::build(PrimitivesOf(mesh)), none;
  const std::vector<Ray<float>> rays = beam(mesh.bounds(), {0.3f, -0.2f, 5}, 4);
  EXPECT_EQ(fates_of<float>(tree, rays).coherent, wide_has_slabs<float> ? 1 : 0);
  EXPECT_EQ(fates_of<float>(none, rays).coherent, 0);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < rays.size(); i += 5) {
    std::vector<Ray<float>> turned = rays, broken = rays, empty = rays;
    turned[i].direction.x *= -1;
    broken[i].direction.y = nan;
    empty[i].t_max = -1;
    for (const auto& odd : {turned, broken, empty}) {
      EXPECT_EQ(fates_of<float>(tree, odd).coherent, 0);
      expect_hits_of_single_rays<Level::watertight>(mesh, tree, odd);
    }
  }
}

}  // namespace
}  // namespace sightline
