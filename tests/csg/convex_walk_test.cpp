// The walk along convex parts against the evaluation by lists, which finds the same first boundary, bit for bit.
#include <gtest/gtest.h>

#include <sstream>

#include "sightline/csg/evaluator.h"
#include "sightline/math/rounding.h"
#include "tests/csg/random_convex.h"

namespace sightline {
namespace {

std::string text(const std::optional<Boundary>& boundary) {
  std::ostringstream out;
  out.precision(17);
  if (!boundary) return "nothing";
  out << boundary->t << " of primitive " << boundary->primitive << " face " << boundary->face << " root "
      << boundary->root << (boundary->is_flipped ? " flipped" : "");
  return out.str();
}

struct Counts {
  std::size_t found = 0;          ///< Boundaries that a walk has found ...
  std::size_t by_lanes = 0;       ///< ... of which this many of solids with lanes.
  std::size_t any = 0, none = 0;  ///< Where a walk knows at once whether there is one.
};

/// A walk for any boundary says nothing, or what is so.
template <class T, Level level>
void compare_any(const Solid& solid, const SolidRay<level>& ray, T t_min, T t_max, const std::optional<Boundary>& first,
                 Counts& counts) {
  NoSolidProbe probe;
  const WalkOutcome any = walk_any(solid, ray, t_min, t_max, probe);
  if (any == WalkOutcome::unclear) return;
  ++(any == WalkOutcome::found ? counts.any : counts.none);
  EXPECT_EQ(any == WalkOutcome::found, first.has_value()) << text(first);
}

template <Level level>
void compare(std::uint64_t seed, Counts& counts) {
  Convex convex(seed);
  const SolidTree tree = convex.solid();
  SolidOptions by_lists;
  by_lists.walk_convex = false;
  const Solid walked(tree), listed(tree, by_lists);
  EXPECT_EQ(listed.convex_parts(), nullptr);
  const bool has_lanes = walked.convex_parts() && walked.convex_parts()->lanes;
  for (int i = 0; i < 40; ++i) {
    const Ray<double> ray = convex.ray();
    const SolidRay<level> ready(ray, walked.extent());
    NoSolidProbe probe;
    SolidStats stats;
    SolidEvaluator<level, SolidStats> walk(walked, ray, stats);
    SolidEvaluator<level> list(listed, ray, probe);
    // From the begin, and then from boundary to boundary, as far as they come.
    double t_min = i % 4 == 0 ? -std::numeric_limits<double>::infinity() : convex.coordinate(2);
    const double t_max = i % 3 == 0 ? t_min + 1 : std::numeric_limits<double>::infinity();
    for (int k = 0; k < 30; ++k) {
      const auto a = walk.first(t_min, t_max), b = list.first(t_min, t_max);
      EXPECT_EQ(text(a), text(b)) << "seed " << seed << " ray " << i << " behind " << t_min << " to " << t_max;
      compare_any<double>(walked, ready, t_min, t_max, b, counts);
      if (b) compare_any<double>(walked, ready, t_min, next_down(b->t), std::nullopt, counts);
      if (!a || !b || text(a) != text(b)) break;
      counts.found += stats.nodes == 0;  // without lists for this ray
      counts.by_lanes += stats.nodes == 0 && has_lanes;
      t_min = a->t;
    }
  }
}

template <Level level>
void compare_many() {
  Counts counts;
  for (std::uint64_t seed = 0; seed < 6000 && !testing::Test::HasFailure(); ++seed) compare<level>(seed, counts);
  EXPECT_GT(counts.found, 3200u);
  EXPECT_GT(counts.by_lanes, 1600u);
  EXPECT_GT(counts.any, 3200u);
  EXPECT_GT(counts.none, 3200u);
}

TEST(ConvexWalk, FindsWhatListsFind) {
  compare_many<Level::fast>();
  compare_many<Level::watertight>();
  compare_many<Level::precise>();
  compare_many<Level::exact>();
}

TEST(ConvexWalk, HasLanesWhereItCan) {
  const auto lanes = [](const SolidTree& tree) { return Solid(tree).convex_parts()->lanes; };
  const SolidTree box = solid::Box{}, ball = solid::Sphere{}, along_z = solid::Cylinder{};
  const SolidTree oblique = solid::Cylinder{{0, 0, 0}, {1, 1, 0}, 1};
  ASSERT_NE(lanes((box & ball) - along_z), nullptr);
  EXPECT_EQ(lanes((box & ball) - along_z)->count(), 2u) << "kept boxes need no lane";
  EXPECT_NE(lanes(along_z - box), nullptr);
  EXPECT_EQ(lanes(box - oblique), nullptr);
  EXPECT_EQ(lanes(SolidTree(Operation::intersect, {box, along_z})), nullptr) << "caps in planes of the box";
  std::vector<SolidTree> taken{box};
  for (int i = 0; i < 9; ++i) taken.push_back(ball);
  EXPECT_EQ(lanes({Operation::subtract, taken}), nullptr) << "too many, and found by an index";
}

TEST(ConvexWalk, IsOfConvexPartsOnly) {
  const SolidTree box = solid::Box{}, ball = solid::Sphere{}, half = solid::HalfSpace{};
  EXPECT_NE(Solid(box - ball).convex_parts(), nullptr);
  EXPECT_NE(Solid((box & ball) - (ball | box)).convex_parts(), nullptr);
  EXPECT_EQ(Solid(box | ball).convex_parts(), nullptr);
  EXPECT_EQ(Solid(~box).convex_parts(), nullptr);
  EXPECT_EQ(Solid(box - half).convex_parts(), nullptr);
  EXPECT_EQ(Solid(box - (ball - box)).convex_parts(), nullptr);
  SolidOptions options;
  options.stop_early = false;
  EXPECT_EQ(Solid(box - ball, options).convex_parts(), nullptr);
}

}  // namespace
}  // namespace sightline
