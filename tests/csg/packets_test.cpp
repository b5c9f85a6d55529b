/// Rays in packets hit solids where single rays do, bit for bit, at every level: of random trees, whose faces often
/// coincide, through a structure that takes packets and one that does not, and as brute force has it.

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <vector>

#include "sightline/accel/bounding_interval_hierarchy.h"
#include "sightline/accel/brute_force.h"
#include "sightline/csg/solid_set.h"
#include "sightline/query/packets.h"
#include "sightline/query/primitives_of.h"
#include "tests/csg/evaluate.h"
#include "tests/csg/random_solid.h"

namespace sightline {
namespace {

using Solids = std::vector<std::shared_ptr<const Solid>>;

/// Moved apart by multiples of the lattice, so that some touch or overlap.
Solids random_solids(const Dice& dice) {
  Solids solids;
  while (solids.size() < 12) {
    SolidTree tree = SolidTree(solid::Box{Vec3d(-2), Vec3d(2)}) & random_tree(dice, 1 + dice(3), any_primitive);
    if (dice(3) == 0) {
      const Vec3d a(dice(9) - 4, dice(9) - 4, dice(9) - 4);
      tree = (SolidTree(solid::Box{a, a + Vec3d(2)}) & solid::Sphere{a + Vec3d(1), 1.25}) -
             SolidTree(solid::Cylinder{a + Vec3d(-1, 1, 1), a + Vec3d(3, 1, 1), 0.5});
    }
    auto solid = std::make_shared<const Solid>(tree);
    if (solid->is_bounded() && !solid->root().is_complement && !solid->bounds().is_empty())
      solids.push_back(std::move(solid));
  }
  return solids;
}

/// Groups of sixteen that begin together or end together, some of them spread over several octants.
std::vector<Ray<double>> neighbouring_rays(const Dice& dice) {
  std::vector<Ray<double>> rays;
  const auto number = [&](double size) { return size * (dice(1001) - 500) / 500.0; };
  for (int group = 0; group < 12; ++group) {
    const bool meets_at_end = dice(2) == 0;
    const double spread = dice(4) == 0 ? 4 : 0.25;
    const Vec3d eye(number(9), number(9), number(9)), aim(number(3), number(3), number(3));
    for (int i = 0; i < 16; ++i) {
      const Vec3d other = aim + Vec3d(number(spread), number(spread), number(spread));
      Ray<double> ray = meets_at_end ? Ray<double>{other, eye - other} : Ray<double>{eye, other - eye};
      if (ray.direction == Vec3d(0)) ray.direction.z = 1;
      if (dice(3) == 0) ray.t_max = 1;
      if (dice(5) == 0) ray.t_min = 0.25 * dice(4);
      rays.push_back(ray);
    }
  }
  for (int i = dice(16); i > 0; --i) rays.push_back(lattice_ray(dice));
  return rays;
}

struct Counts {
  std::size_t hits = 0, nodes = 0, single_nodes = 0;
};

template <class T, class Leaves, class Structure>
void expect_hits_of_single_rays(const Structure& structure, const Leaves& leaves, const std::vector<Ray<T>>& rays,
                                const std::vector<Hit<T>>& expected, Counts& counts) {
  std::vector<Hit<T>> hits(rays.size());
  std::vector<std::uint8_t> is_hit(rays.size(), 2);
  TraversalStats together, alone;
  packet_closest_hits(structure, leaves, std::span<const Ray<T>>(rays), std::span(hits), together);
  packet_any_hits(structure, leaves, std::span<const Ray<T>>(rays), std::span(is_hit), together);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(hits[i], closest_hit(structure, leaves, rays[i], alone)) << i;
    ASSERT_EQ(hits[i], expected[i]) << i;
    ASSERT_EQ(is_hit[i], any_hit(structure, leaves, rays[i], alone)) << i;
    ASSERT_EQ(is_hit[i] == 1, hits[i].is_hit()) << i;
    counts.hits += hits[i].is_hit();
  }
  counts.nodes += together.nodes;
  counts.single_nodes += alone.nodes;
}

template <Level level, class T>
void expect_hits_of_single_rays(const Solids& solids, const std::vector<Ray<T>>& rays, Counts& counts) {
  const SolidSet<level> set(solids);
  NoSolidProbe none;
  NoProbe probe;
  const auto brute = BruteForce::build(PrimitivesOf(set));
  const SolidLeaves<level> all(set, brute.leaf_order(), none);
  std::vector<Hit<T>> expected;
  for (const Ray<T>& ray : rays) expected.push_back(closest_hit(brute, all, ray, probe));
  for (const int leaf_size : {1, 4}) {
    const auto structure = BoundingIntervalHierarchy::build(PrimitivesOf(set), {.max_leaf_size = leaf_size});
    const SolidLeaves<level> leaves(set, structure.leaf_order(), none);
    expect_hits_of_single_rays(structure, leaves, rays, expected, counts);
  }
  Counts of_brute;
  expect_hits_of_single_rays(brute, all, rays, expected, of_brute);
}

TEST(PacketsOfRays, HitSolidsWhereSingleRaysDo) {
  Random random(7);
  const Dice dice = dice_of(random);
  Counts counts;
  for (int round = 0; round < 60; ++round) {
    const Solids solids = random_solids(dice);
    const std::vector<Ray<double>> rays = neighbouring_rays(dice);
    std::vector<Ray<float>> narrow_rays;
    for (const Ray<double>& ray : rays) {
      narrow_rays.push_back(
          {Vec3f(ray.origin), Vec3f(ray.direction), static_cast<float>(ray.t_min), static_cast<float>(ray.t_max)});
    }
    // Floats alone: their errors are within the margin of float rays (M1).
    expect_hits_of_single_rays<Level::fast>(solids, narrow_rays, counts);
    expect_hits_of_single_rays<Level::watertight>(solids, narrow_rays, counts);
    expect_hits_of_single_rays<Level::watertight>(solids, rays, counts);
    expect_hits_of_single_rays<Level::precise>(solids, rays, counts);
    expect_hits_of_single_rays<Level::exact>(solids, rays, counts);
    ASSERT_FALSE(HasFatalFailure()) << "round " << round;
  }
  EXPECT_GT(counts.hits, 20'000u);
  EXPECT_LT(counts.nodes, counts.single_nodes / 2) << "few went together";
}

}  // namespace
}  // namespace sightline
