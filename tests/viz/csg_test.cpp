#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "sightline/csg/evaluator.h"
#include "sightline/math/random.h"
#include "sightline/scene/solids.h"
#include "viz/csg_layout.h"
#include "viz/csg_table.h"
#include "viz/csg_trace.h"

namespace sightline::viz {
namespace {

Ray<double> own_ray(const SolidInfo& info) {
  return {{info.origin[0], info.origin[1], info.origin[2]}, {info.direction[0], info.direction[1], info.direction[2]}};
}

LadderSolid solid_of(std::string_view name) { return {load_solid(std::string(name)), "box-tree"}; }

/// Of intervals alone: whether t, or what lies just behind it, is in one of them.
bool is_within(const LadderRow& row, double t, bool is_behind) {
  bool is_in = row.begins_inside;
  for (const Boundary& boundary : row.boundaries) is_in ^= is_behind ? boundary.t <= t : boundary.t < t;
  return is_in;
}

/// A truth table apart from csg/boolean.h: rows of A, columns of B.
bool expected(Operation operation, bool a, bool b) {
  constexpr bool tables[4][2][2] = {{{false, true}, {true, true}},
                                    {{false, false}, {false, true}},
                                    {{false, false}, {true, false}},
                                    {{false, true}, {true, false}}};
  return tables[static_cast<int>(operation)][a][b];
}

/// Merges the intervals of the operands anew, and compares booleans, what is kept, and the intervals that are passed
/// up.
void check_operations(const Ladder& ladder) {
  for (std::size_t i = 0; i < ladder.rows.size(); ++i) {
    const LadderRow& row = ladder.rows[i];
    if (row.kind != SolidTree::Kind::operation) continue;
    const LadderRow *a = nullptr, *b = nullptr;
    for (const LadderRow& other : ladder.rows) {
      if (other.parent == static_cast<int>(i)) (other.role == 'A' ? a : b) = &other;
    }
    ASSERT_TRUE(a && b);
    std::set<double> places;
    for (const LadderRow* operand : {a, b}) {
      for (const Boundary& boundary : operand->boundaries) places.insert(boundary.t);
    }
    ASSERT_EQ(row.steps.size(), places.size());
    std::size_t at = 0;
    std::vector<double> kept;
    for (const double t : places) {
      const LadderStep& step = row.steps[at++];
      EXPECT_EQ(step.t, t);
      const Transition change{is_within(*a, t, false), is_within(*a, t, true), is_within(*b, t, false),
                              is_within(*b, t, true)};
      EXPECT_EQ(step.change, change);
      const bool is_kept = expected(row.operation, change.was_in_a, change.was_in_b) !=
                           expected(row.operation, change.is_in_a, change.is_in_b);
      EXPECT_EQ(step.is_kept, is_kept);
      if (is_kept) kept.push_back(t);
    }
    ASSERT_EQ(row.boundaries.size(), kept.size());
    std::size_t next = 0;
    for (const LadderStep& step : row.steps) {
      if (!step.is_kept) continue;
      const Boundary& boundary = row.boundaries[next];
      EXPECT_EQ(boundary.t, kept[next++]);
      EXPECT_EQ(boundary.primitive, step.boundary.primitive);
      EXPECT_EQ(boundary.face, step.boundary.face);
      EXPECT_EQ(boundary.is_flipped, step.boundary.is_flipped);
    }
  }
}

TEST(CsgLadder, BooleansAreThoseOfAnIndependentMerge) {
  Random random(7);
  std::size_t kept = 0, discarded = 0;
  for (const SolidInfo& info : solid_infos()) {
    const LadderSolid solid = solid_of(info.name);
    check_operations(solid.climb(own_ray(info), Level::watertight));
    for (int i = 0; i < 200; ++i) {
      const auto number = [&] { return 3 * random.uniform_double() - 1.5; };
      const Ray<double> ray{{number(), number(), number()}, {number(), number(), number()}};
      const Ladder ladder = solid.climb(ray, i % 2 == 0 ? Level::watertight : Level::exact);
      check_operations(ladder);
      for (const LadderRow& row : ladder.rows) {
        for (const LadderStep& step : row.steps) ++(step.is_kept ? kept : discarded);
      }
      if (HasFailure()) FAIL() << info.name;
    }
  }
  EXPECT_GT(kept, 1000u);
  EXPECT_GT(discarded, 1000u);
}

TEST(CsgLadder, FoldsToWhatIsTraced) {
  Random random(8);
  for (const SolidInfo& info : solid_infos()) {
    const LadderSolid solid = solid_of(info.name);
    for (int i = 0; i < 40; ++i) {
      const auto number = [&] { return 3 * random.uniform_double() - 1.5; };
      const Ray<double> ray{{number(), number(), number()}, {number(), number(), number()}};
      const Ladder ladder = solid.climb(ray, Level::watertight);
      NoSolidProbe probe;
      SolidEvaluator<Level::watertight> evaluator(solid.quick(), ray, probe);
      const SpanList list = evaluator.spans();
      const LadderRow& root = ladder.rows.front();
      ASSERT_EQ(root.begins_inside, list.begins_inside) << info.name;
      ASSERT_EQ(root.boundaries.size(), list.count) << info.name;
      for (std::size_t k = 0; k < list.count; ++k) EXPECT_EQ(root.boundaries[k].t, evaluator[list][k].t) << info.name;
      const auto first = std::find_if(root.boundaries.begin(), root.boundaries.end(), [](auto& b) { return b.t >= 0; });
      ASSERT_EQ(ladder.hit.has_value(), first != root.boundaries.end());
      if (ladder.hit) {
        EXPECT_EQ(ladder.hit->boundary.t, first->t);
      }
    }
  }
}

TEST(CsgLadder, ComplementsHaveRowsOfTheirOwn) {
  const Ladder ladder = LadderSolid(~~(~SolidTree(solid::Sphere()) & SolidTree(solid::Box())), "box-tree")
                            .climb({{-3, 0, 0}, {1, 0, 0}}, Level::exact);
  const auto boundaries = [&](std::size_t row) {
    std::vector<double> t;
    for (const Boundary& boundary : ladder.rows[row].boundaries) t.push_back(boundary.t);
    return t;
  };
  ASSERT_EQ(ladder.rows.size(), 6u);
  const std::vector<double> both{2, 4};
  for (const std::size_t row : {3u, 4u, 5u}) EXPECT_EQ(boundaries(row), both) << row;
  for (const std::size_t row : {0u, 1u, 2u}) EXPECT_TRUE(boundaries(row).empty()) << row;
  const std::vector<bool> begins{false, true, false, true, false, false};
  for (std::size_t row = 0; row < 6; ++row) EXPECT_EQ(ladder.rows[row].begins_inside, begins[row]) << row;
  EXPECT_TRUE(ladder.rows[3].boundaries[0].is_flipped);
  EXPECT_FALSE(ladder.rows[4].boundaries[0].is_flipped);
}

constexpr const char* lens_table = R"(solid      lens
ray        origin -2.25 0.25 0  direction 1 0 0
precision  exact

INTERVALS of t, node by node
0    intersection         [1.7817541634481457, 2.718245836551854]
1      A sphere red (0)   [0.7817541634481457, 2.718245836551854]
2      B sphere blue (1)  [1.7817541634481457, 3.718245836551854]

TRANSITIONS of node 0, intersection: A & B
t                       wasInA isInA wasInB isInB  result     boundary
0.7817541634481457      0      1     0      0      discarded  sphere red (0), surface
1.7817541634481457      1      1     0      1      kept       sphere blue (1), surface
2.718245836551854       1      0     1      1      kept       sphere red (0), surface
3.718245836551854       0      0     1      0      discarded  sphere blue (1), surface

HIT, the first boundary of node 0 with t >= 0
t          1.7817541634481457
point      -0.46824583655185426 0.25 0
normal     -0.9682458365518543 0.25 0
material   blue
boundary   sphere blue (1), surface
)";

TEST(CsgTable, Lens) {
  const LadderSolid lens = solid_of("lens");
  const Ladder ladder = lens.climb(own_ray(solid_info("lens")), Level::exact);
  EXPECT_EQ(ladder_table(ladder, lens, "lens"), lens_table);
  // By the theorem of Pythagoras: half the chord of the red sphere at height 1/4 is sqrt(15)/4.
  EXPECT_EQ(ladder.rows[1].boundaries[0].t, 1.75 - std::sqrt(15.0) / 4);
}

TEST(CsgTable, NumbersAreReadBackTheSame) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double number = std::ldexp(random.uniform_double() - 0.5, static_cast<int>(random.below(200)) - 100);
    const std::string text = exact_text(number);
    double back = 0;
    std::from_chars(text.data(), text.data() + text.size(), back);
    EXPECT_EQ(back, number);
  }
  EXPECT_EQ(exact_text(-INFINITY), "-inf");
  EXPECT_EQ(exact_text(-0.0), "0");
}

TEST(CsgTable, JsonSaysTheSame) {
  const LadderSolid hollow = solid_of("not-a-sphere");
  const auto json = ladder_json(hollow.climb(own_ray(solid_info("not-a-sphere")), Level::exact), hollow, "hollow");
  EXPECT_EQ(json["nodes"][0]["intervals"][0][0], "-inf");
  EXPECT_EQ(json["nodes"][0]["intervals"][1][1], "inf");
  EXPECT_EQ(json["nodes"][1]["intervals"][0][0], json["nodes"][0]["intervals"][0][1]);
  EXPECT_EQ(json["hit"]["flipped"], true);
  const LadderSolid lens = solid_of("lens");
  const auto steps = ladder_json(lens.climb(own_ray(solid_info("lens")), Level::exact), lens, "lens")["nodes"][0];
  EXPECT_EQ(steps["transitions"].size(), 4u);
  EXPECT_EQ(steps["transitions"][1]["isInB"], true);
  EXPECT_EQ(steps["transitions"][1]["kept"], true);
}

TEST(CsgLayout, EverythingHasItsPlace) {
  std::vector<std::string> specs{"menger:4", "swiss-cheese:256"};
  for (const SolidInfo& info : solid_infos()) specs.emplace_back(info.name);
  for (const std::string& spec : specs) {
    const LadderSolid solid = solid_of(spec);
    const Ladder ladder = solid.climb(own_ray(solid_info(spec)), Level::watertight);
    for (const auto& [width, height] : {std::pair{1600, 900}, {800, 450}, {1000, 1400}, {2400, 700}}) {
      const CsgLayout layout(width, height);
      const LadderLayout rows = lay_out(layout, ladder, solid);
      ASSERT_FALSE(rows.rows.empty());
      EXPECT_EQ(rows.rows.front().row, 0u);
      double y = CsgLayout::top + rows.section_height;
      for (const ShownRow& row : rows.rows) {
        EXPECT_GE(row.y, y - 1e-9);
        y = row.y + row.height;
      }
      EXPECT_LE(y, layout.height() - CsgLayout::bottom) << spec;
      EXPECT_GT(rows.section_height, 50);
      for (const LadderRow& row : ladder.rows) {
        for (const Boundary& boundary : row.boundaries) {
          EXPECT_GT(rows.x_of(layout, boundary.t), layout.bars_left());
          EXPECT_LT(rows.x_of(layout, boundary.t), layout.bars_right());
        }
      }
      const SolidPanel panel = layout.panel();
      EXPECT_LT((panel.x + panel.width) / layout.unit(), layout.tree_left());
    }
  }
}

TEST(CsgTrace, ShowsEverySolidThatIsThere) {
  for (const SolidInfo& info : solid_infos()) {
    const LadderSolid solid = solid_of(info.name);
    const Camera camera = camera_for(solid, 60, 60);
    const SolidView view = trace_solid(solid, {}, camera, Level::watertight);
    ASSERT_EQ(view.colors.bytes.size(), 60u * 60 * 3);
    const auto seen = std::count_if(view.depths.begin(), view.depths.end(), [](double t) { return std::isfinite(t); });
    if (info.name == "nothing") {
      EXPECT_EQ(seen, 0);
    } else {
      EXPECT_GT(seen, 60 * 60 / 16) << info.name;
      EXPECT_LT(seen, 60 * 60) << info.name;
    }
    // A pixel's ray finds what the picture shows there.
    const Ladder ladder = solid.climb(ray_through(camera, 30.25, 30.25), Level::watertight);
    const double t = view.depths[30 * 60 + 30];
    EXPECT_EQ(ladder.hit ? ladder.hit->boundary.t : INFINITY, t) << info.name;
  }
}

TEST(CsgTrace, ASectionIsFilledWhereTheRayIsInside) {
  const LadderSolid solid = solid_of("lune");
  const Ray<double> ray = own_ray(solid_info("lune"));
  const Ladder ladder = solid.climb(ray, Level::watertight);
  const ColorGrid section = trace_section(solid, {0, 1}, ray, {0, 4, {0, 1, 0}}, 400, 101, Level::watertight);
  const auto red_excess = [&](double t) {
    const std::size_t at = (50 * 400 + static_cast<std::size_t>(t * 100)) * 3;
    return section.bytes[at] - section.bytes[at + 2];
  };
  const auto& ends = ladder.rows.front().boundaries;
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_GT(red_excess(0.5 * (ends[0].t + ends[1].t)), 20);
  EXPECT_LT(red_excess(ends[0].t - 0.2), 5);
  EXPECT_LT(red_excess(ends[1].t + 0.2), 5);
}

TEST(CsgTrace, GhostsOfEndlessPartsAreCutOff) {
  // A ball, and as a ghost behind it a plane, which the solid does not show.
  const SolidTree ball = solid::Sphere{Vec3d(0), 1};
  const auto ghosts_of = [&](const SolidTree& endless) {
    const LadderSolid solid(ball & (ball | endless), "box-tree");
    const Camera camera = camera_for(solid, 120, 120);
    const SolidView with = trace_solid(solid, {2}, camera, Level::watertight),
                    without = trace_solid(solid, {}, camera, Level::watertight);
    EXPECT_EQ(with.depths, without.depths);
    std::size_t changed = 0, at_edge = 0;
    for (std::size_t i = 0; i < with.colors.bytes.size(); i += 3) {
      const std::size_t x = i / 3 % 120, y = i / 3 / 120;
      if (std::equal(&with.colors.bytes[i], &with.colors.bytes[i] + 3, &without.colors.bytes[i])) continue;
      ++changed;
      at_edge += x == 0 || y == 0 || x == 119 || y == 119;
    }
    EXPECT_EQ(at_edge, 0u);  // as it would be seen without being cut off
    return changed;
  };
  EXPECT_GT(ghosts_of(solid::HalfSpace{{0, 1, 0}, -1}), 1000u);
  EXPECT_GT(ghosts_of(~SolidTree(solid::HalfSpace{{0, 1, 0}, -1})), 1000u);
  EXPECT_GT(ghosts_of(solid::Quadric{{1, 0, 1, 0, 0, 0, 0, 0, 0, -1}}), 1000u);  // a cylinder without ends
  EXPECT_EQ(ghosts_of(solid::HalfSpace{{0, 1, 0}, -9}), 0u);                     // beyond the scene
}

TEST(CsgTrace, PartsOnTheRayAreShownFirst) {
  const SolidTree tree(Operation::unite, {solid::Sphere{{5, 0, 0}, 1}, solid::HalfSpace{{1, 0, 0}, 9},
                                          solid::Sphere{{0, 5, 0}, 1}, solid::HalfSpace{{0, 1, 0}, 9}});
  const LadderSolid solid(tree, "box-tree");
  const Ladder ladder = solid.climb({{0, 0, 0}, {1, 0, 0}}, Level::watertight);
  using Parts = std::vector<std::uint32_t>;
  EXPECT_EQ(primitives_to_show(solid, ladder, 1), (Parts{0}));
  EXPECT_EQ(primitives_to_show(solid, ladder, 2), (Parts{0, 1}));
  EXPECT_EQ(primitives_to_show(solid, ladder, 3), (Parts{0, 1, 2}));
  EXPECT_EQ(primitives_to_show(solid, ladder, 9), (Parts{0, 1, 2, 3}));
}

}  // namespace
}  // namespace sightline::viz
