#include "sightline/accel/bsp_tree.h"

#include <stdexcept>

#include "bench/claims/course.h"
#include "bench/claims/rules.h"
#include "bench/claims/tools.h"
#include "sightline/query/primitives_of.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

/// Floating-point operations of a step, counted in BspTree::traverse. General: 3 + 2 products with one that is 1 in
/// origin and slope (2 (2 * + 2 +)), the offset, a division, both widths and both products. Axis: two of - and *.
/// A textbook's, without margins, takes 12 and 2.
constexpr double general_operations = 14, axis_operations = 4;
/// Of a treelet of the kd-tree: seven planes at once, entered and left.
constexpr double treelet_operations = 7 * axis_operations;

struct Steps {
  std::vector<std::uint8_t> kind;  ///< By number of node.
  enum Kind : std::uint8_t { none, axis, general, no_step };
  std::uint64_t counts[4] = {};

  void node(std::uint32_t node, double) { ++counts[kind[node]]; }
  void leaf(std::uint32_t, LeafRange, double) {}
  void cull(std::uint32_t, double) {}
  double all() const { return static_cast<double>(counts[axis] + counts[general]); }
  double operations() const {
    return general_operations * static_cast<double>(counts[general]) +
           axis_operations * static_cast<double>(counts[axis]);
  }
};

/// A general plane takes two words, so that the child below is not the next one.
Steps steps_of(const BspTree& tree) {
  Steps steps;
  std::vector<std::uint32_t> inner;
  const auto set = [&](std::uint32_t node, Steps::Kind kind) {
    if (node >= steps.kind.size()) steps.kind.resize(node + 2, Steps::none);
    steps.kind[node] = kind;
  };
  tree.for_each_cell([&](const Cell& cell) {
    set(cell.node, Steps::no_step);
    if (!cell.is_leaf) inner.push_back(cell.node);
  });
  std::vector<std::uint8_t> is_axis;
  for (const std::uint32_t node : inner) is_axis.push_back(steps.kind[node + 1] != Steps::none);
  for (std::size_t i = 0; i < inner.size(); ++i) set(inner[i], is_axis[i] ? Steps::axis : Steps::general);
  return steps;
}

/// Each ray as far as its hit, so that a walk alone goes the way of a query.
std::vector<Ray<float>> ended_at_hits(const Tracer& tracer, std::vector<Ray<float>> rays) {
  std::vector<Hit<float>> hits(rays.size());
  tracer.closest_hits(std::span<const Ray<float>>(rays), std::span(hits));
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i].t_max = std::min(rays[i].t_max, hits[i].t);
  return rays;
}

template <class Probe>
double walk(const BspTree& tree, const std::vector<Ray<float>>& rays, Probe& probe) {
  double leaves = 0;
  for (const Ray<float>& ray : rays) {
    tree.traverse(
        ray,
        [&](LeafRange) {
          ++leaves;
          return ray.t_max;
        },
        probe);
  }
  return leaves;
}

void measure_scene(const Effort& effort, const std::string& scene, Finding& finding,
                   std::vector<Condition>& conditions) {
  effort.say(scene);
  const MeshPtr mesh = load_scene(scene, effort.data_dir);
  const auto rays = mixed_rays(mesh, effort.count(20'000, 4'000), effort.seed);
  const std::vector<TracerPtr> tracers{traced("bsp-tree", mesh), traced("bsp-tree:general_planes=false", mesh),
                                       traced("kd-tree", mesh)};
  require_same_hits(scene, tracers, rays);
  const auto ended = ended_at_hits(*tracers[0], rays);
  const PrimitivesOf primitives(*mesh);
  BspTreeOptions axis_only;
  axis_only.general_planes = false;
  const BspTree trees[] = {BspTree::build(primitives), BspTree::build(primitives, axis_only)};
  Steps steps[] = {steps_of(trees[0]), steps_of(trees[1])};
  std::vector<Line> lines;
  for (int i = 0; i < 2; ++i) {
    walk(trees[i], ended, steps[i]);
    lines.push_back({[&ended, &tree = trees[i]] {
                       NoProbe probe;
                       return walk(tree, ended, probe);
                     },
                     steps[i].all()});
  }
  if (steps[1].counts[Steps::general] > 0)
    throw std::logic_error("bsp_cost: an axis plane was taken for a general one");
  for (const TracerPtr& tracer : tracers) lines.push_back(ray_line(tracer, rays));
  const Times times = time_lines(effort, scene, lines);

  const double per_ray = 1 / static_cast<double>(rays.size());
  const double kd_operations = treelet_operations * work_of(*tracers[2], ended).nodes;
  const Figure operations =
      exact_figure(scene + ": operations a step, bsp-tree over axis planes only",
                   (steps[0].operations() / steps[0].all()) / (steps[1].operations() / steps[1].all()), "x");
  const Figure step{scene + ": time of a step, bsp-tree over axis planes only", times.ratio(0, 1), "x"};
  const Figure ray{scene + ": time of a ray, bsp-tree over axis planes only", times.ratio(2, 3), "x"};
  finding.figures.push_back(exact_figure(scene + ": steps at general planes",
                                         100 * static_cast<double>(steps[0].counts[Steps::general]) / steps[0].all(),
                                         "%"));
  finding.figures.push_back(exact_figure(scene + ": steps a ray, bsp-tree", per_ray * steps[0].all()));
  finding.figures.push_back(exact_figure(scene + ": steps a ray, axis planes only", per_ray * steps[1].all()));
  finding.figures.push_back(exact_figure(scene + ": operations a ray, bsp-tree", per_ray * steps[0].operations()));
  finding.figures.push_back(
      exact_figure(scene + ": operations a ray, axis planes only", per_ray * steps[1].operations()));
  finding.figures.push_back(exact_figure(scene + ": operations a ray, kd-tree, eight cells at once", kd_operations));
  finding.figures.push_back(operations);
  finding.figures.push_back({scene + ": a step, bsp-tree", times.nanoseconds(0), "ns"});
  finding.figures.push_back({scene + ": a step, axis planes only", times.nanoseconds(1), "ns"});
  finding.figures.push_back(step);
  finding.figures.push_back({scene + ": a ray, bsp-tree", times.nanoseconds(2), "ns"});
  finding.figures.push_back(ray);
  finding.figures.push_back({scene + ": time of a ray, bsp-tree over kd-tree", times.ratio(2, 4), "x"});
  conditions.push_back({Condition::Kind::needed, operations, Side::above, 1});
  conditions.push_back({Condition::Kind::needed, step, Side::above, 1});
  conditions.push_back({Condition::Kind::wanted, ray, Side::above, 1});
}

Finding measure_bsp_cost(const Effort& effort) {
  Finding finding;
  std::vector<Condition> conditions;
  const auto size = [&](std::size_t full, std::size_t quick) { return std::to_string(effort.count(full, quick)); };
  on_one_thread([&] {
    measure_scene(effort, "teapot:" + size(16, 8), finding, conditions);
    measure_scene(effort, "terrain:" + size(100, 40), finding, conditions);
    measure_scene(effort, "sticks:" + size(20'000, 3'000), finding, conditions);
  });
  conclude(finding, conditions,
           "Each step takes more, but where few planes do the work of many, a whole ray "
           "takes less");
  return finding;
}

}  // namespace

const Claim bsp_cost_claim{
    "bsp_cost", "BSP planes are heavy on floating point.",
    "The same tree built with planes of any orientation (those that pay; the rest are axis planes) and with axis "
    "planes only, which makes it a kd-tree. Operations are counted along the walks (14 at a general plane, one of them "
    "a division; 4 at an axis plane), steps are timed in walks that test no triangle, rays in whole queries.",
    "Holds if on every scene a step takes more operations and more time than among axis planes, and so does a whole "
    "ray more time; holds with a limit if only the steps do.",
    measure_bsp_cost};

}  // namespace sightline::bench
