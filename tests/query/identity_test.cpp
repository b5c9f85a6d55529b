/// Every structure of the registry gives the hits of brute force, bit for bit, on a scanned mesh.

#include <gtest/gtest.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "sightline/query/tracer.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"

namespace sightline {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t ray_count = 1500;  // sanitizers look for other faults, at thirty times the time
#else
constexpr std::size_t ray_count = 100'000;
#endif

/// The Stanford dragon of 47,794 triangles; without it a finely divided teapot.
std::shared_ptr<const TriangleMesh> mesh_to_trace() {
  try {
    return load_scene("dragon:3", SIGHTLINE_SOURCE_DIR "/data");
  } catch (const std::runtime_error& error) {
    std::printf("%s\nThe teapot stands in.\n", error.what());
    return load_scene("teapot:27", SIGHTLINE_SOURCE_DIR "/data");
  }
}

template <class T>
std::vector<Hit<T>> trace(const Tracer& tracer, const std::vector<Ray<T>>& rays) {
  std::vector<Hit<T>> hits(rays.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 256), [&](const auto& part) {
    tracer.closest_hits(std::span(rays).subspan(part.begin(), part.size()),
                        std::span(hits).subspan(part.begin(), part.size()));
  });
  return hits;
}

template <class T>
std::vector<std::uint8_t> trace_any(const Tracer& tracer, const std::vector<Ray<T>>& rays) {
  std::vector<std::uint8_t> is_hit(rays.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 256), [&](const auto& part) {
    tracer.any_hits(std::span(rays).subspan(part.begin(), part.size()),
                    std::span(is_hit).subspan(part.begin(), part.size()));
  });
  return is_hit;
}

template <class T>
void expect_identical(const Tracer& tracer, const std::vector<Ray<T>>& rays, const std::vector<Hit<T>>& expected,
                      const std::string& what) {
  const auto hits = trace(tracer, rays);
  const auto is_hit = trace_any(tracer, rays);
  std::size_t wrong = 0, wrong_any = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    wrong += hits[i] != expected[i];
    wrong_any += (is_hit[i] == 1) != expected[i].is_hit();
  }
  EXPECT_EQ(wrong, 0u) << what << ": closest hits, of " << rays.size();
  EXPECT_EQ(wrong_any, 0u) << what << ": any hits, of " << rays.size();
}

TEST(Identity, OfEveryStructureWithBruteForce) {
  const auto mesh = mesh_to_trace();
  const auto brute = make_tracer("brute-force", mesh);

  // A third each: random, diffusely bounced, aimed at edges and corners.
  std::vector<Ray<float>> rays = random_rays(mesh->bounds(), ray_count / 3, 1);
  const auto at_edges = edge_rays(*mesh, ray_count / 3, 2);
  const auto bounced = bounce_rays(*mesh, at_edges, trace(*brute, at_edges), 3);
  ASSERT_GT(bounced.size(), ray_count / 4);
  rays.insert(rays.end(), at_edges.begin(), at_edges.end());
  rays.insert(rays.end(), bounced.begin(), bounced.end());
  const auto more = random_rays(mesh->bounds(), ray_count - rays.size(), 4);
  rays.insert(rays.end(), more.begin(), more.end());

  std::vector<Ray<double>> wide_rays;
  for (const Ray<float>& ray : rays) {
    wide_rays.push_back(to_double(ray));
    // Off the float grid, by less than float can tell.
    wide_rays.back().origin *= 1 + 0x1p-40;
    wide_rays.back().direction *= 1 - 0x1p-45;
  }
  const auto expected = trace(*brute, rays);
  const auto wide_expected = trace(*brute, wide_rays);

  for (const AcceleratorInfo& info : accelerator_infos()) {
    const std::string name(info.name);
    if (info.name == brute->name()) continue;
    for (const int threads : {1, 2}) {
      const auto tracer = make_tracer(name, mesh, {.options = {}, .threads = threads});
      const std::string built = ", built by " + std::to_string(threads);
      expect_identical(*tracer, rays, expected, name + ", float" + built);
      expect_identical(*tracer, wide_rays, wide_expected, name + ", double" + built);
    }
    for (const auto& option : info.options) {
      if (option.name != "lazy") continue;
      const TracerSettings lazy{.options = {{"lazy", "true"}}};
      expect_identical(*make_tracer(name, mesh, lazy), rays, expected, name + ", lazy, float");
      expect_identical(*make_tracer(name, mesh, lazy), wide_rays, wide_expected, name + ", lazy, double");
    }
  }
}

}  // namespace
}  // namespace sightline
