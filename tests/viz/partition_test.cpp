#include "viz/partition.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

#include "viz/cell_geometry.h"
#include "viz/color_ramp.h"
#include "viz/view_options.h"

namespace sightline::viz {
namespace {

const Aabb unit_box{{0, 0, 0}, {1, 2, 3}};

template <class Region>
Cell cell_of(Region region) {
  Cell cell;
  cell.region = std::move(region);
  return cell;
}

TEST(Cells, VolumesAndExtents) {
  EXPECT_DOUBLE_EQ(volume_of(cell_of(unit_box)), 6);
  EXPECT_NEAR(volume_of(cell_of(Sphere{{1, 1, 1}, 2})), 32 * std::numbers::pi / 3, 1e-9);
  const Cell tilted = cell_of(Cylinder{{0, 0, 0}, {0.6F, 0.8F, 0}, 1, 5});
  EXPECT_NEAR(volume_of(tilted), 10 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(extent_along(tilted, 0).hi, 0.6 * 5 + 0.8, 1e-6);
  EXPECT_NEAR(extent_along(tilted, 2).lo, -1, 1e-6);
  const Cell tetrahedron =
      cell_of(Polyhedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
  EXPECT_NEAR(volume_of(tetrahedron), 1.0 / 6, 1e-15);
}

TEST(Cells, OutlinesAndSections) {
  const Cell box = cell_of(unit_box);
  EXPECT_EQ(cell_outlines({&box, 1})->GetNumberOfLines(), 12);
  EXPECT_EQ(cell_surfaces({&box, 1})->GetNumberOfPolys(), 6);
  const Sections cut = cell_sections({&box, 1}, 2, 1.5);
  EXPECT_EQ(cut.polygons->GetNumberOfPolys(), 1);
  EXPECT_EQ(cut.polygons->GetNumberOfPoints(), 4);
  EXPECT_EQ(cell_sections({&box, 1}, 2, 3.5).polygons->GetNumberOfPolys(), 0);
}

TEST(Cells, FilterKeepsTheLargest) {
  std::vector<Vec3f> corners;
  std::vector<TriangleMesh::Corners> triangles;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const auto x = static_cast<float>(i);
    corners.insert(corners.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, x}});
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto tracer =
      make_tracer("kd-tree", std::make_shared<const TriangleMesh>(corners, triangles), {{{"max_leaf_size", "2"}}});
  CellFilter filter;
  filter.leaves_only = true;
  const Partition all = select_cells(*tracer, filter);
  ASSERT_GT(all.cells.size(), 8U);
  filter.max_cells = 3;
  const Partition few = select_cells(*tracer, filter);
  ASSERT_EQ(few.cells.size(), 3U);
  EXPECT_EQ(few.passing, all.cells.size());
  std::size_t larger = 0;
  double smallest = 1e300;
  for (const Cell& cell : few.cells) smallest = std::min(smallest, volume_of(cell));
  for (const Cell& cell : all.cells) larger += volume_of(cell) > smallest;
  EXPECT_LE(larger, 2U);
}

TEST(Meshes, ShowEachTriangleOnce) {
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {2, 0, 1}, {0, 1, 3}, {0, 1, 2}});
  EXPECT_EQ(mesh_surface(mesh)->GetNumberOfPolys(), 2);
  EXPECT_EQ(mesh_surface(mesh)->GetNumberOfPoints(), 4);
}

TEST(Colors, LightnessRises) {
  const auto light = [](const Rgb& c) {
    return 0.2126 * linear_from_srgb(c[0]) + 0.7152 * linear_from_srgb(c[1]) + 0.0722 * linear_from_srgb(c[2]);
  };
  for (int i = 0; i < 100; ++i) EXPECT_LT(light(ramp(i / 100.0)), light(ramp((i + 1) / 100.0))) << i;
}

TEST(Options, DepthAndSlice) {
  EXPECT_EQ(parse_depth("4").deepest, 4);
  EXPECT_EQ(parse_depth("2:").shallowest, 2);
  EXPECT_EQ(parse_depth(":3").deepest, 3);
  EXPECT_EQ(parse_slice("z=0.25").axis, 2);
  for (const char* wrong : {"", ":", "3:1", "1:2:3", "-1", " 2", "99999999999"}) {
    EXPECT_THROW(parse_depth(wrong), UsageError) << wrong;
  }
  for (const char* wrong : {"", "z", "z=", "z=0.5x", "q=1", "zz=1", "y=inf", "y=-0.1"}) {
    EXPECT_THROW(parse_slice(wrong), UsageError) << wrong;
  }
}

}  // namespace
}  // namespace sightline::viz
