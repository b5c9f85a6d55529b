/// What a walk's picture shows, without anything that draws: states, hierarchy, areas, timeline.

#include "viz/walk/walk_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"
#include "tests/viz/structure_names.h"
#include "viz/walk/coarse_mesh.h"
#include "viz/walk/split_plane.h"
#include "viz/walk/walk_model.h"

namespace sightline::viz {
namespace {

using Kind = WalkStep::Kind;

class ShownWalk : public testing::TestWithParam<std::string> {
 protected:
  ShownWalk() : mesh_(load_scene("soup:400", "")), tracer_(make_tracer(GetParam(), mesh_)) {
    for (const Ray<float>& ray : random_rays(mesh_->bounds(), 40, 3)) models_.push_back(model_of(*tracer_, ray));
  }

  std::shared_ptr<const TriangleMesh> mesh_;
  std::unique_ptr<Tracer> tracer_;
  std::vector<WalkModel> models_;
};

TEST_P(ShownWalk, StatesFollowTheSteps) {
  for (const WalkModel& model : models_) {
    const Walk& walk = model.walk;
    for (std::size_t step = 0; step < walk.steps.size(); ++step) {
      const std::vector<CellState> states = states_at(walk, step);
      const std::vector<std::size_t> pending = walk.pending(step);
      EXPECT_EQ(std::ranges::count(states, CellState::current), 1);
      EXPECT_EQ(states[walk.cell_of(walk.steps[step].node)], CellState::current);
      EXPECT_EQ(std::ranges::count(states, CellState::pending), static_cast<std::ptrdiff_t>(pending.size()));
      for (const std::size_t i : pending) EXPECT_EQ(states[i], CellState::pending);
      for (std::size_t i = 0; i < states.size(); ++i) {
        const auto& opened = walk.cells[i].opened;
        const bool is_dropped = opened && walk.steps[*opened].kind == Kind::cull;
        if (states[i] == CellState::culled) {
          EXPECT_TRUE(is_dropped && *opened <= step);
        }
        if (states[i] == CellState::beside) {
          EXPECT_FALSE(opened);
        }
        if (opened && *opened < step && states[i] != CellState::current) {
          EXPECT_EQ(states[i], is_dropped ? CellState::culled : CellState::opened);
        }
        if (opened && *opened > step) {
          EXPECT_TRUE(states[i] == CellState::pending || states[i] == CellState::unseen);
        }
      }
    }
  }
}

TEST_P(ShownWalk, CountersEndAsTheTraversals) {
  for (const WalkModel& model : models_) {
    if (model.walk.steps.empty()) continue;
    TraversalStats stats;
    Hit<float> hit;
    static_cast<const Queries<float>&>(*tracer_).closest_hits({&model.walk.ray, 1}, {&hit, 1}, stats);
    EXPECT_EQ(statistics_at(model.walk, model.last_step()), stats);
    for (std::size_t step = 0; step <= model.last_step(); ++step) {
      const TraversalStats some = statistics_at(model.walk, step);
      EXPECT_EQ(some.nodes + some.leaves + some.candidates + some.culled, step + 1);
      const WalkStep& at = model.walk.steps[step];
      const std::string number = at.kind == Kind::candidate ? std::to_string(at.triangle) : number_of_node(at.node);
      EXPECT_NE(sentence_of(model.walk, step).find(number), std::string::npos);
    }
  }
}

TEST_P(ShownWalk, AreasAddUpAndNothingOverlaps) {
  const Panel all{100, 50, 800, 300};
  for (const WalkModel& model : models_) {
    const auto& cells = model.walk.cells;
    const std::vector<Panel> panels = lay_out_treemap(model.walk, model.candidates, all);
    ASSERT_EQ(panels.size(), cells.size());
    constexpr double rounding = 1e-9;  // of sums of a few hundred doubles near 1000
    std::vector<double> within(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Panel& p = panels[i];
      ASSERT_GE(p.width, -rounding);
      ASSERT_GE(p.height, -rounding);
      if (!cells[i].parent) continue;
      const Panel& above = panels[*cells[i].parent];
      within[*cells[i].parent] += p.width * p.height;
      EXPECT_GE(p.x, above.x - rounding);
      EXPECT_GE(p.y, above.y - rounding);
      EXPECT_LE(p.x + p.width, above.x + above.width + rounding);
      EXPECT_LE(p.y + p.height, above.y + above.height + rounding);
      for (std::size_t j = i + 1; j < cells.size(); ++j) {
        if (cells[j].parent != cells[i].parent) continue;
        const Panel& q = panels[j];
        const double across = std::min(p.x + p.width, q.x + q.width) - std::max(p.x, q.x);
        const double down = std::min(p.y + p.height, q.y + q.height) - std::max(p.y, q.y);
        EXPECT_TRUE(across <= rounding || down <= rounding) << i << " and " << j;
      }
    }
    // All children of a node that a hierarchy has opened are there, and fill it.
    const bool is_hierarchy = GetParam() != "grid" && GetParam() != "brute-force";
    for (std::size_t i = 0; i < cells.size() && is_hierarchy; ++i) {
      const Panel& p = panels[i];
      const bool is_opened = cells[i].opened && model.walk.steps[*cells[i].opened].kind == Kind::visit;
      if (!is_opened || within[i] == 0) continue;
      EXPECT_NEAR(within[i], p.width * p.height, 1e-6);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].cell.is_leaf) {
        EXPECT_EQ(model.candidates[i], cells[i].cell.range.count);
      }
    }
  }
}

TEST_P(ShownWalk, HierarchyIsInItsPanelAndShowsTheCurrentCell) {
  const WalkLayout layout(1920, 1080);
  for (const Panel& panel : {layout.tree, Panel{0, 0, 90, 40}}) {
    for (const WalkModel& model : models_) {
      const Walk& walk = model.walk;
      for (std::size_t step = 0; step < walk.steps.size(); step += 3) {
        const std::size_t current = current_cell(walk, step);
        const TreeLayout tree = lay_out_tree(walk, states_at(walk, step), current, panel);
        std::size_t hidden = 0;
        bool has_current = false;
        for (const auto& node : tree.nodes) {
          hidden += node.hidden;
          has_current |= node.cell == current;
          EXPECT_TRUE(panel.contains(node.x, node.y));
          if (node.above) {
            EXPECT_EQ(tree.nodes[*node.above].cell, *walk.cells[node.cell].parent);
          }
          EXPECT_TRUE(tree.cell_at(node.x, node.y));
        }
        EXPECT_TRUE(has_current);
        EXPECT_EQ(tree.nodes.size() + tree.left_out, walk.cells.size());
        if (tree.first_depth == 0) {
          EXPECT_EQ(hidden, tree.left_out);
        }
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
          for (std::size_t j = i + 1; j < tree.nodes.size(); ++j) {
            const auto &a = tree.nodes[i], &b = tree.nodes[j];
            EXPECT_GE(std::hypot(a.x - b.x, a.y - b.y), 2 * tree.radius);
          }
        }
      }
    }
  }
}

TEST_P(ShownWalk, TimelineHasEveryStepOnce) {
  for (const WalkModel& model : models_) {
    for (const Panel& panel : {Panel{10, 10, 900, 80}, Panel{10, 10, 12, 80}}) {  // the second has room for 6 ticks
      const std::vector<Tick> ticks = lay_out_timeline(model.walk, panel);
      std::size_t next = 0;
      for (const Tick& tick : ticks) {
        EXPECT_EQ(tick.first, next);
        EXPECT_TRUE(tick.first <= tick.shown && tick.shown <= tick.last);
        EXPECT_LE(tick.x + tick.width, panel.x + panel.width + 1e-9);
        EXPECT_LE(tick.height, panel.height);
        EXPECT_EQ(step_at(ticks, tick.x + tick.width / 2), tick.shown);
        next = tick.last + 1;
      }
      EXPECT_EQ(next, model.walk.steps.size());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, ShownWalk, testing::ValuesIn(structure_names()), test_name_of);

TEST(WalkModel, TellsWhatALazyTreeHasMadeForTheRay) {
  const auto mesh = load_scene("soup:2000", "");
  const auto tracer = make_tracer("bih", mesh, {{{"lazy", "true"}}});
  const Ray<float> ray = usual_ray(mesh->bounds());
  const WalkModel first = model_of(*tracer, ray), again = walk_again(first, ray);
  EXPECT_GT(first.walk.all_cells, first.cells_before);
  EXPECT_GT(std::ranges::count(first.is_new, 1), 4);
  EXPECT_EQ(again.walk.all_cells, again.cells_before);
  EXPECT_EQ(std::ranges::count(again.is_new, 1), 0);
  EXPECT_EQ(again.command, " --earlier=" + text_of(ray));
}

TEST(WalkModel, LeavesAreFoundBothWays) {
  const auto mesh = load_scene("soup:2000", "");
  const auto tracer = make_tracer("kd-tree", mesh);
  const WalkModel model = model_of(*tracer, usual_ray(mesh->bounds()));
  std::size_t at = 0, count = 0;
  for (std::size_t next = leaf_beside(model.walk, at, 1); next != at; next = leaf_beside(model.walk, at, 1)) {
    EXPECT_EQ(model.walk.steps[next].kind, Kind::leaf);
    if (count++ > 0) {
      EXPECT_EQ(leaf_beside(model.walk, next, -1), at);
    }
    at = next;
  }
  EXPECT_EQ(count, model.walk.statistics().leaves);
  EXPECT_GT(count, 0u);
}

TEST(CoarseMesh, HasFewTrianglesInTheSamePlace) {
  const auto teapot = load_scene("teapot", "");
  const TriangleMesh coarse = coarse_mesh(*teapot, 2000);
  EXPECT_LE(coarse.size(), 2000u);
  EXPECT_GE(coarse.size(), 500u);
  const Aabb &a = teapot->bounds(), &b = coarse.bounds();
  const float near = 0.05f * max_norm(a.extent());  // a cell of the grid, about
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(a.lo[axis], b.lo[axis], near);
    EXPECT_NEAR(a.hi[axis], b.hi[axis], near);
  }
  EXPECT_EQ(coarse_mesh(*teapot, teapot->size()).size(), teapot->size());
  const auto soup = load_scene("soup:20000", "");
  const TriangleMesh thin = coarse_mesh(*soup, 1000);
  EXPECT_LE(thin.size(), 1000u);
  EXPECT_GE(thin.size(), 125u);
}

/// Children of what divides space fill their node: the face between two is one plane of all its points, within the
/// node.
TEST(SplitFaces, LieBetweenTheChildren) {
  const auto mesh = load_scene("teapot:4", "");
  for (const char* structure : {"kd-tree", "bsp-tree", "bih"}) {
    const auto tracer = make_tracer(structure, mesh);
    const Walk walk = record_walk(*tracer, usual_ray(*tracer));
    const std::size_t most = std::string_view(structure) == "bih" ? 2 : 1;
    std::size_t found = 0;
    for (std::size_t step = 0; step < walk.steps.size(); ++step) {
      const auto faces = split_faces(structure, walk, step);
      found += !faces.empty();
      EXPECT_LE(faces.size(), most) << structure << " step " << step;
      for (const auto& face : faces) {
        ASSERT_GE(face.size(), 3u);
        for (const Vec3d& p : face) {
          for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(p[axis], mesh->bounds().lo[axis] - 1e-5);
            EXPECT_LE(p[axis], mesh->bounds().hi[axis] + 1e-5);
          }
        }
      }
    }
    EXPECT_GT(found, walk.steps.size() / 2) << structure;
  }
  const auto tracer = make_tracer("box-tree", mesh);
  EXPECT_TRUE(split_faces("box-tree", record_walk(*tracer, usual_ray(*tracer)), 0).empty());
}

/// Wherever a scene is, and whatever it has in its middle.
TEST(UsualRay, Hits) {
  for (const char* scene : {"teapot:4", "soup:50", "sphere-flake:1", "stadium:4", "menger:1"}) {
    const auto mesh = load_scene(scene, "");
    for (const char* structure : {"kd-tree", "bih"}) {
      const auto tracer = make_tracer(structure, mesh);
      EXPECT_TRUE(record_walk(*tracer, usual_ray(*tracer)).hit.is_hit()) << structure << " on " << scene;
    }
  }
  TracerSettings lazy;
  lazy.options = {{"lazy", "true"}};
  const auto tracer = make_tracer("bih", load_scene("teapot:4", ""), lazy);
  std::size_t before = 0, after = 0;
  tracer->for_each_cell([&](const Cell&) { ++before; });
  usual_ray(*tracer);
  tracer->for_each_cell([&](const Cell&) { ++after; });
  EXPECT_EQ(before, after) << "looking for a ray is not asking for cells";
}

}  // namespace
}  // namespace sightline::viz
