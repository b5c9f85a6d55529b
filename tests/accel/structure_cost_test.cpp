/// How good the structures are, as counters that are the same on every machine: what closest-hit rays examine on
/// average. A bound is some 1.3 times what was counted when it was set; a build that chooses worse exceeds it.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "sightline/accel/registry.h"
#include "sightline/query/primitives_of.h"
#include "sightline/query/queries.h"
#include "sightline/scene/procedural.h"
#include "tests/accel/law_scenes.h"

namespace sightline {
namespace {

using laws::MeshMaker;

struct Work {
  double candidates = 0, nodes = 0;  ///< Of a ray.
  double references = 0;             ///< Of a primitive.
};

template <class A>
Work work_of(const TriangleMesh& mesh, const std::vector<Ray<float>>& rays, const typename A::Options& options = {}) {
  const A accel = A::build(PrimitivesOf(mesh), options);
  const IndexedLeaves leaves(mesh, accel.leaf_order());
  TraversalStats stats;
  for (const Ray<float>& ray : rays) closest_hit(accel, leaves, ray, stats);
  const auto count = static_cast<double>(rays.size());
  return {static_cast<double>(stats.candidates) / count, static_cast<double>(stats.nodes) / count,
          static_cast<double>(accel.leaf_order().size()) / mesh.size()};
}

/// As a scanner sees a statue: one closed, bumpy surface of 20,000 small triangles.
TriangleMesh bumpy_sphere() {
  constexpr int rings = 72, sectors = 140;
  const double pi = std::acos(-1.0);
  const auto at = [&](int ring, int sector) {
    const double theta = pi * ring / rings, phi = 2 * pi * (sector % sectors) / sectors;
    const Vec3d out(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    const double bump = std::sin(7 * out.x + 1) * std::sin(6 * out.y + 2) * std::sin(9 * out.z);
    return Vec3f((1 + 0.2 * bump) * out);
  };
  MeshMaker maker;
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const Vec3f a = at(ring, sector), b = at(ring + 1, sector), c = at(ring + 1, sector + 1),
                  d = at(ring, sector + 1);
      maker.add(a, b, c);
      maker.add(a, c, d);
    }
  }
  return maker.make();
}

/// A few clusters of fine detail and large walls between them: most space is empty, and triangles differ in size.
TriangleMesh uneven() {
  Random random(70);
  MeshMaker maker;
  for (int cluster = 0; cluster < 12; ++cluster) {
    const Vec3f middle = laws::random_point(random, 1, 9);
    const float size = cluster % 3 == 0 ? 0.8f : 0.2f;
    for (int i = 0; i < 500; ++i) {
      const Vec3f p = middle + laws::random_point(random, -size, size);
      maker.add(p, p + laws::random_point(random, -0.1f, 0.1f) * size,
                p + laws::random_point(random, -0.1f, 0.1f) * size);
    }
  }
  for (int wall = 0; wall < 40; ++wall) {
    const Vec3f p = laws::random_point(random, 0, 10);
    maker.add(p, p + laws::random_point(random, -3, 3), p + laws::random_point(random, -3, 3));
  }
  return maker.make();
}

/// Long thin triangles side by side, askew to all axes: no box fits them, and planes between them do.
TriangleMesh turned_sticks() {
  Random random(71);
  MeshMaker maker;
  for (int i = 0; i < 1500; ++i) {
    const Vec3f p = laws::random_point(random, 0, 1), along = random.uniform(0.3f, 0.6f) * Vec3f(1, 0.8f, 0.6f);
    maker.add(p, p + along, p + along + laws::random_point(random, -0.004f, 0.004f));
  }
  return maker.make();
}

std::vector<Ray<float>> rays_into(const TriangleMesh& mesh) { return laws::rays_about<float>(mesh.bounds(), 4000, 72); }

/// Candidates and nodes of a ray, and references of a primitive, are no more than the limits.
template <class A>
void expect_work(const TriangleMesh& mesh, const Work& limit) {
  const Work work = work_of<A>(mesh, rays_into(mesh));
  EXPECT_LE(work.candidates, limit.candidates) << A::name;
  EXPECT_LE(work.nodes, limit.nodes) << A::name;
  EXPECT_LE(work.references, limit.references) << A::name;
}

TEST(StructureCost, ScannedSurface) {
  const TriangleMesh mesh = bumpy_sphere();
  ASSERT_GT(mesh.size(), 20'000u);
  expect_work<SphereTree>(mesh, {10.6, 15.3, 1});
  expect_work<BoxTree>(mesh, {6.8, 12, 1});
  expect_work<WideTree>(mesh, {6.4, 4.3, 1});
  expect_work<CylinderTree>(mesh, {5.8, 10.7, 1});
  expect_work<UniformGrid>(mesh, {19.7, 6.6, 5.1});
  expect_work<BspTree>(mesh, {14.2, 19.9, 2.9});
  expect_work<KdTree>(mesh, {20.9, 5.6, 2.7});
  expect_work<BoundingIntervalHierarchy>(mesh, {8.8, 13.6, 1});
}

TEST(StructureCost, UnevenScene) {
  const TriangleMesh mesh = uneven();
  expect_work<SphereTree>(mesh, {9.1, 7.1, 1});
  expect_work<BoxTree>(mesh, {7.2, 7.6, 1});
  expect_work<WideTree>(mesh, {6.7, 2.4, 1});
  expect_work<CylinderTree>(mesh, {6.3, 6.3, 1});
  expect_work<UniformGrid>(mesh, {7.5, 5.2, 2.1});
  expect_work<BspTree>(mesh, {17, 9.2, 1.6});
  expect_work<KdTree>(mesh, {16.7, 2.5, 1.5});
  expect_work<BoundingIntervalHierarchy>(mesh, {8.8, 8.2, 1});
}

/// What a bsp-tree needs with general planes as shares, at most, of what it needs with axis planes alone.
void expect_general_planes_to_pay(const TriangleMesh& mesh, double candidates, double nodes, double references) {
  const auto rays = rays_into(mesh);
  const Work general = work_of<BspTree>(mesh, rays), axis = work_of<BspTree>(mesh, rays, {.general_planes = false});
  EXPECT_LT(general.candidates, candidates * axis.candidates);
  EXPECT_LT(general.nodes, nodes * axis.nodes);
  EXPECT_LT(general.references, references * axis.references);
}

TEST(StructureCost, GeneralPlanesPartTurnedSticks) { expect_general_planes_to_pay(turned_sticks(), 0.9, 0.8, 0.25); }

TEST(StructureCost, GeneralPlanesPartLongParallelSticks) {
  expect_general_planes_to_pay(make_sticks(5000), 0.95, 0.8, 0.1);
}

TEST(StructureCost, CellsCrowdedWithSticksAreDivided) {
  const TriangleMesh mesh = make_sticks(5000);
  expect_work<KdTree>(mesh, {100, 12, 32});
  expect_work<UniformGrid>(mesh, {120, 8, 40});
}

TEST(StructureCost, QualityOfTheBspTreeIsMoreAndBetterPlanes) {
  const TriangleMesh mesh = turned_sticks();
  const auto rays = rays_into(mesh);
  const Work fast = work_of<BspTree>(mesh, rays, {.quality = Quality::fast});
  const Work balanced = work_of<BspTree>(mesh, rays, {.quality = Quality::balanced});
  const Work best = work_of<BspTree>(mesh, rays, {.quality = Quality::best});
  EXPECT_LT(balanced.candidates, 0.9 * fast.candidates);
  EXPECT_LT(best.candidates, 0.9 * balanced.candidates);
}

TEST(StructureCost, EmptySpaceIsCutOff) {
  for (const TriangleMesh& mesh : {bumpy_sphere(), uneven()}) {
    const auto rays = rays_into(mesh);
    KdTreeOptions options{.max_leaf_size = 4, .intersection_cost = 1.5f};
    const Work with = work_of<KdTree>(mesh, rays, options);
    options.empty_bonus = 0;
    const Work without = work_of<KdTree>(mesh, rays, options);
    EXPECT_LT(with.candidates, 0.9 * without.candidates);
  }
}

TEST(StructureCost, SlabsCutOffEmptySpace) {
  using Bih = BoundingIntervalHierarchy;
  for (const TriangleMesh& mesh : {bumpy_sphere(), uneven()}) {
    const auto rays = rays_into(mesh);
    const Work both = work_of<Bih>(mesh, rays), best = work_of<Bih>(mesh, rays, {.quality = Quality::best});
    const Work without = work_of<Bih>(mesh, rays, {.slabs = false});
    EXPECT_LT(both.candidates, 0.6 * without.candidates);
    EXPECT_LT(both.nodes, 0.8 * without.nodes);
    EXPECT_LT(best.nodes, 1.05 * both.nodes);
  }
}

/// The second options make a coarser structure: fewer nodes, more candidates.
template <class A>
void expect_coarser(const typename A::Options& fine, const typename A::Options& coarse) {
  const TriangleMesh mesh = laws::soup(4000, 0.03f, 73);
  const auto rays = rays_into(mesh);
  const Work first = work_of<A>(mesh, rays, fine), second = work_of<A>(mesh, rays, coarse);
  EXPECT_LT(second.nodes, 0.9 * first.nodes) << A::name;
  EXPECT_GT(second.candidates, 1.1 * first.candidates) << A::name;
}

TEST(StructureCost, OptionsHaveAnEffect) {
  expect_coarser<SphereTree>({.max_leaf_size = 1}, {.max_leaf_size = 64, .traversal_cost = 8});
  expect_coarser<BoxTree>({.max_leaf_size = 1}, {.max_leaf_size = 64, .traversal_cost = 8});
  expect_coarser<CylinderTree>({.max_leaf_size = 1}, {.max_leaf_size = 64, .traversal_cost = 8});
  expect_coarser<UniformGrid>({.density = 8}, {.density = 0.5f});
  expect_coarser<BspTree>({.max_leaf_size = 1}, {.max_leaf_size = 32});
  expect_coarser<BspTree>({.traversal_cost = 0.2f}, {.traversal_cost = 10});
  expect_coarser<BspTree>({.intersection_cost = 10}, {.intersection_cost = 0.1f});
  expect_coarser<BspTree>({}, {.max_depth = 8});
  expect_coarser<KdTree>({.max_leaf_size = 1}, {.max_leaf_size = 32});
  expect_coarser<KdTree>({.max_leaf_size = 4, .traversal_cost = 0.2f}, {.max_leaf_size = 4, .traversal_cost = 10});
  expect_coarser<KdTree>({.max_leaf_size = 4, .intersection_cost = 10},
                         {.max_leaf_size = 4, .intersection_cost = 0.1f});
  expect_coarser<KdTree>({.max_leaf_size = 4}, {.max_leaf_size = 4, .max_depth = 8});
  expect_coarser<BoundingIntervalHierarchy>({.max_leaf_size = 1}, {.max_leaf_size = 32});
  expect_coarser<BoundingIntervalHierarchy>({}, {.max_depth = 8});
}

/// Claims more primitives than links can number; none is ever looked at.
class TooMany : public Primitives {
 public:
  std::uint32_t size() const override { return (1u << 29) + 1; }
  Aabb bounds(std::uint32_t) const override { throw std::logic_error("looked at"); }
  Aabb clip(std::uint32_t, const Aabb&) const override { throw std::logic_error("looked at"); }
  Hull hull(std::uint32_t) const override { throw std::logic_error("looked at"); }
  CandidatePlanes planes(std::uint32_t) const override { throw std::logic_error("looked at"); }
};

TEST(StructureCost, RefusesWhatLinksCannotNumber) {
  EXPECT_THROW(BspTree::build(TooMany()), std::length_error);
  EXPECT_THROW(KdTree::build(TooMany()), std::length_error);
  EXPECT_THROW(BoundingIntervalHierarchy::build(TooMany()), std::length_error);
}

}  // namespace
}  // namespace sightline
