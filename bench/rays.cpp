#include "bench/rays.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <random>

#include "sightline/query/workloads.h"
#include "sightline/scene/camera.h"

namespace sightline::bench {
namespace {

/// Point `i` of a lamp above the scene and to the right of the camera, spread by the golden ratio's multiples in two
/// dimensions (Roberts 2018): any number of first points covers the square evenly.
Vec3f lamp_point(const Aabb& bounds, int i) {
  const double plastic = 1.32471795724474602596;
  const double a = std::fmod(i / plastic, 1.0), b = std::fmod(i / (plastic * plastic), 1.0);
  const Vec3d center = 0.5 * (Vec3d(bounds.lo) + Vec3d(bounds.hi));
  const double size = max_norm(Vec3d(bounds.hi) - Vec3d(bounds.lo));
  return Vec3f(center + size * Vec3d(0.5 + 0.5 * a, 1.5, 0.5 + 0.5 * b));
}

/// Rays of make(0), make(1), ... until there are `count`.
template <class Make>
std::vector<Ray<float>> collect(std::size_t count, Make&& make) {
  std::vector<Ray<float>> all;
  for (int i = 0; all.size() < count; ++i) {
    const std::vector<Ray<float>> some = make(i);
    if (some.empty()) break;
    const std::size_t wanted = std::min(some.size(), count - all.size());
    all.insert(all.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(wanted));
  }
  return all;
}

}  // namespace

RaySets make_rays(const TriangleMesh& mesh, std::size_t count, const ClosestHits& closest_hits) {
  const int height = std::max(1, static_cast<int>(std::sqrt(0.75 * static_cast<double>(count))));
  const int width = std::max(1, static_cast<int>(count) / height);
  RaySets sets;
  auto& primary = sets[index_of(Workload::primary)];
  primary = primary_rays(Camera::facing(mesh.bounds(), width, height));
  std::vector<Hit<float>> hits(primary.size());
  closest_hits(primary, hits);
  sets[index_of(Workload::bounce)] = collect(
      primary.size(), [&](int i) { return bounce_rays(mesh, primary, hits, static_cast<std::uint64_t>(i) + 1); });
  sets[index_of(Workload::shadow)] =
      collect(primary.size(), [&](int i) { return shadow_rays(mesh, primary, hits, lamp_point(mesh.bounds(), i)); });
  return sets;
}

std::vector<std::size_t> pick(std::size_t size, std::size_t count) {
  std::vector<std::size_t> all(size), picked;
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::mt19937_64 random(1);
  std::sample(all.begin(), all.end(), std::back_inserter(picked), count, random);
  return picked;
}

}  // namespace sightline::bench
