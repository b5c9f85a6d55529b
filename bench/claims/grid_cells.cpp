#include <algorithm>
#include <cmath>
#include <sstream>

#include "bench/claims/course.h"
#include "bench/claims/rules.h"
#include "bench/claims/tools.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

/// Cells wanted for each triangle, from too few to too many.
constexpr double densities[] = {0.001, 0.004, 0.016, 0.06, 0.25, 1, 4, 16, 64};

struct Shape {
  double cells, empty_share, references, bytes;  ///< References and bytes of each triangle.
  int depth;
};

std::size_t bytes_of_cell() {
  const auto infos = accelerator_infos();
  return std::ranges::find(infos, std::string_view("grid"), &AcceleratorInfo::name)->node_bytes;
}

/// Of one level, where memory is cells and references.
Shape shape_of(const Tracer& tracer) {
  const double triangles = std::max<double>(1, tracer.mesh().size());
  Shape shape{0, 0, 0, static_cast<double>(tracer.structure_bytes() + tracer.leaf_bytes()) / triangles, 0};
  double full = 0, references = 0;
  tracer.for_each_cell([&](const Cell& cell) {
    shape.depth = std::max(shape.depth, cell.depth);
    full += cell.is_leaf;
    references += cell.range.count;
  });
  shape.references = references / triangles;
  shape.cells = static_cast<double>(tracer.structure_bytes() - tracer.leaf_order().size_bytes()) /
                static_cast<double>(bytes_of_cell());
  shape.empty_share = 1 - full / shape.cells;
  return shape;
}

std::string spec_of(double density) {
  std::ostringstream text;
  text << "grid:max_copies=1,density=" << density;
  return text.str();
}

void measure_scene(const Effort& effort, const std::string& scene, Finding& finding,
                   std::vector<Condition>& conditions) {
  effort.say(scene);
  const MeshPtr mesh = load_scene(scene, effort.data_dir);
  const auto rays = mixed_rays(mesh, effort.count(10'000, 1'500), effort.seed);
  std::vector<double> x;
  std::vector<TracerPtr> grids;
  std::vector<Shape> shapes;
  for (const double density : densities) {
    const TracerPtr grid = traced(spec_of(density), mesh);
    const Shape shape = shape_of(*grid);
    if (shape.depth > 1 || (!x.empty() && shape.cells <= x.back())) continue;
    x.push_back(shape.cells);
    grids.push_back(grid);
    shapes.push_back(shape);
  }
  grids.push_back(traced("grid", mesh));
  require_same_hits(scene, grids, rays);
  std::vector<Line> lines;
  for (const TracerPtr& grid : grids) lines.push_back(ray_line(grid, rays));
  const Times times = time_lines(effort, scene, lines, effort.is_quick ? 0.5 : 10);

  std::vector<double> ns, bytes, references, empties, candidates;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    ns.push_back(times.nanoseconds(i).median);
    bytes.push_back(shapes[i].bytes);
    references.push_back(shapes[i].references);
    empties.push_back(100 * shapes[i].empty_share);
    candidates.push_back(work_of(*grids[i], rays).candidates);
  }
  const std::size_t last = shapes.size() - 1, divided = grids.size() - 1;
  const auto best = static_cast<std::size_t>(std::ranges::min_element(ns) - ns.begin());
  finding.growths.push_back({scene + ": time a ray", "cells", "ns", x, ns, {}, "time a ray"});
  finding.growths.push_back({scene + ": bytes a triangle", "cells", "", x, bytes, {}, "bytes a triangle"});
  finding.growths.push_back(
      {scene + ": references a triangle", "cells", "", x, references, {}, "references a triangle"});
  finding.growths.push_back({scene + ": candidates a ray", "cells", "", x, candidates, {}, "candidates a ray"});
  finding.growths.push_back(
      {scene + ": empty cells in percent", "cells", "", x, empties, {}, "empty cells in percent"});

  const Shape whole = shape_of(*grids[divided]);
  const Figure coarse{scene + ": time of a ray, coarsest over best", times.ratio(0, best), "x"};
  const Figure fine{scene + ": time of a ray, finest over best", times.ratio(last, best), "x"};
  const Figure memory = exact_figure(scene + ": bytes, finest over best", bytes[last] / bytes[best], "x");
  const Figure overlap = exact_figure(scene + ": references a triangle, finest", references[last]);
  const Figure ours{scene + ": time of a ray, crowded cells divided over best", times.ratio(divided, best), "x"};
  finding.figures.insert(finding.figures.end(),
                         {exact_figure(scene + ": cells a triangle, best", x[best] / mesh->size()),
                          {scene + ": a ray, best", times.nanoseconds(best), "ns"},
                          coarse,
                          fine,
                          exact_figure(scene + ": bytes a triangle, best", bytes[best]),
                          memory,
                          exact_figure(scene + ": empty cells, best", empties[best], "%"),
                          exact_figure(scene + ": empty cells, finest", empties[last], "%"),
                          exact_figure(scene + ": references a triangle, best", references[best]),
                          overlap,
                          exact_figure(scene + ": candidates a ray, coarsest", candidates[0]),
                          exact_figure(scene + ": bytes a triangle, crowded cells divided", whole.bytes),
                          exact_figure(scene + ": references a triangle, crowded cells divided", whole.references),
                          ours});
  conditions.push_back({Condition::Kind::needed, coarse, Side::above, 1.2});
  conditions.push_back({Condition::Kind::needed, fine, Side::above, 1.2});
  conditions.push_back({Condition::Kind::needed, memory, Side::above, 2});
  conditions.push_back({Condition::Kind::needed, overlap, Side::above, 2});
  conditions.push_back({Condition::Kind::wanted, ours, Side::above, 1});
}

Finding measure_grid_cells(const Effort& effort) {
  Finding finding;
  std::vector<Condition> conditions;
  const auto size = [&](std::size_t full, std::size_t quick) { return std::to_string(effort.count(full, quick)); };
  on_one_thread([&] {
    measure_scene(effort, "teapot:" + size(16, 8), finding, conditions);
    measure_scene(effort, "stadium:" + size(16, 8), finding, conditions);
    measure_scene(effort, "terrain:" + size(100, 50), finding, conditions);
    measure_scene(effort, "soup:" + size(20'000, 5'000), finding, conditions);
  });
  conclude(finding, conditions,
           "With one size of cells it is so; dividing crowded cells again is a way out where triangles are crowded");
  return finding;
}

}  // namespace

const Claim grid_cells_claim{
    "grid_cells", "Uniform grids waste memory or overlap with cell size.",
    "Grids of one level with 0.001 to 64 cells wanted a triangle (those left out in which cells divide all the same), "
    "on an even scene, on surfaces, and on a teapot in a stadium: bytes, empty cells, references (a triangle stands in "
    "each cell that it overlaps), candidates and time of a ray. Beside them the library's grid as it is by itself, "
    "which divides crowded cells again. All hits are the same.",
    "Holds if on every scene rays take more than 1.2 times as long both with the largest and with the smallest cells "
    "as with the best, and the smallest take more than twice the memory and hold a triangle more than twice; holds "
    "with a limit if a grid that divides crowded cells beats the best cell size somewhere.",
    measure_grid_cells};

}  // namespace sightline::bench
