#include "bench/torus/rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace sightline::bench {
namespace {

class Source {
 public:
  explicit Source(const Torus& torus) : torus_(torus) {}

  double unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  Vec3d direction() {
    std::normal_distribution<double> normal;
    const Vec3d v(normal(random_), normal(random_), normal(random_));
    return v == Vec3d(0) ? Vec3d(0, 0, 1) : glm::normalize(v);
  }

  /// From a sphere of radius 4 through any point near the torus.
  Ray<double> through_sphere() {
    const double reach = torus_.major + torus_.minor;
    for (;;) {
      Ray<double> ray{4.0 * direction(), {}};
      ray.direction = (reach * std::cbrt(unit()) * direction() - ray.origin) * (0.5 + unit());
      const Vec3d across = glm::cross(ray.origin, ray.direction);
      if (glm::length(across) < reach * glm::length(ray.direction)) return ray;
    }
  }

  /// Along the surface, by 2^-10 to 2^-50 beside it.
  Ray<double> along_surface() {
    const double u = 2 * std::numbers::pi * unit(), v = 2 * std::numbers::pi * unit();
    const Vec3d out(std::cos(u), std::sin(u), 0), normal = std::cos(v) * out + std::sin(v) * Vec3d(0, 0, 1);
    const Vec3d any = direction(), along = any - glm::dot(any, normal) * normal;
    const double aside = std::ldexp(unit() < 0.5 ? -1 : 1, -10 - static_cast<int>(40 * unit()));
    return {torus_.major * out + (torus_.minor + aside) * normal - 4.0 * along, along};
  }

  bool is_hit(const Ray<double>& ray) const { return torus_roots(torus_, ray, Level::precise).count > 0; }

 private:
  const Torus& torus_;
  std::mt19937_64 random_{7};
};

}  // namespace

std::vector<TorusRays> torus_rays(const Torus& torus, std::size_t count) {
  Source source(torus);
  std::vector<TorusRays> sets{{"mixed", "every second meets the torus", {}},
                              {"hits", "all meet the torus", {}},
                              {"grazing", "along the surface, by 2^-10 to 2^-50 inside or outside of it", {}}};
  std::vector<Ray<double>>&mixed = sets[0].rays, &hits = sets[1].rays, &grazing = sets[2].rays;
  std::size_t misses = 0;
  while (mixed.size() < count || hits.size() < count) {
    const Ray<double> ray = source.through_sphere();
    const bool is_hit = source.is_hit(ray);
    const std::size_t half = is_hit ? mixed.size() - misses : misses;
    if (mixed.size() < count && half < (count + 1) / 2) {
      mixed.push_back(ray);
      misses += !is_hit;
    } else if (is_hit && hits.size() < count) {
      hits.push_back(ray);
    }
  }
  std::mt19937_64 random(11);  // so that no branch can be told from the order
  std::shuffle(mixed.begin(), mixed.end(), random);
  while (grazing.size() < (count + 9) / 10) grazing.push_back(source.along_surface());
  return sets;
}

}  // namespace sightline::bench
