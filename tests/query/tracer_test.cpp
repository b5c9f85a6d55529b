#include "sightline/query/tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "sightline/math/random.h"
#include "sightline/query/workloads.h"
#include "sightline/shape/triangle_crossings.h"

namespace sightline {
namespace {

std::shared_ptr<const TriangleMesh> small_mesh() {
  Random random(1);
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Vec3f at(random.uniform(), random.uniform(), random.uniform());
    positions.insert(positions.end(), {at, at + Vec3f(0.1f, 0, 0.02f), at + Vec3f(0, 0.1f, 0.05f)});
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return std::make_shared<TriangleMesh>(std::move(positions), std::move(triangles));
}

std::string message_of(std::string_view accelerator, const TracerSettings& settings = {}) {
  try {
    make_tracer(accelerator, small_mesh(), settings);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Tracer, IsMadeForEveryStructureOfTheRegistry) {
  ASSERT_FALSE(accelerator_infos().empty());
  for (const AcceleratorInfo& info : accelerator_infos()) {
    const auto tracer = make_tracer(info.name, small_mesh());
    EXPECT_EQ(tracer->name(), info.name);
    EXPECT_FALSE(info.description.empty());
    EXPECT_GE(tracer->leaf_order().size(), 300u);
    EXPECT_GE(tracer->structure_bytes(), tracer->leaf_order().size() * 4);
    EXPECT_GE(tracer->leaf_bytes(), tracer->leaf_order().size() * 40);
    for (const auto& option : info.options) {
      EXPECT_FALSE(option.help.empty());
      const auto same = make_tracer(info.name, small_mesh(), {{{std::string(option.name), option.default_value}}});
      EXPECT_EQ(same->leaf_order().size(), tracer->leaf_order().size()) << info.name << ' ' << option.name;
    }
  }
}

TEST(Tracer, AnswersTheSamePackedCountedRecordedAndInBatches) {
  const auto mesh = small_mesh();
  const auto rays = random_rays(mesh->bounds(), 500, 2);
  for (const AcceleratorInfo& info : accelerator_infos()) {
    const auto packed = make_tracer(info.name, mesh),
               indexed = make_tracer(info.name, mesh, {.options = {}, .pack_leaves = false});
    EXPECT_EQ(indexed->leaf_bytes(), 0u);
    std::vector<Hit<float>> hits(rays.size()), same(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    TraversalStats stats;
    packed->closest_hits(rays, hits);
    indexed->closest_hits(rays, same, stats);
    EXPECT_TRUE(hits == same);
    EXPECT_GT(stats.candidates, 0u);
    packed->any_hits(rays, any);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      WalkRecorder walk;
      EXPECT_TRUE(packed->record(rays[i], walk) == hits[i]);
      const auto all = packed->all_hits(rays[i]);
      EXPECT_TRUE((all.empty() ? Hit<float>{} : all.front()) == hits[i]);
      EXPECT_EQ(any[i], hits[i].is_hit());
    }
    EXPECT_GT(std::count(any.begin(), any.end(), 1), 50);
  }
}

TEST(Tracer, AnswersAlmostTheSameAtLevelFast) {
  const auto mesh = small_mesh();
  const auto rays = random_rays(mesh->bounds(), 2000, 2);
  std::vector<Hit<float>> expected(rays.size());
  make_tracer("brute-force", mesh)->closest_hits(rays, expected, Level::fast);
  for (const AcceleratorInfo& info : accelerator_infos()) {
    const auto tracer = make_tracer(info.name, mesh);
    std::vector<Hit<float>> fast(rays.size()), sure(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    tracer->closest_hits(rays, fast, Level::fast);
    tracer->closest_hits(rays, sure);
    tracer->any_hits(rays, any, Level::fast);
    EXPECT_TRUE(fast == expected) << info.name;
    std::size_t other = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(any[i] != 0, fast[i].is_hit());
      other += fast[i].prim_id != sure[i].prim_id;
      if (fast[i].prim_id != sure[i].prim_id || !fast[i].is_hit()) continue;
      EXPECT_NEAR(fast[i].t, sure[i].t, 1e-5f * sure[i].t);
    }
    EXPECT_LE(other, 2u);
  }
}

/// More rays than are under way at once, fewer, and none; valid ones between such as hit nothing by definition.
TEST(Tracer, StreamsGiveTheHitsOfSingleRays) {
  const auto mesh = small_mesh();
  auto rays = random_rays(mesh->bounds(), 1000, 4);
  for (std::size_t i = 0; i < rays.size(); i += 7) rays[i].direction = Vec3f(0);
  for (const AcceleratorInfo& info : accelerator_infos()) {
    const auto tracer = make_tracer(info.name, mesh);
    for (const Level level : {Level::fast, Level::watertight}) {
      for (const std::size_t count : {std::size_t{0}, std::size_t{5}, rays.size()}) {
        const std::span<const Ray<float>> some(rays.data(), count);
        std::vector<Hit<float>> hits(count), expected(count);
        std::vector<std::uint8_t> any(count), expected_any(count);
        tracer->closest_hits(some, expected, level);
        tracer->any_hits(some, expected_any, level);
        tracer->stream_closest_hits(some, hits, level);
        tracer->stream_any_hits(some, any, level);
        EXPECT_TRUE(hits == expected) << info.name;
        EXPECT_TRUE(any == expected_any) << info.name;
      }
    }
    std::vector<Ray<double>> wide(200);
    for (std::size_t i = 0; i < wide.size(); ++i) wide[i] = to_double(rays[i]);
    std::vector<Hit<double>> hits(wide.size()), expected(wide.size());
    tracer->closest_hits(wide, expected);
    tracer->stream_closest_hits(wide, hits);
    EXPECT_TRUE(hits == expected) << info.name;
  }
}

TEST(Tracer, RoundsToTheNearestDoubleAtLevelExact) {
  const auto mesh = small_mesh();
  const std::vector<Vec3d> vertices(mesh->positions().begin(), mesh->positions().end());
  std::vector<Ray<double>> rays;
  std::vector<Hit<double>> expected;
  std::size_t off = 0;
  for (const Ray<float>& ray : random_rays(mesh->bounds(), 200, 8)) {
    rays.push_back(to_double(ray));
    const auto crossings = triangle_crossings(FramedRay(rays.back()), vertices, mesh->triangles());
    expected.push_back(crossings.empty() ? Hit<double>{} : Hit<double>{crossings[0].t, crossings[0].triangles[0]});
  }
  for (const AcceleratorInfo& info : accelerator_infos()) {
    const auto tracer = make_tracer(info.name, mesh);
    std::vector<Hit<double>> hits(rays.size()), precise(rays.size());
    tracer->closest_hits(rays, hits, Level::exact);
    tracer->closest_hits(rays, precise, Level::precise);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(hits[i].t, expected[i].t) << info.name;
      EXPECT_EQ(hits[i].prim_id, expected[i].prim_id) << info.name;
      off += precise[i].t != expected[i].t;
    }
  }
  EXPECT_GT(off, 0u);  // so that the level is one of its own
}

TEST(Tracer, OffersSomethingOnlyByItsName) {
  const std::string message = message_of("kdtree");
  EXPECT_EQ(message.find("unknown accelerator 'kdtree'; expected one of brute-force"), 0u) << message;
  for (const AcceleratorInfo& info : accelerator_infos()) {
    EXPECT_NE(message.find(info.name), std::string::npos) << info.name;
    EXPECT_NE(message_of(info.name, {{{"nonsense", "1"}}}).find("no option 'nonsense'"), std::string::npos);
  }
}

/// Secondary rays start off their surface, on the side they were sent to, and find no hit at their own start.
TEST(Workloads, LeaveTheirSurface) {
  const auto mesh = small_mesh();
  const auto tracer = make_tracer("brute-force", mesh);
  const auto rays = random_rays(mesh->bounds(), 2000, 3);
  std::vector<Hit<float>> hits(rays.size());
  tracer->closest_hits(rays, hits);
  const auto hit_count = std::count_if(hits.begin(), hits.end(), [](const Hit<float>& hit) { return hit.is_hit(); });
  const auto bounced = bounce_rays(*mesh, rays, hits, 4);
  EXPECT_EQ(bounced.size(), std::size_t(hit_count));
  EXPECT_EQ(bounced.front().origin, bounce_rays(*mesh, rays, hits, 4).front().origin);
  std::size_t next = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits[i].is_hit()) continue;
    const Ray<float>& ray = bounced[next++];
    const Triangle from = (*mesh)[hits[i].prim_id];
    const Vec3d normal = glm::cross(Vec3d(from.b) - Vec3d(from.a), Vec3d(from.c) - Vec3d(from.a));
    const double height = glm::dot(normal, Vec3d(ray.origin) - Vec3d(from.a));
    EXPECT_LT(height * glm::dot(normal, Vec3d(rays[i].direction)), 0);
    for (const Hit<float>& hit : tracer->all_hits(ray)) EXPECT_NE(hit.prim_id, hits[i].prim_id);
  }
  const Vec3f light(0, 5, 2);
  const auto shadows = shadow_rays(*mesh, rays, hits, light);
  EXPECT_GT(shadows.size(), 0u);
  for (const Ray<float>& ray : shadows) EXPECT_LT(glm::distance(ray.at(1), light), 1e-5f);
}

}  // namespace
}  // namespace sightline
