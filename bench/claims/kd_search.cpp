#include <cmath>

#include "bench/claims/course.h"
#include "bench/claims/point_tree.h"
#include "bench/claims/rules.h"
#include "bench/claims/tools.h"
#include "sightline/math/random.h"

namespace sightline::bench {
namespace {

constexpr double two_thirds = 2 / 3.0, slack = 0.05;

template <int dimensions>
std::vector<std::array<float, dimensions>> random_points(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::array<float, dimensions>> points(count);
  for (auto& point : points) {
    for (float& x : point) x = random.uniform();
  }
  return points;
}

/// Mean of nodes visited, without those that are reported, by ranges that are `thickness` thin along one axis and
/// unbounded along the others: along every axis as many.
template <int dimensions>
double visited_by_slabs(const PointTree<dimensions>& tree, double thickness, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, dimensions> lo, hi;
    lo.fill(0), hi.fill(1);
    const std::size_t axis = i % dimensions;
    lo[axis] = random.uniform();
    hi[axis] = lo[axis] + static_cast<float>(thickness);
    const auto found = tree.search(lo, hi);
    sum += static_cast<double>(found.visited - found.reported);
  }
  return sum / static_cast<double>(count);
}

/// By cubes that hold eight points on average.
double visited_by_cubes(const PointTree<3>& tree, std::size_t size, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const auto side = static_cast<float>(std::min(1.0, std::cbrt(8 / static_cast<double>(size))));
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 3> lo, hi;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lo[axis] = (1 - side) * random.uniform();
      hi[axis] = lo[axis] + side;
    }
    sum += static_cast<double>(tree.search(lo, hi).visited);
  }
  return sum / static_cast<double>(count);
}

struct RangeGrowths {
  Growth planes, slabs, grown, flat, cubes;
};

/// Whole turns of the axes, 8^k - 1 points, because between them the count swings about its power law.
RangeGrowths measure_ranges(const Effort& effort) {
  const std::size_t limit = effort.count(1 << 21, 1 << 18), searches = effort.count(96, 48) * 3;
  std::vector<double> x, planes, slabs, grown, flat, cubes;
  for (std::size_t size = 63; size < limit; size = 8 * size + 7) {
    if (size < 500 && limit > 4096) continue;
    effort.say("ranges of " + std::to_string(size) + " points");
    const auto points = random_points<3>(size, effort.seed);
    const auto tree = PointTree<3>::balanced(points);
    PointTree<3> inserted;
    for (const auto& point : points) inserted.insert(point);
    x.push_back(static_cast<double>(size));
    planes.push_back(visited_by_slabs(tree, 0, searches, effort.seed));
    slabs.push_back(visited_by_slabs(tree, 1 / std::cbrt(x.back()), searches, effort.seed));
    grown.push_back(visited_by_slabs(inserted, 0, searches, effort.seed));
    flat.push_back(
        visited_by_slabs(PointTree<2>::balanced(random_points<2>(size, effort.seed)), 0, searches, effort.seed));
    cubes.push_back(visited_by_cubes(tree, size, searches, effort.seed));
  }
  return {growth_of("nodes visited, plane through points in space", "points", "", x, planes, "range search"),
          growth_of("nodes visited, slab as thick as points are apart", "points", "", x, slabs, "range search"),
          growth_of("nodes visited, plane, points inserted at random", "points", "", x, grown, "range search"),
          growth_of("nodes visited, line through points in a plane", "points", "", x, flat, "range search"),
          growth_of("nodes visited, cube of eight points", "points", "", x, cubes, "range search")};
}

/// Nodes and leaves, candidates, and time.
std::vector<Growth> measure_rays(const Effort& effort, const std::string& family) {
  std::vector<double> x, steps, candidates, times;
  for (const std::size_t size : growing_sizes(effort, 1'000'000, 100'000)) {
    effort.say(family + " of " + std::to_string(size));
    const MeshPtr mesh = mesh_of(family, size);
    const auto rays = mixed_rays(mesh, effort.count(10'000, 2'000), effort.seed);
    const std::vector<TracerPtr> tracers{traced("kd-tree", mesh), traced("box-tree", mesh)};
    require_same_hits(family, tracers, rays);
    const Work work = work_of(*tracers[0], rays);
    x.push_back(mesh->size());
    steps.push_back(work.nodes + work.leaves);
    candidates.push_back(work.candidates);
    const Line line = ray_line(tracers[0], rays);
    times.push_back(time_lines(effort, family, std::span(&line, 1)).nanoseconds(0).median);
  }
  return {growth_of("nodes and leaves a ray, " + family, "triangles", "", x, steps, "rays: steps and candidates"),
          growth_of("candidates a ray, " + family, "triangles", "", x, candidates, "rays: steps and candidates"),
          growth_of("time a ray, " + family, "triangles", "ns", x, times, "rays: time")};
}

Finding measure_kd_search(const Effort& effort) {
  using enum Condition::Kind;
  Finding finding;
  std::vector<Condition> conditions;
  const auto add = [&](const Growth& growth) {
    finding.growths.push_back(growth);
    finding.figures.push_back({"exponent of " + growth.name, exponent_of(growth), ""});
    return finding.figures.back();
  };
  const RangeGrowths ranges = measure_ranges(effort);
  for (const Growth* growth : {&ranges.planes, &ranges.slabs}) {
    const Figure figure = add(*growth);
    conditions.push_back({needed, figure, Side::below, two_thirds + slack});
    conditions.push_back({needed, figure, Side::above, two_thirds - slack});
  }
  for (const Growth* growth : {&ranges.grown, &ranges.flat, &ranges.cubes}) add(*growth);
  on_one_thread([&] {
    for (const char* family : {"terrain", "soup"}) {
      const auto growths = measure_rays(effort, family);
      for (const Growth& growth : growths) {
        const Figure figure = add(growth);
        conditions.push_back({needed, figure, Side::below, two_thirds + slack});
        if (&growth == &growths[0]) conditions.push_back({wanted, figure, Side::above, two_thirds - slack});
      }
    }
  });
  conclude(finding, conditions, "It is the bound of range search, and tight there; rays stay far below it");
  return finding;
}

}  // namespace

const Claim kd_search_claim{
    "kd_search", "Searching a kd-tree is O(n^(2/3)).",
    "The bound is that of range search, O(n^(1 - 1/d) + k) for k points found in d dimensions (Lee and Wong 1977), and "
    "says nothing of rays. Measured are both: a textbook's kd-tree of random points, asked for planes, slabs and cubes "
    "(nodes visited, without points found); and rays through the library's kd-tree over a landscape and random "
    "triangles of 1000 to 1,000,000 (quick: 100,000): nodes, candidates, processor time.",
    "Holds if planes and slabs grow with an exponent within 0.05 of 2/3, and so do nodes a ray; holds with a limit if "
    "rays stay below that.",
    measure_kd_search};

}  // namespace sightline::bench
