#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bench/claims/course.h"
#include "bench/claims/rules.h"
#include "bench/claims/tools.h"
#include "sightline/accel/bounding_box.h"
#include "sightline/accel/bounding_cylinder.h"
#include "sightline/accel/bounding_sphere.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

constexpr std::size_t group_size = 8;
constexpr double pi = std::numbers::pi;

double area_of(const Aabb& box) { return 2 * half_area(box); }
double area_of(const Sphere& ball) { return 4 * pi * double(ball.radius) * ball.radius; }
double area_of(const Cylinder& c) { return 2 * pi * double(c.radius) * (double(c.radius) + 2 * double(c.half_length)); }

/// Eight triangles that lie side by side, and the volumes around them.
struct Groups {
  std::vector<std::uint32_t> order;
  std::vector<Aabb> boxes;
  std::vector<BoundingBox> box_volumes;
  std::vector<BoundingSphere> balls;
  std::vector<BoundingCylinder> cylinders;
};

Groups groups_of(const TriangleMesh& mesh, std::span<const std::uint32_t> order) {
  Groups groups;
  groups.order.assign(order.begin(), order.end());
  for (std::size_t first = 0; first < order.size(); first += group_size) {
    Aabb box;
    std::vector<Vec3f> points;
    for (std::size_t i = first; i < std::min(first + group_size, order.size()); ++i) {
      const Triangle triangle = mesh[order[i]];
      for (const Vec3f& p : {triangle.a, triangle.b, triangle.c}) box.extend(p), points.push_back(p);
    }
    groups.boxes.push_back(box);
    groups.box_volumes.push_back(BoundingBox::around(box, points));
    groups.balls.push_back(BoundingSphere::around(box, points));
    groups.cylinders.push_back(BoundingCylinder::around(box, points));
  }
  return groups;
}

struct UnitRay {
  Vec3f origin, direction, inverse;
};

/// A textbook's: whether the ray comes as near to the center as the radius.
bool meets(const UnitRay& ray, const Sphere& ball) {
  const Vec3f to = ball.center - ray.origin;
  const float along = glm::dot(to, ray.direction), far2 = glm::dot(to, to), radius2 = ball.radius * ball.radius;
  return (far2 - along * along <= radius2) & ((along >= 0) | (far2 <= radius2));
}

/// Kay and Kajiya's slabs, "Ray Tracing Complex Scenes", 1986.
bool meets(const UnitRay& ray, const Aabb& box) {
  const Vec3f to_lo = (box.lo - ray.origin) * ray.inverse, to_hi = (box.hi - ray.origin) * ray.inverse;
  const Vec3f near = glm::min(to_lo, to_hi), far = glm::max(to_lo, to_hi);
  const auto larger = [](float a, float b) { return a > b ? a : b; };
  const auto smaller = [](float a, float b) { return a < b ? a : b; };
  return larger(larger(near.x, near.y), larger(near.z, 0)) <= smaller(smaller(far.x, far.y), far.z);
}

/// One after the other, as a tree would: without the barrier compilers test eight balls at once, but no boxes.
template <class Volume>
Line textbook_line(const std::vector<UnitRay>& rays, const std::vector<Volume>& volumes) {
  return {[&rays, volumes] {
            std::size_t met = 0;
            for (const UnitRay& ray : rays) {
              for (const Volume& volume : volumes) {
                met += meets(ray, volume);
                benchmark::DoNotOptimize(met);
              }
            }
            return static_cast<double>(met);
          },
          static_cast<double>(rays.size() * volumes.size())};
}

/// As a tree tests them, two at a time, with the margins that keep hits exact.
template <class Volume>
Line library_line(const std::vector<Ray<float>>& rays, const Aabb& bounds, const std::vector<Volume>& volumes) {
  return {[&rays, &volumes, bounds] {
            std::size_t met = 0;
            for (const Ray<float>& ray : rays) {
              const PaddedRay<float> padded(ray, bounds);
              const typename Volume::template Test<float> test(padded);
              for (std::size_t i = 0; i + 1 < volumes.size(); i += 2) {
                const auto [first, second] = test(volumes[i], volumes[i + 1], padded.t_max);
                met += !first.is_empty();
                met += !second.is_empty();
              }
            }
            return static_cast<double>(met);
          },
          static_cast<double>(rays.size() * (volumes.size() / 2 * 2))};
}

bool meets_any(const TriangleMesh& mesh, const TriangleRay& test, const Groups& groups, std::size_t group) {
  Crossing crossing;
  const std::size_t end = std::min(groups.order.size(), (group + 1) * group_size);
  for (std::size_t i = group * group_size; i < end; ++i) {
    if (test.intersect(mesh[groups.order[i]], crossing) && crossing.t > 0) return true;
  }
  return false;
}

/// Rays that are let into a volume although they meet none of its triangles, a ray.
template <class Volume>
double vain_passes(const TriangleMesh& mesh, std::span<const Ray<float>> rays, const Groups& groups,
                   const std::vector<Volume>& volumes) {
  std::size_t vain = 0;
  for (const Ray<float>& ray : rays) {
    const PaddedRay<float> padded(ray, mesh.bounds());
    const typename Volume::template Test<float> test(padded);
    const TriangleRay exact = mesh.prepare(to_double(ray));
    for (std::size_t g = 0; g < volumes.size(); ++g) {
      const bool passes = !test(volumes[g], volumes[g], padded.t_max).first.is_empty();
      vain += passes && !meets_any(mesh, exact, groups, g);
    }
  }
  return static_cast<double>(vain) / static_cast<double>(rays.size());
}

template <class Volume>
double mean_area(const std::vector<Volume>& volumes) {
  double sum = 0;
  for (const Volume& volume : volumes) sum += area_of(volume.region());
  return sum / static_cast<double>(volumes.size());
}

std::vector<UnitRay> unit_rays(std::span<const Ray<float>> rays) {
  std::vector<UnitRay> units;
  for (const Ray<float>& ray : rays) {
    const Vec3f direction = glm::normalize(ray.direction);
    units.push_back({ray.origin, direction, 1.0f / direction});
  }
  return units;
}

void measure_scene(const Effort& effort, const std::string& scene, Finding& finding,
                   std::vector<Condition>& conditions) {
  effort.say(scene);
  const MeshPtr mesh = load_scene(scene, effort.data_dir);
  const auto rays = mixed_rays(mesh, effort.count(20'000, 4'000), effort.seed);
  const std::vector<Ray<float>> few(rays.begin(), rays.begin() + static_cast<std::ptrdiff_t>(rays.size() / 20 + 1));
  const std::vector<TracerPtr> trees{traced("sphere-tree", mesh), traced("box-tree", mesh),
                                     traced("cylinder-tree", mesh)};
  require_same_hits(scene, trees, rays);
  const Groups groups = groups_of(*mesh, trees[1]->leaf_order());
  const std::vector<UnitRay> units = unit_rays(few);
  std::vector<Sphere> balls;
  for (const BoundingSphere& volume : groups.balls) balls.push_back(volume.ball);
  const std::vector<Line> lines{textbook_line(units, balls),
                                textbook_line(units, groups.boxes),
                                library_line(few, mesh->bounds(), groups.balls),
                                library_line(few, mesh->bounds(), groups.box_volumes),
                                library_line(few, mesh->bounds(), groups.cylinders),
                                ray_line(trees[0], rays),
                                ray_line(trees[1], rays),
                                ray_line(trees[2], rays)};
  const Times times = time_lines(effort, scene, lines);
  const double ball_vain = vain_passes(*mesh, few, groups, groups.balls);
  const double box_vain = vain_passes(*mesh, few, groups, groups.box_volumes);
  const double cylinder_vain = vain_passes(*mesh, few, groups, groups.cylinders);
  const double box_area = mean_area(groups.box_volumes);

  const Figure test{scene + ": time of a textbook's test, box over ball", times.ratio(1, 0), "x"};
  const Figure vain = exact_figure(scene + ": passed in vain, balls over boxes", ball_vain / box_vain, "x");
  const Figure ray{scene + ": time of a ray, box-tree over sphere-tree", times.ratio(6, 5), "x"};
  finding.figures.insert(
      finding.figures.end(),
      {{scene + ": a textbook's test of a ball", times.nanoseconds(0), "ns"},
       {scene + ": a textbook's test of a box", times.nanoseconds(1), "ns"},
       test,
       {scene + ": time of the library's test, box over ball", times.ratio(3, 2), "x"},
       {scene + ": time of the library's test, box over cylinder", times.ratio(3, 4), "x"},
       exact_figure(scene + ": surface of balls over boxes", mean_area(groups.balls) / box_area, "x"),
       exact_figure(scene + ": surface of cylinders over boxes", mean_area(groups.cylinders) / box_area, "x"),
       vain,
       exact_figure(scene + ": passed in vain, cylinders over boxes", cylinder_vain / box_vain, "x"),
       exact_figure(scene + ": nodes a ray, sphere-tree", work_of(*trees[0], rays).nodes),
       exact_figure(scene + ": nodes a ray, box-tree", work_of(*trees[1], rays).nodes),
       exact_figure(scene + ": nodes a ray, cylinder-tree", work_of(*trees[2], rays).nodes),
       exact_figure(scene + ": candidates a ray, sphere-tree", work_of(*trees[0], rays).candidates),
       exact_figure(scene + ": candidates a ray, box-tree", work_of(*trees[1], rays).candidates),
       exact_figure(scene + ": candidates a ray, cylinder-tree", work_of(*trees[2], rays).candidates),
       {scene + ": a ray, sphere-tree", times.nanoseconds(5), "ns"},
       ray,
       {scene + ": time of a ray, box-tree over cylinder-tree", times.ratio(6, 7), "x"}});
  conditions.push_back({Condition::Kind::needed, test, Side::above, 1});
  conditions.push_back({Condition::Kind::needed, vain, Side::above, 1});
  conditions.push_back({Condition::Kind::wanted, ray, Side::above, 1});
}

Finding measure_bounding_spheres(const Effort& effort) {
  Finding finding;
  std::vector<Condition> conditions;
  const auto size = [&](std::size_t full, std::size_t quick) { return std::to_string(effort.count(full, quick)); };
  on_one_thread([&] {
    measure_scene(effort, "teapot:" + size(16, 8), finding, conditions);
    measure_scene(effort, "terrain:" + size(100, 40), finding, conditions);
    measure_scene(effort, "soup:" + size(10'000, 3'000), finding, conditions);
    measure_scene(effort, "sticks:" + size(5'000, 1'000), finding, conditions);
  });
  conclude(finding, conditions, "The test alone is fast and lets more in, but whole rays take longer");
  return finding;
}

}  // namespace

const Claim bounding_spheres_claim{
    "bounding_spheres", "Bounding spheres trade accuracy for fast tests.",
    "Balls, boxes and cylinders around the same groups of eight neighbouring triangles: nanoseconds of a textbook's "
    "test in float and of the library's, which loses no hit; surfaces; rays let in although they meet none of the "
    "eight. Then whole rays through the three trees, whose hits are the same.",
    "Holds if on every scene a textbook's test of a ball takes less time than one of a box, balls let more rays in "
    "in vain, and whole rays are faster as well; holds with a limit if only the first two are so.",
    measure_bounding_spheres};

}  // namespace sightline::bench
