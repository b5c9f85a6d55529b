#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sightline/csg/solid.h"
#include "sightline/math/random.h"
#include "sightline/scene/levels.h"
#include "viz/cell_geometry.h"
#include "viz/graph/bound_lines.h"
#include "viz/graph/graph_layout.h"
#include "viz/graph/graph_scene.h"
#include "viz/graph/graph_space.h"
#include "viz/graph/graph_table.h"

namespace sightline::viz {
namespace {

SceneGraph chain(NodeId size) {
  SceneGraph graph;
  for (NodeId node = 1; node < size; ++node) graph.add(node - 1, "link");
  return graph;
}

TEST(Drag, BubblesFromTheNodeToTheRootAndMovesWhatIsBelow) {
  for (const BoundKind kind : bound_kinds) {
    LiveScene scene(make_levels(5));
    const NodeId node = node_by_name(scene.graph(), "/top/left/left");
    const Change change = drag(scene, node, {-0.75, 0.5, 0.25}, kind);
    std::vector<NodeId> up;
    for (NodeId above = node; above != no_node; above = scene.graph().parent(above)) up.push_back(above);
    EXPECT_EQ(change.way, up);
    EXPECT_EQ(change.work.marked, up.size());
    const TreeShape shape(scene.graph());
    EXPECT_EQ(change.work.worlds, shape.sizes[node]);
    LiveScene fresh(scene.scene());
    const SharedSnapshot now = snapshot_of(fresh, kind);
    std::size_t moved = 0;
    for (const NodeId each : shape.order) {
      EXPECT_EQ(change.after->worlds[each], now->worlds[each]);
      EXPECT_TRUE(is_nothing(now->bounds[each]) || is_same(change.after->bounds[each], now->bounds[each]));
      if (change.before->worlds[each] == change.after->worlds[each]) continue;
      ++moved;
      const Vec3d by = change.after->worlds[each].column(3) - change.before->worlds[each].column(3);
      EXPECT_LT(max_norm(by - change.by), 0x1p-48);
    }
    EXPECT_EQ(moved, shape.sizes[node]);
    EXPECT_GT(volume_of(change.after->bounds[root_node]), volume_of(change.before->bounds[root_node]));
  }
}

TEST(Frames, TellTheEventStepByStep) {
  LiveScene scene(make_levels(6));
  const NodeId node = node_by_name(scene.graph(), "/top/left/right/left/right");
  const Change change = drag(scene, node, {1, 0, 0}, BoundKind::box);
  ASSERT_EQ(change.way.size(), 6u);
  for (int count = 2; count <= most_drag_frames; ++count) {
    const auto frames = frames_of(change, scene.graph(), count);
    ASSERT_EQ(frames.size(), static_cast<std::size_t>(std::min(count, 8)));
    EXPECT_TRUE(frames.front().told.empty());
    EXPECT_EQ(frames.front().places, change.before);
    EXPECT_EQ(frames.back().told, change.way);
    EXPECT_EQ(frames.back().bounds, change.after);
    EXPECT_EQ(frames.back().former, change.before);
    EXPECT_FALSE(frames.back().is_stale);
    for (std::size_t i = 1; i + 1 < frames.size(); ++i) {
      EXPECT_TRUE(frames[i].is_stale);
      EXPECT_EQ(frames[i].places, change.after);
      EXPECT_EQ(frames[i].bounds, change.before);
      EXPECT_GT(frames[i].told.size(), frames[i - 1].told.size());
      EXPECT_TRUE(std::equal(frames[i].told.begin(), frames[i].told.end(), change.way.begin()));
    }
    if (count > 3) {
      EXPECT_EQ(frames[1].told.size(), 1u);
    }
    if (count > 2) {
      EXPECT_EQ(frames[frames.size() - 2].told, change.way);
    }
  }
}

TEST(Frames, FollowAController) {
  const PlayedScene played = load_played_scene("levels:4", "");
  ASSERT_TRUE(played.controller);
  LiveScene scene(played.scene);
  const auto frames = frames_of(scene, *played.controller, 0, 3, 4, BoundKind::sphere);
  ASSERT_EQ(frames.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    LiveScene fresh(make_levels(4, 30.0 * i));
    const SharedSnapshot expected = snapshot_of(fresh, BoundKind::sphere);
    const GraphFrame& frame = frames[static_cast<std::size_t>(i)];
    EXPECT_EQ(frame.places->worlds, expected->worlds) << i;
    EXPECT_EQ(frame.former != nullptr, i > 0);
    const std::set<NodeId> told(frame.told.begin(), frame.told.end());
    EXPECT_EQ(told.size(), frame.told.size());
    EXPECT_TRUE(told.contains(root_node));
    EXPECT_TRUE(numbered(frame).empty());
  }
  const PlayedScene rocket = load_played_scene("rocket", "");
  ASSERT_TRUE(rocket.controller);
  EXPECT_GT(rocket.duration, 3);
  EXPECT_FALSE(load_played_scene("teapot:2", "").controller);
}

TEST(Frames, NumberOnlyTheEndsOfLongWays) {
  Scene scene;
  scene.graph = chain(1'000);
  LiveScene live(std::move(scene));
  const Change change = drag(live, 999, {1, 0, 0}, BoundKind::box);
  EXPECT_EQ(change.way.size(), 1'000u);
  const auto numbers = numbered(frames_of(change, live.graph(), 6).back());
  ASSERT_EQ(numbers.size(), 14u);
  EXPECT_EQ(numbers.front(), (std::pair<NodeId, std::size_t>(999, 1)));
  EXPECT_EQ(numbers.back(), (std::pair<NodeId, std::size_t>(root_node, 1'000)));
}

TEST(ChangeTable, TellsWhatTheEventDid) {
  LiveScene scene(make_levels(3));
  const TreeShape shape(scene.graph());
  const Change change = drag(scene, node_by_name(scene.graph(), "/top/left"), {1, 0, 0}, BoundKind::box);
  const std::string all = change_table(scene.graph(), shape, change, false);
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  EXPECT_EQ(lines(all), static_cast<long>(scene.graph().size()) + 2);
  EXPECT_EQ(lines(change_table(scene.graph(), shape, change, true)), 3 + 2);
  for (const char* text : {"1st", "2nd", "3rd          0", "moves along  3", "/top/left/right/sphere", "none"}) {
    EXPECT_NE(all.find(text), std::string::npos) << text;
  }
}

TEST(GraphLayout, KeepsFramesApartAndWithin) {
  for (const bool has_one_tree : {true, false}) {
    for (int count = 1; count <= (has_one_tree ? most_frames : most_drag_frames); ++count) {
      for (const double aspect : {0.2, 1.0, 3.0}) {
        const GraphLayout layout(1000, 700, count, has_one_tree, aspect);
        std::vector<PanelFrame> parts;
        for (const FramePlace& place : layout.frames()) {
          parts.push_back(place.space);
          if (place.tree.width > 0) parts.push_back(place.tree);
        }
        EXPECT_EQ(parts.size(), static_cast<std::size_t>(has_one_tree ? count + 1 : 2 * count));
        for (const PanelFrame& a : parts) {
          EXPECT_GT(a.width, 80);
          EXPECT_GT(a.height, 80);
          EXPECT_GE(a.x, 0);
          EXPECT_GE(a.y, GraphLayout::top - 1);
          EXPECT_LE(a.x + a.width, layout.width());
          EXPECT_LE(a.y + a.height, layout.height() - GraphLayout::bottom + 1);
          for (const PanelFrame& b : parts) {
            const bool is_apart =
                a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
            EXPECT_TRUE(is_apart || &a == &b);
          }
        }
      }
    }
  }
}

TEST(SpaceCamera, SeesAllPointsAsNearAsTheyFit) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    std::vector<Vec3d> points;
    const Vec3d middle = 100.0 * (Vec3d(random.uniform_double(), random.uniform_double(), random.uniform_double()));
    for (int k = 0; k < 12; ++k) {
      points.push_back(middle + Vec3d(random.uniform_double(), random.uniform_double(), random.uniform_double()));
    }
    const double aspect = 0.5 + 2 * random.uniform_double();
    const SpaceCamera camera =
        fit_camera(axes_toward(360 * random.uniform_double(), 80 * random.uniform_double()), points, aspect, 1);
    double largest = 0;
    for (const Vec3d& p : points) {
      const auto on_screen = camera.project(p);
      ASSERT_TRUE(on_screen);
      largest = std::max({largest, std::fabs(on_screen->x), std::fabs(on_screen->y)});
      const Vec3d higher = p + camera.half_height_at(p) * camera.axes.y;
      EXPECT_NEAR(camera.project(higher)->y, on_screen->y + 1, 1e-9);
    }
    EXPECT_LE(largest, 1);
    EXPECT_GT(largest, 0.8);
    EXPECT_FALSE(camera.project(camera.eye + camera.axes.z));
  }
}

TEST(BoundLines, CoincidingBoundsAreDrawnApart) {
  LiveScene scene(make_levels(3));
  const TreeShape shape(scene.graph());
  const SharedSnapshot snapshot = snapshot_of(scene, BoundKind::box);
  const std::vector<double> pads = paddings(scene.graph(), shape, *snapshot, shape.order);
  const auto pad = [&](const std::string& path) {
    const auto at = std::find(shape.order.begin(), shape.order.end(), node_by_name(scene.graph(), path));
    return pads[static_cast<std::size_t>(at - shape.order.begin())];
  };
  EXPECT_EQ(pad("/top/left/left/sphere"), 0);
  EXPECT_EQ(pad("/top/left/left"), 1);
  EXPECT_EQ(pad("/"), pad("/top") + 1);
}

double length_of(vtkPolyData& lines) {
  double sum = 0;
  for (vtkIdType i = 0; i < lines.GetNumberOfCells(); ++i) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    lines.GetLines()->GetCellAtId(i, count, ids);
    for (vtkIdType k = 0; k + 1 < count; ++k) {
      Vec3d a, b;
      lines.GetPoint(ids[k], &a[0]);
      lines.GetPoint(ids[k + 1], &b[0]);
      sum += glm::length(b - a);
    }
  }
  return sum;
}

TEST(BoundLines, DashesCoverHalf) {
  const std::vector<Cell> cells{cell_of(Sphere{Vec3f(1, 2, 3), 2}, 0, 0), cell_of(Aabb{Vec3f(0), Vec3f(3)}, 0.5, 0)};
  const auto lines = cell_outlines(cells);
  const double whole = length_of(*lines);
  EXPECT_NEAR(length_of(*dashed(*lines, 0.05)), whole / 2, 0.02 * whole);
  EXPECT_NEAR(length_of(*dashed(*lines, 1e9)), whole, 1e-3 * whole);
}

Aabb box_of(vtkPolyData& surface) {
  Aabb box;
  for (const Vec3d& p : points_of(surface)) box.extend(Vec3f(p));
  return box;
}

TEST(SolidSurface, HasTheSolidsBounds) {
  const solid::Box box{{-1, -2, -3}, {1, 2, 3}};
  const std::vector<SolidTree> trees{box,
                                     solid::Sphere{{1, 2, 3}, 2},
                                     solid::Cylinder{{0, 0, 0}, {0, 4, 0}, 0.5},
                                     solid::Cone{{0, 5.5, 0}, {0, 4, 0}, 0.5},
                                     solid::Torus{{0, 0, 0}, {0, 0, 2}, 2, 0.5},
                                     SolidTree(box) - solid::Sphere{{0, 0, 0}, 1.5},
                                     SolidTree(box) & ~SolidTree(solid::Sphere{{9, 9, 9}, 1})};
  for (const SolidTree& tree : trees) {
    const auto surface = solid_surface(tree);
    ASSERT_TRUE(surface);
    const Aabb found = box_of(*surface), expected = Solid(tree).bounds();
    EXPECT_LT(max_norm(found.lo - expected.lo), 0.06f * max_norm(expected.extent()));
    EXPECT_LT(max_norm(found.hi - expected.hi), 0.06f * max_norm(expected.extent()));
    EXPECT_GT(surface->GetNumberOfCells(), 5);
  }
  EXPECT_FALSE(solid_surface(solid::HalfSpace{{0, 1, 0}, 0}));
}

}  // namespace
}  // namespace sightline::viz
