/// The recorded walk against the traversal's own statistics, on every structure.

#include "viz/walk/walk.h"

#include <gtest/gtest.h>

#include <memory>

#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"
#include "tests/viz/structure_names.h"

namespace sightline::viz {
namespace {

class EveryStructure : public testing::TestWithParam<std::string> {
 protected:
  static std::vector<Ray<float>> some_rays(const TriangleMesh& mesh) {
    std::vector<Ray<float>> rays = random_rays(mesh.bounds(), 200, 1);
    rays.push_back({mesh.bounds().hi + Vec3f(1), Vec3f(1)});  // meets nothing at all
    return rays;
  }
};

TEST_P(EveryStructure, StatisticsAreTheTraversals) {
  const auto mesh = load_scene("soup:400", "");
  const auto tracer = make_tracer(GetParam(), mesh);
  for (const Ray<float>& ray : some_rays(*mesh)) {
    const Walk walk = record_walk(*tracer, ray);
    TraversalStats stats;
    Hit<float> hit;
    static_cast<const Queries<float>&>(*tracer).closest_hits({&ray, 1}, {&hit, 1}, stats);
    EXPECT_EQ(walk.statistics(), stats);
    EXPECT_EQ(walk.hit, hit);
  }
}

TEST_P(EveryStructure, StepsLeadToTheHit) {
  const auto mesh = load_scene("soup:400", "");
  const auto tracer = make_tracer(GetParam(), mesh);
  for (const Ray<float>& ray : some_rays(*mesh)) {
    const Walk walk = record_walk(*tracer, ray);
    if (walk.steps.empty()) continue;
    double far = ray.t_max;
    for (const WalkStep& step : walk.steps) {
      EXPECT_LE(step.far, far);
      far = step.far;
      if (step.is_hit) {
        EXPECT_TRUE(step.is_crossed);
        EXPECT_EQ(static_cast<float>(step.t), step.far);
      }
    }
    const Hit<float> last = walk.hit_at(walk.steps.size() - 1);
    EXPECT_EQ(last.prim_id, walk.hit.prim_id);
    EXPECT_EQ(last.t, walk.hit.t);
  }
}

TEST_P(EveryStructure, HasTheCellOfEveryStepBelowTheRoot) {
  const auto mesh = load_scene("soup:400", "");
  const auto tracer = make_tracer(GetParam(), mesh);
  for (const Ray<float>& ray : some_rays(*mesh)) {
    const Walk walk = record_walk(*tracer, ray);
    for (const WalkStep& step : walk.steps) {
      const WalkCell& cell = walk.cells[walk.cell_of(step.node)];
      EXPECT_EQ(cell.cell.node, step.node);
      if (step.kind == WalkStep::Kind::leaf || step.kind == WalkStep::Kind::candidate) {
        EXPECT_TRUE(cell.cell.is_leaf);
        EXPECT_GT(cell.cell.range.count, 0u);
      }
    }
    for (std::size_t i = 0; i < walk.cells.size(); ++i) {
      const WalkCell& cell = walk.cells[i];
      ASSERT_EQ(cell.parent.has_value(), cell.cell.depth > 0);
      if (!cell.parent) continue;
      EXPECT_LT(*cell.parent, i);
      EXPECT_EQ(walk.cells[*cell.parent].cell.depth + 1, cell.cell.depth);
    }
  }
}

TEST(WalkOfAGrid, HasThePlacesOfEmptyCells) {
  const auto tracer = make_tracer("grid", load_scene("teapot", SIGHTLINE_SOURCE_DIR "/data"));
  const Aabb& bounds = tracer->mesh().bounds();
  const Walk walk = record_walk(*tracer, {bounds.hi, bounds.lo - bounds.hi});  // from corner to corner
  std::size_t empty = 0;
  for (const WalkStep& step : walk.steps) {
    const Cell& cell = walk.cells[walk.cell_of(step.node)].cell;
    EXPECT_EQ(cell.node, step.node);
    if (step.kind != WalkStep::Kind::visit || cell.depth == 0) continue;
    ++empty;
    // Where the ray enters it, as far as float tells.
    const Vec3d at = Vec3d(walk.ray.at(static_cast<float>(step.t))), slack = 1e-3 * Vec3d(bounds.extent());
    const Aabb& box = std::get<Aabb>(cell.region);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(at[axis], double(box.lo[axis]) - slack[axis]);
      EXPECT_LE(at[axis], double(box.hi[axis]) + slack[axis]);
    }
  }
  EXPECT_GT(empty, 0u);
  EXPECT_THROW(walk.cell_of(0xffffffff), std::out_of_range);
}

TEST_P(EveryStructure, WhatIsPutAsideIsTakenUpOrDropped) {
  const auto mesh = load_scene("soup:400", "");
  const auto tracer = make_tracer(GetParam(), mesh);
  std::size_t most = 0;
  for (const Ray<float>& ray : some_rays(*mesh)) {
    const Walk walk = record_walk(*tracer, ray);
    for (std::size_t step = 0; step < walk.steps.size(); ++step) {
      const std::vector<std::size_t> pending = walk.pending(step);
      most = std::max(most, pending.size());
      std::size_t before = step;
      for (const std::size_t cell : pending) {
        ASSERT_TRUE(walk.cells[cell].opened);
        EXPECT_GT(*walk.cells[cell].opened, before);
        before = *walk.cells[cell].opened;
      }
      EXPECT_TRUE(pending.empty() || step + 1 < walk.steps.size());
    }
  }
  const bool puts_aside = GetParam() != "grid" && GetParam() != "brute-force";
  EXPECT_EQ(most > 0, puts_aside);
}

TEST_P(EveryStructure, KnowsTheCellOfEveryStepWhereSomeAreEmpty) {
  const auto mesh = load_scene("teapot:4", "");
  const auto tracer = make_tracer(GetParam(), mesh);
  for (const Ray<float>& ray : some_rays(*mesh)) {
    const Walk walk = record_walk(*tracer, ray);
    for (const WalkStep& step : walk.steps) {
      ASSERT_LT(walk.cell_of(step.node), walk.cells.size());
      EXPECT_TRUE(step.kind == WalkStep::Kind::visit || walk.cells[walk.cell_of(step.node)].cell.node == step.node);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryStructure, testing::ValuesIn(structure_names()), test_name_of);

}  // namespace
}  // namespace sightline::viz
