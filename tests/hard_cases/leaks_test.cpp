/// Nothing slips through closed meshes: a million rays at edges and vertices, through all structures.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/hard_cases/leaks/closed_seeds.h"
#include "tests/hard_cases/leaks/leak_hunt.h"
#include "tests/hard_cases/leaks/leak_mesh.h"
#include "tests/hard_cases/leaks/leak_report.h"

namespace sightline::hard {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t ray_count = 100'000;  // sanitizers look for other faults, at thirty times the time
#else
constexpr std::uint64_t ray_count = 1'000'000;
#endif

LeakReport hunt(std::uint64_t rays, const std::string& structures, Level level = Level::watertight) {
  LeakPlan plan;
  plan.rays = rays;
  plan.level = level;
  plan.data_dir = SIGHTLINE_SOURCE_DIR "/data";
  if (!structures.empty()) plan.structures = parse_accelerators(structures);
  Progress progress;
  return hunt_leaks(plan, progress);
}

TEST(Leaks, NoneInAMillionRays) {
  const LeakReport report = hunt(ray_count, "");
  EXPECT_EQ(report.rays(), ray_count);
  EXPECT_EQ(report.rows.size(), accelerator_infos().size());
  for (const LeakRow& row : report.rows) {
    EXPECT_EQ(row.leaks(), 0u) << row.first_leak;
    EXPECT_GE(row.rays(), ray_count / report.rows.size());
    for (std::size_t i = 0; i < leak_ways.size(); ++i) {
      EXPECT_GT(row.ways[i].rays, 0u) << row.structure << ": " << leak_ways[i].name;
    }
  }
}

/// Variants that structures have among their options.
TEST(Leaks, NoneThroughOtherNodesAndLazyOnes) {
  const LeakReport report = hunt(ray_count / 10, "wide-tree:compressed=true,bih:lazy=true,box-tree:splits=2");
  for (const LeakRow& row : report.rows) EXPECT_EQ(row.leaks(), 0u) << row.first_leak;
}

/// So that one knows what the hunt finds: at level fast rays do slip through, and a line tells how to have one again.
TEST(Leaks, AreFoundWhereThereAreSome) {
  const LeakReport report = hunt(ray_count / 10, "box-tree", Level::fast);
  ASSERT_EQ(report.rows.size(), 1u);
  const LeakRow& row = report.rows[0];
  EXPECT_GT(row.leaks(), row.rays() / 1000);
  EXPECT_EQ(row.first_leak.rfind("box-tree, ", 0), 0u) << row.first_leak;
  EXPECT_NE(row.first_leak.find("seed 1, ray "), std::string::npos) << row.first_leak;
  EXPECT_NE(text_table(report).find(row.first_leak), std::string::npos);
  EXPECT_EQ(to_json(report)["structures"][0]["leaks"], row.leaks());
  for (std::size_t i = 0; i < leak_ways.size(); ++i) {
    if (!leak_ways[i].is_double) continue;
    EXPECT_EQ(row.ways[i].leaks, 0u) << leak_ways[i].name;
  }
}

TEST(Leaks, AreAskedOfRaysThatGoThroughVerticesExactly) {
  const LeakMesh mesh("icosphere", icosphere(1), {"on a lattice", 1, Vec3d(0), 0x1p-9});
  std::array<Ray<float>, LeakMesh::group_size> rays;
  int through = 0;
  for (std::uint64_t group = 0; group < 100; ++group) {
    mesh.rays(1, group, rays.data(), LeakMesh::Aim::vertices);
    for (const Ray<float>& ray : rays) {
      for (const Vec3f& vertex : mesh.mesh()->positions()) {
        const Vec3d origin(ray.origin), way = Vec3d(vertex) - origin, direction(ray.direction);  // all exact
        through += glm::cross(way, direction) == Vec3d(0) && glm::dot(way, direction) > 0;
      }
    }
  }
  EXPECT_GE(through, 1600);
}

TEST(Leaks, KnowInsideFromOutside) {
  for (const NamedSeed& seed : closed_seeds(SIGHTLINE_SOURCE_DIR "/data")) {
    EXPECT_TRUE(is_closed(seed.mesh)) << seed.name;
    const LeakMesh mesh(seed.name, seed.mesh, {"at 1", 1, Vec3d(0), 0});
    EXPECT_FALSE(mesh.inside().empty());
    for (const Vec3d& point : mesh.inside()) EXPECT_GT(std::fabs(mesh.winding(point)), 0.99) << seed.name;
    EXPECT_NEAR(mesh.winding(Vec3d(3, 2, 1)), 0, 0x1p-10) << seed.name;
  }
  MeshSeed open = cube();
  open.triangles.pop_back();
  EXPECT_FALSE(is_closed(open));
  EXPECT_THROW(LeakMesh("open", open, {}), std::logic_error);
}

TEST(Leaks, RefuseWhatCannotBeAsked) {
  EXPECT_THROW(hunt(0, ""), std::invalid_argument);
  EXPECT_THROW(hunt(1, "no-tree"), std::invalid_argument);
  EXPECT_THROW(hunt(1, "", Level::exact), std::invalid_argument);
}

}  // namespace
}  // namespace sightline::hard
