/// Comparisons of structures: figures against the traversal's own, and what must hold between them.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <sstream>

#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"
#include "viz/compare/compare_camera.h"
#include "viz/compare/compare_data.h"
#include "viz/compare/compare_layout.h"
#include "viz/compare/work_statistics.h"

namespace sightline::viz {
namespace {

using Work = std::vector<std::uint32_t>;

std::vector<Compared> all_structures(const std::string& scene) {
  const auto mesh = load_scene(scene, "");
  std::vector<Compared> all;
  for (const AcceleratorInfo& info : accelerator_infos()) {
    all.push_back({std::string(info.name), make_tracer(info.name, mesh)});
  }
  return all;
}

struct Scene {
  std::vector<Compared> compared;
  CompareFindings findings;
  CompareLook look;
};

Scene found(const std::string& name) {
  Scene scene{all_structures(name), {}, {}};
  const TriangleMesh& mesh = scene.compared.front().tracer->mesh();
  scene.look.ray = ray_across(*scene.compared.front().tracer);
  scene.findings.walks = walks_of(scene.compared, scene.look.ray);
  scene.findings.camera = tracing_camera(camera_for(mesh, scene.look, 1.5), 60, 40);
  for (const Compared& each : scene.compared) {
    scene.findings.traced.push_back(trace_grown(*each.tracer, scene.findings.camera));
  }
  return scene;
}

TEST(Compare, FiguresAreTheTraversals) {
  const Scene scene = found("soup:400");
  for (std::size_t i = 0; i < scene.compared.size(); ++i) {
    const auto& tracer = static_cast<const Queries<float>&>(*scene.compared[i].tracer);
    const auto count = [&](const Ray<float>& ray) {
      TraversalStats stats;
      Hit<float> hit;
      tracer.closest_hits({&ray, 1}, {&hit, 1}, stats);
      return stats;
    };
    EXPECT_EQ(scene.findings.walks[i].statistics(), count(scene.look.ray));
    const Work nodes = work_of(scene.findings.traced[i], WorkKind::nodes);
    const Work candidates = work_of(scene.findings.traced[i], WorkKind::candidates);
    const Work all = work_of(scene.findings.traced[i], WorkKind::all);
    const std::vector<Ray<float>> rays = primary_rays(scene.findings.camera);
    ASSERT_EQ(rays.size(), nodes.size());
    for (std::size_t pixel = 0; pixel < rays.size(); ++pixel) {
      const TraversalStats stats = count(rays[pixel]);
      ASSERT_EQ(nodes[pixel], stats.nodes + stats.leaves) << scene.compared[i].label << ' ' << pixel;
      ASSERT_EQ(candidates[pixel], stats.candidates);
      ASSERT_EQ(all[pixel], nodes[pixel] + candidates[pixel]);
    }
  }
}

TEST(Compare, EveryStepOfAWalkHasACellToDraw) {
  for (const std::string name : {"soup:400", "teapot:4", "sphere-flake:1"}) {
    const std::vector<Compared> compared = all_structures(name);
    for (const Ray<float>& ray : random_rays(compared.front().tracer->mesh().bounds(), 60, 7)) {
      const std::vector<Walk> walks = walks_of(compared, ray);
      for (std::size_t i = 0; i < walks.size(); ++i) {
        for (const WalkStep& step : walks[i].steps) {
          ASSERT_NO_THROW(walks[i].cell_of(step.node)) << name << ' ' << compared[i].label;
          const Cell& cell = walks[i].cells[walks[i].cell_of(step.node)].cell;
          ASSERT_EQ(cell.node, step.node);
          // A cell lies where the ray enters it, but for what floats round.
          const auto* box = std::get_if<Aabb>(&cell.region);
          const bool is_entered = step.kind != WalkStep::Kind::candidate;
          if (compared[i].label != "grid" || !box || cell.depth != 1 || !is_entered) continue;
          const Vec3d at = Vec3d(ray.origin) + step.t * Vec3d(ray.direction);
          const double slack = 1e-4 * max_norm(Vec3d(compared[i].tracer->mesh().bounds().extent()));
          EXPECT_TRUE(glm::all(glm::greaterThanEqual(at, Vec3d(box->lo) - slack)) &&
                      glm::all(glm::lessThanEqual(at, Vec3d(box->hi) + slack)))
              << name << " grid cell " << step.node;
        }
      }
    }
  }
}

TEST(Compare, DifferencesAreAntisymmetric) {
  const Scene scene = found("teapot:4");
  for (const WorkKind kind : work_kinds) {
    const Work a = work_of(scene.findings.traced[1], kind), b = work_of(scene.findings.traced[5], kind);
    const auto there = differences(a, b), back = differences(b, a);
    ASSERT_EQ(there.size(), a.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
      ASSERT_EQ(there[i], -back[i]);
      ASSERT_EQ(static_cast<std::int64_t>(b[i]) + there[i], a[i]);
      ASSERT_EQ(difference_share(double(there[i]), 50), -difference_share(double(back[i]), 50));
    }
    const auto s = statistics_of(std::span<const std::int64_t>(there));
    const auto t = statistics_of(std::span<const std::int64_t>(back));
    EXPECT_EQ(s.less, t.more);
    EXPECT_EQ(s.equal, t.equal);
    EXPECT_EQ(s.total, -t.total);
    EXPECT_EQ(s.median, -t.median);
    EXPECT_EQ(s.rays(), a.size());
    EXPECT_EQ(scale_for(std::span<const std::int64_t>(there)), scale_for(std::span<const std::int64_t>(back)));
    EXPECT_EQ(s.total, std::accumulate(a.begin(), a.end(), std::int64_t(0)) -
                           std::accumulate(b.begin(), b.end(), std::int64_t(0)));
    EXPECT_GT(s.less + s.more, 0u);
  }
  const Work odd{1, 2, 3, 4}, even{0, 0, 0, 0};
  EXPECT_EQ(statistics_of(std::span<const std::int64_t>(differences(odd, even))).median, 2);
  EXPECT_EQ(statistics_of(std::span<const std::int64_t>(differences(even, odd))).median, -2);
  EXPECT_THROW(differences(odd, Work{1}), std::invalid_argument);
}

TEST(Compare, HistogramsCountEveryRayOnce) {
  const Scene scene = found("teapot:4");
  for (const WorkKind kind : work_kinds) {
    std::uint32_t highest = 0;
    for (const TracedPicture& traced : scene.findings.traced) {
      for (const std::uint32_t steps : work_of(traced, kind)) highest = std::max(highest, steps);
    }
    for (const TracedPicture& traced : scene.findings.traced) {
      const Work work = work_of(traced, kind);
      std::uint64_t rays = 0, next = 0;
      for (const HistogramBin& bin : histogram_of(work, highest)) {
        EXPECT_EQ(bin.low, next);  // no gap, no overlap
        EXPECT_LE(bin.low, bin.high);
        EXPECT_EQ(bin.rays, static_cast<std::uint64_t>(std::ranges::count_if(
                                work, [&](std::uint32_t w) { return w >= bin.low && w <= bin.high; })));
        rays += bin.rays;
        next = std::uint64_t(bin.high) + 1;
      }
      EXPECT_EQ(rays, 60u * 40u);
      EXPECT_GT(next, highest);
    }
  }
  EXPECT_THROW(histogram_of(Work{11}, 10), std::invalid_argument);
  EXPECT_EQ(histogram_of(Work{0, 0, 7}, 0xffff'ffffu - 1).front().rays, 2u);  // ends, though the bins' ends overflow
}

TEST(Compare, PercentilesAreNearestRanks) {
  Work work(200);
  std::iota(work.begin(), work.end(), 1u);
  std::ranges::reverse(work);
  const WorkStatistics s = statistics_of(std::span<const std::uint32_t>(work));
  EXPECT_EQ(s.median, 100u);
  EXPECT_EQ(s.percentile_99, 198u);
  EXPECT_EQ(s.highest, 200u);
  EXPECT_EQ(s.total, 20100u);
  EXPECT_DOUBLE_EQ(s.mean(), 100.5);
  EXPECT_EQ(s.idle, 0u);
  const Work half{0, 9, 0, 7, 0, 8, 0, 0};
  const WorkStatistics t = statistics_of(std::span<const std::uint32_t>(half));
  EXPECT_EQ(t.median, 0u);
  EXPECT_EQ(t.idle, 5u);
  EXPECT_EQ(t.busy_median, 8u);
  EXPECT_EQ(statistics_of(std::span<const std::uint32_t>()).rays, 0u);
  EXPECT_EQ(statistics_of(std::span<const std::uint32_t>(Work{5})).percentile_99, 5u);
}

TEST(Compare, TellsWhoDisagrees) {
  Scene scene = found("teapot:4");
  EXPECT_TRUE(verdict_of(scene.compared, scene.findings).is_same) << verdict_of(scene.compared, scene.findings).text;
  // A structure over a mesh without the triangle that the ray hits, and one with pixels of another camera.
  const TriangleMesh& mesh = scene.compared.front().tracer->mesh();
  ASSERT_TRUE(scene.findings.walks.front().hit.is_hit());
  std::vector<TriangleMesh::Corners> triangles(mesh.triangles().begin(), mesh.triangles().end());
  triangles[scene.findings.walks.front().hit.prim_id] = triangles.front();
  const std::shared_ptr<const Tracer> liar =
      make_tracer("bih", std::make_shared<const TriangleMesh>(
                             std::vector<Vec3f>(mesh.positions().begin(), mesh.positions().end()), triangles));
  CompareFindings walks = scene.findings;
  walks.walks[2] = record_walk(*liar, scene.look.ray);
  const Verdict of_walks = verdict_of(scene.compared, walks);
  EXPECT_FALSE(of_walks.is_same);
  EXPECT_TRUE(of_walks.text.starts_with(scene.compared[2].label + " has")) << of_walks.text;
  CompareFindings pixels = scene.findings;
  pixels.traced[3].hits[7].u = -pixels.traced[3].hits[7].u;  // of a miss: a zero of the other sign
  const Verdict of_pixels = verdict_of(scene.compared, pixels);
  EXPECT_FALSE(of_pixels.is_same);
  EXPECT_TRUE(of_pixels.text.starts_with(scene.compared[3].label + " at 1 pixel")) << of_pixels.text;
  const auto json = comparison_json(scene.compared, pixels, scene.look, {"", "teapot:4", {}, {}, {}});
  EXPECT_EQ(json["same_hits"], false);
  EXPECT_EQ(json["structures"][3]["pixels"]["differing_hits"], 1);
}

TEST(Compare, DataHaveEveryFigure) {
  Scene scene = found("teapot:4");
  scene.look.against = 4;
  const auto json = comparison_json(scene.compared, scene.findings, scene.look, {"", "teapot:4", {}, {}, {}});
  EXPECT_EQ(json["against"], scene.compared[4].label);
  EXPECT_EQ(json["same_hits"], true);
  ASSERT_EQ(json["structures"].size(), scene.compared.size());
  for (std::size_t i = 0; i < scene.compared.size(); ++i) {
    const auto& structure = json["structures"][i];
    const TraversalStats stats = scene.findings.walks[i].statistics();
    EXPECT_EQ(structure["label"], scene.compared[i].label);
    EXPECT_EQ(structure["walk"]["nodes"], stats.nodes);
    EXPECT_EQ(structure["walk"]["leaves"], stats.leaves);
    EXPECT_EQ(structure["walk"]["candidates"], stats.candidates);
    EXPECT_EQ(structure["walk"]["culled"], stats.culled);
    EXPECT_EQ(structure["walk"]["hit"]["triangle"], scene.findings.walks[i].hit.prim_id);
    for (const WorkKind kind : work_kinds) {
      const auto& work = structure["pixels"][std::string(name_of(kind))];
      EXPECT_EQ(work["rays"], 60 * 40);
      EXPECT_EQ(work["difference"]["total"].get<std::int64_t>(),
                work["total"].get<std::int64_t>() -
                    json["structures"][4]["pixels"][std::string(name_of(kind))]["total"].get<std::int64_t>());
      std::uint64_t rays = 0;
      for (const auto& bin : work["histogram"]) rays += bin[2].get<std::uint64_t>();
      EXPECT_EQ(rays, 60u * 40u);
    }
  }
  // The same bins as lines.
  std::istringstream csv(histogram_csv(scene.compared, scene.findings));
  std::string line;
  std::uint64_t rays = 0;
  ASSERT_TRUE(std::getline(csv, line));
  EXPECT_EQ(line, "structure,count,from,to,rays");
  while (std::getline(csv, line)) {
    EXPECT_EQ(std::ranges::count(line, ','), 4);
    rays += std::stoull(line.substr(line.rfind(',') + 1));
  }
  EXPECT_EQ(rays, 60u * 40u * scene.compared.size() * std::size(work_kinds));
}

TEST(Compare, PanelsLieWithinThePictureAndApart) {
  for (const auto& [width, height] : {std::pair{960, 540}, {1920, 1080}, {3840, 2160}, {1000, 1900}, {1024, 768}}) {
    for (std::size_t panels = 1; panels <= 6; ++panels) {
      const CompareLayout layout(width, height, panels);
      ASSERT_EQ(layout.pictures().size(), panels);
      for (const PixelFrame& a : layout.pictures()) {
        EXPECT_GE(std::min(a.x, a.y), 0);
        EXPECT_LE(a.x + a.width, width);
        EXPECT_LE(a.y + a.height, height);
        EXPECT_GE(std::min(a.width, a.height), 60) << width << 'x' << height << ' ' << panels;
        EXPECT_EQ(a.width, layout.pictures().front().width);
        EXPECT_EQ(a.height, layout.pictures().front().height);
        for (const PixelFrame& b : layout.pictures()) {
          const bool is_same = a.x == b.x && a.y == b.y;
          EXPECT_TRUE(is_same || a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y ||
                      b.y + b.height <= a.y);
        }
      }
    }
  }
}

TEST(Compare, TracedPixelsAreWhereTheDrawnOnesAre) {
  const auto mesh = load_scene("teapot:4", "");
  const SpaceCamera drawn = camera_for(*mesh, {}, 1.5);
  const Camera traced = tracing_camera(drawn, 300, 200);
  for (const auto& [x, y] : {std::pair{0, 0}, {299, 0}, {150, 100}, {17, 199}}) {
    const Ray<float> ray = traced.ray(x, y);
    const auto seen = drawn.project(Vec3d(ray.origin) + 3.0 * Vec3d(ray.direction));
    ASSERT_TRUE(seen);
    EXPECT_NEAR((seen->x + 1) * 150, x + 0.5, 1e-2);  // pixels: rays are of float
    EXPECT_NEAR((1 - seen->y) * 100, y + 0.5, 1e-2);
  }
}

}  // namespace
}  // namespace sightline::viz
