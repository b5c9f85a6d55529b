/// Rays that go on from a wall: they have to begin beyond its face, and yet within a thin wall.

#include <cmath>

#include "sightline/render/surfaces.h"
#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/families.h"

namespace sightline::hard {
namespace {

/// Between two planes across x, far and wide.
struct Wall {
  double lo, hi;

  /// Doubles are compared as they are.
  enum class Place { before, within, behind };
  Place place(const Vec3d& p) const { return p.x < lo ? Place::before : p.x > hi ? Place::behind : Place::within; }
};

Scene scene_of(SolidTree tree) {
  Scene scene;
  scene.geometries.push_back({"wall", std::move(tree)});
  scene.graph.set_geometry(scene.graph.add(root_node, "wall", {}), 0);
  return scene;
}

void count_places(Tally& tally, const Wall& wall, const Vec3d& before, const Vec3d& within, const Ray<double>& ray) {
  const bool is_right = wall.place(before) == Wall::Place::before && wall.place(within) == Wall::Place::within;
  tally.decide(is_right, [&] {
    return Example{text_of(ray), "one point before the wall, one within",
                   std::string(wall.place(before) == Wall::Place::before ? "before" : "not before") + ", " +
                       (wall.place(within) == Wall::Place::within ? "within" : "not within")};
  });
}

void ask_offsets(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double scale = std::pow(10.0, 11 * random.uniform_double() - 4);
    const double lo = scale * (0.5 + random.uniform_double());
    const Wall wall{lo, lo + std::ldexp(scale, -difficulty)};
    const SolidTree tree(solid::Box{{wall.lo, -4 * scale, -4 * scale}, {wall.hi, 4 * scale, 4 * scale}});
    const Vec3d origin = scale * Vec3d(-0.5, 0, 0) + 0.5 * scale * any_point(random);
    const Ray<double> ray{origin, Vec3d(lo, 0, 0) + scale * Vec3d(0, 1, 1) * any_point(random) - origin};
    const Scene scene = scene_of(tree);
    for (const LevelInfo& level : level_infos) {
      WorldSettings settings;
      settings.level = level.level;
      const TraceWorld world(scene, settings);
      const Surfaces surfaces(scene, world);
      WorldHit hit;
      world.closest_hits(std::span(&ray, 1), std::span(&hit, 1));
      if (!hit.is_hit()) {  // as float has it there is no wall
        trial.of("solid", level.level).decide(false, [&] { return Example{text_of(ray), "a hit", "no hit"}; });
        continue;
      }
      const SurfacePoint at = surfaces.locate(ray, hit);
      count_places(trial.of("solid", level.level), wall, at.beyond(at.outside), at.beyond(-at.outside), ray);
    }
    constexpr float usual = 0.0001f;
    const auto t = static_cast<float>((wall.lo - ray.origin.x) / ray.direction.x);
    const Vec3f point = to_float(ray).at(t), normal(-1, 0, 0);
    count_places(trial.naive("moved by 1e-4 in float"), wall, Vec3d(point + usual * normal),
                 Vec3d(point - usual * normal), ray);
  }
}

}  // namespace

Family offsets() {
  return {
      "offsets",
      "Rays that go on from where one meets a wall, on either side: they begin beyond its face, and within the wall.",
      "a wall of a scene of size s, from 1e-4 to 1e7, is 2^-k s thick",
      "k: wall of 2^-k of the scene",
      2,
      40,
      Oracle::closed_form,
      ask_offsets};
}

}  // namespace sightline::hard
