#include "sightline/accel/wide_tree_compressed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "sightline/accel/wide_tree.h"
#include "sightline/query/leaves.h"
#include "sightline/query/stream.h"
#include "tests/accel/law_variants.h"
#include "tests/accel/laws.h"

namespace sightline {
namespace laws {

/// With references split as well, so that leaves are merged.
constexpr auto compress = [](WideTreeOptions& options) {
  options.compressed = true;
  options.splits = 100;
};

using CompressedWideTree = Changed<WideTree, compress>;
INSTANTIATE_TYPED_TEST_SUITE_P(Compressed, Laws, CompressedWideTree);

}  // namespace laws

namespace {

constexpr int width = WideNode::width;
using Vectors = hn::CappedTag<float, width>;

/// Numbers around each of several magnitudes, and a few that are the same, next to each other, or at an end.
float number(Random& random, float around, float spread) {
  const float x = around + spread * random.uniform(-1, 1);
  switch (random.below(8)) {
    case 0:
      return around;
    case 1:
      return std::nextafter(around, std::numeric_limits<float>::max());
    case 2:
      return std::nextafter(x, std::numeric_limits<float>::lowest());
    case 3:
      return std::trunc(x);
    case 4:
      return spread * std::ldexp(1.0f, -static_cast<int>(random.below(30)));
    default:
      return x;
  }
}

/// Boxes of `count` children; the others are none.
WideNode random_node(Random& random, int count, float around, float spread) {
  WideNode node;
  for (int child = 0; child < width; ++child) {
    if (child >= count) {
      node.set(child, Aabb(), WideLink::none);
      continue;
    }
    Aabb box;
    for (int corner = 0; corner < 2; ++corner) {
      Vec3f p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = number(random, around, spread);
      box.extend(p);
    }
    node.set(child, box, WideLink::to_node(static_cast<std::uint32_t>(child)));
  }
  for (std::uint32_t octant = 0; octant < 8; ++octant) node.orders[octant] = random.below(1u << 24);
  return node;
}

template <class See>
void for_each_random_node(std::uint64_t seed, See&& see) {
  Random random(seed);
  for (const float spread : {0.0f, 1e-45f, 1e-38f, 3e-36f, 1e-6f, 1.0f, 255.0f, 1e6f, 1e30f, 1.7e38f}) {
    for (const float around : {0.0f, 1e-40f, 1e-38f, -1.0f, 0.1f, 16777215.0f, -1e30f, 1.7e38f}) {
      for (int i = 0; i < 200; ++i) {
        const int count = 1 + static_cast<int>(random.below(width));
        see(random_node(random, count, i % 2 == 0 ? around : 0, spread), count);
      }
    }
  }
}

TEST(CompressedNodes, HoldTheBoxesThatTheyAreMadeOf) {
  for_each_random_node(90, [](const WideNode& node, int count) {
    const CompressedWideNode compressed = CompressedWideNode::of(node);
    Aabb all;
    for (int child = 0; child < count; ++child) all.extend(node.box(child));
    for (int child = 0; child < width; ++child) {
      const Aabb box = node.box(child), decoded = compressed.box(child);
      if (child >= count) {
        EXPECT_TRUE(decoded.is_empty());
        continue;
      }
      ASSERT_TRUE(decoded.contains(box));
      for (int axis = 0; axis < 3; ++axis) {
        const double length = double(all.hi[axis]) - double(all.lo[axis]);
        if (!(length < 0.99 * double(std::numeric_limits<float>::max()))) continue;  // steps add up to infinity
        const float farthest = std::max(std::fabs(all.lo[axis]), std::fabs(all.hi[axis]));
        const double step = 1.01 * length / 255 + double(std::numeric_limits<float>::min());
        const double spacing = double(std::numeric_limits<float>::epsilon()) * double(farthest);
        EXPECT_LE(double(box.lo[axis]) - double(decoded.lo[axis]), step + spacing);
        EXPECT_LE(double(decoded.hi[axis]) - double(box.hi[axis]), step + spacing);
      }
    }
  });
}

TEST(CompressedNodes, KeepLinksAndOrders) {
  for_each_random_node(91, [](const WideNode& node, int) {
    const CompressedWideNode compressed = CompressedWideNode::of(node);
    EXPECT_EQ(compressed.links, node.links);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      EXPECT_EQ(compressed.order(octant) & 0xffffff, node.order(octant));
    }
  });
}

/// A template, since vectors may be shorter than a node.
template <class T>
void expect_rows_of_boxes() {
  if constexpr (wide_has_slabs<T>) {
    const Vectors f;
    for_each_random_node(92, [&](const WideNode& node, int count) {
      const CompressedWideNode compressed = CompressedWideNode::of(node);
      for (int axis = 0; axis < 3; ++axis) {
        if (!(double(compressed.step[axis]) * 255 < double(std::numeric_limits<float>::max()))) continue;  // S3
        for (const bool is_high : {false, true}) {
          alignas(64) std::array<float, width> row;
          hn::Store(compressed.row(f, axis, CompressedWideNode::row_at(axis, is_high)), f, row.data());
          for (int child = 0; child < count; ++child) {
            const Aabb box = compressed.box(child);
            EXPECT_EQ(row[static_cast<std::size_t>(child)], (is_high ? box.hi : box.lo)[axis]);
          }
        }
      }
    });
  }
}

TEST(CompressedNodes, HaveRowsThatAreTheBoxesOfTheirChildren) { expect_rows_of_boxes<float>(); }

/// Seen from so far that the margin is wider than the nodes, as if boxes that are inside out were met.
template <class Opener>
void expect_only_children() {
  const Ray<float> ray{Vec3f(1e6f, 2e6f, 3e6f), Vec3f(-1, -2, -3)};
  Random random(95);
  for (int i = 0; i < 100; ++i) {
    const int count = 1 + static_cast<int>(random.below(width));
    WideNode node = random_node(random, count, 0, i % 2 == 0 ? 0.01f : 0.0f);
    for (std::uint32_t& order : node.orders) order = 0b111'110'101'100'011'010'001'000;
    const Opener opener(ray, node.box(0));
    ASSERT_TRUE(opener.serves());
    WideStack<float> stack;
    std::size_t waiting = 0;
    std::uint32_t link = WideLink::none;
    float enter = 0;
    ASSERT_TRUE(opener.template open<false>(CompressedWideNode::of(node), opener.t_max(), stack, waiting, link, enter));
    EXPECT_EQ(waiting, static_cast<std::size_t>(count - 1));
    EXPECT_NE(link, WideLink::none);
  }
}

TEST(CompressedNodes, HaveNoChildrenThatAreNone) {
  expect_only_children<WideOpenerOf<float, CompressedWideNode>>();
  expect_only_children<WideOpener<float, CompressedWideNode>>();
}

static_assert(Steppable<WideTree, float> && Steppable<WideTree, double>);

TEST(CompressedNodes, StreamTheHitsOfSingleRays) {
  const TriangleMesh mesh = laws::soup(2000, 0.05f, 96);
  const WideTree tree = WideTree::build(PrimitivesOf(mesh), {.compressed = true});
  const TriangleBlocks blocks(mesh, tree);
  const PackedLeaves<Level::watertight> leaves(mesh, blocks);
  const auto rays = laws::rays_about<float>(mesh.bounds(), 1000, 97);
  std::vector<Hit<float>> hits(rays.size());
  std::vector<std::uint8_t> is_hit(rays.size());
  closest_hits(tree, leaves, std::span<const Ray<float>>(rays), std::span(hits));
  any_hits(tree, leaves, std::span<const Ray<float>>(rays), std::span(is_hit));
  NoProbe probe;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit<float> expected = closest_hit(tree, leaves, rays[i], probe);
    EXPECT_TRUE(hits[i] == expected);
    EXPECT_EQ(is_hit[i] != 0, expected.is_hit());
  }
}

TEST(CompressedNodes, TakeHalfTheMemoryForHardlyMoreWork) {
  const TriangleMesh mesh = laws::soup(20'000, 0.02f, 93);
  const PrimitivesOf primitives(mesh);
  const WideTree full = WideTree::build(primitives), compressed = WideTree::build(primitives, {.compressed = true});
  const std::size_t order_bytes = full.leaf_order().size_bytes();
  EXPECT_EQ(2 * (compressed.memory_bytes() - order_bytes), full.memory_bytes() - order_bytes);
  const IndexedLeaves leaves(mesh, full.leaf_order());
  TraversalStats before, after;
  for (const Ray<float>& ray : laws::rays_about<float>(mesh.bounds(), 1000, 94)) {
    EXPECT_TRUE(closest_hit(full, leaves, ray, before) == closest_hit(compressed, leaves, ray, after));
  }
  EXPECT_GE(after.nodes, before.nodes);
  EXPECT_LT(double(after.nodes), 1.1 * double(before.nodes));
  EXPECT_LT(double(after.candidates), 1.1 * double(before.candidates));
}

}  // namespace
}  // namespace sightline
