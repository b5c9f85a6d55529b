#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "bench/accuracy/chance.h"
#include "bench/claims/course.h"
#include "bench/claims/polygons.h"
#include "bench/claims/rules.h"
#include "bench/claims/tools.h"
#include "sightline/scene/solids.h"

namespace sightline::bench {
namespace {

constexpr double picture_rays = 512 * 512;

using Rays = std::vector<Ray<double>>;

template <Level level>
std::shared_ptr<const SolidSet<level>> set_of(const SolidTree& tree) {
  return std::make_shared<const SolidSet<level>>(
      std::vector<std::shared_ptr<const Solid>>{std::make_shared<const Solid>(tree)});
}

/// Of unit length, from outside through the bounds; in numbers of float.
Rays rays_at(const Aabb& box, std::size_t count, std::uint64_t seed) {
  Chance chance(seed);
  const Vec3d middle = (Vec3d(box.lo) + Vec3d(box.hi)) / 2.0, half = (Vec3d(box.hi) - Vec3d(box.lo)) / 2.0;
  Rays rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d from = middle + 3.0 * glm::length(half) * chance.direction();
    const Vec3d to = middle + half * chance.point(1);
    rays.push_back({Vec3d(Vec3f(from)), Vec3d(Vec3f(glm::normalize(to - from)))});
  }
  return rays;
}

/// Of the first crossing in front; negative without one.
template <Level level>
double first_of(const SolidSet<level>& set, const Ray<double>& ray) {
  double first = -1;
  set.prepare(ray).for_each_crossing(set[0], [&](const Crossing& crossing) {
    if (first < 0 && crossing.t > 0) first = crossing.t;
  });
  return first;
}

/// Beside the truth: hits that are none or elsewhere, farther than `near`, and how far off the others are.
struct Off {
  double wrong_share = 0, rms = 0, most = 0;
};
template <class Find>
Off off_of(const Rays& rays, const std::vector<double>& truth, double near, Find find) {
  double wrong = 0, squares = 0, count = 0, most = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double t = find(rays[i]);
    if ((t >= 0) != (truth[i] >= 0) || std::fabs(t - truth[i]) > near) {
      ++wrong;
    } else if (t >= 0) {
      squares += (t - truth[i]) * (t - truth[i]);
      most = std::max(most, std::fabs(t - truth[i]));
      ++count;
    }
  }
  return {wrong / static_cast<double>(rays.size()), std::sqrt(squares / std::max(1.0, count)), most};
}

double hit_of(const Tracer& tracer, const Ray<double>& ray) {
  Hit<double> hit;
  static_cast<const Queries<double>&>(tracer).closest_hits({&ray, 1}, {&hit, 1});
  return hit.is_hit() ? hit.t : -1;
}

/// Cells a side, whatever share of the effort is wanted.
std::vector<int> lattices(const Effort& effort) {
  std::vector<int> all{8, 16, 32};
  if (!effort.is_quick) all.insert(all.end(), {64, 128});
  return all;
}

void measure_solid(const Effort& effort, const std::string& name, Finding& finding,
                   std::vector<Condition>& conditions) {
  effort.say(name);
  const SolidTree tree = load_solid(name);
  const auto solid = set_of<Level::watertight>(tree);
  const auto oracle = set_of<Level::exact>(tree);
  const Aabb box = solid->bounds(0);
  const double side = max_norm(Vec3d(box.hi) - Vec3d(box.lo));
  const Rays rays = rays_at(box, effort.count(20'000, 3'000), effort.seed);
  std::vector<double> truth;
  for (const Ray<double>& ray : rays) truth.push_back(first_of(*oracle, ray));

  const std::vector<int> cells = lattices(effort);
  std::vector<Line> lines{{[&] {
                             double sum = 0;
                             for (const Ray<double>& ray : rays) sum += first_of(*solid, ray);
                             return sum;
                           },
                           static_cast<double>(rays.size())}};
  const Off traced_off =
      off_of(rays, truth, side / 1000, [&](const Ray<double>& ray) { return first_of(*solid, ray); });
  std::vector<double> x, seconds, triangles, bytes, rms, most, wrong;
  for (const int count : cells) {
    effort.say(name + " as polygons of " + std::to_string(count) + " cells a side");
    const MeshPtr mesh = polygons_of(*solid, count);
    const TracerPtr tracer = traced("wide-tree", mesh);
    const Off off = off_of(rays, truth, 2 * side / count, [&](const Ray<double>& ray) { return hit_of(*tracer, ray); });
    x.push_back(count);
    triangles.push_back(mesh->size());
    bytes.push_back(
        static_cast<double>(mesh->positions().size() * sizeof(Vec3f) + mesh->size() * sizeof(TriangleMesh::Corners)) /
        1024);
    rms.push_back(off.rms / side);
    most.push_back(off.most / side);
    wrong.push_back(100 * off.wrong_share);
    lines.push_back({[solid, count] { return static_cast<double>(polygons_of(*solid, count)->size()); }});
  }
  const Times times = time_lines(effort, name, lines, effort.is_quick ? 1 : 20);
  for (std::size_t i = 0; i < cells.size(); ++i) seconds.push_back(times.nanoseconds(i + 1).median * 1e-6);

  const Growth time = growth_of(name + ": time to polygonise", "cells a side", "ms", x, seconds);
  finding.growths.insert(
      finding.growths.end(),
      {time, growth_of(name + ": triangles", "cells a side", "", x, triangles, "triangles"),
       growth_of(name + ": memory", "cells a side", "KiB", x, bytes),
       growth_of(name + ": error of hits, RMS, of the side", "cells a side", "", x, rms, "error"),
       growth_of(name + ": error of hits, greatest, of the side", "cells a side", "", x, most, "error"),
       Growth{name + ": wrong hits in percent", "cells a side", "", x, wrong, {}, "wrong hits"}});
  const std::size_t finest = cells.size();
  const std::string at_finest = name + ", " + std::to_string(cells.back()) + " cells a side: ";
  Estimate pictures = times.ratio(finest, 0);
  for (double* part : {&pictures.median, &pictures.low, &pictures.high}) *part /= picture_rays;
  const Figure trace_wrong = exact_figure(name + ": wrong hits of tracing", 100 * traced_off.wrong_share, "%");
  const Figure mesh_wrong = exact_figure(at_finest + "wrong hits", wrong.back(), "%");
  const Figure coarser = exact_figure(at_finest + "error over that of tracing",
                                      rms.back() / std::max(traced_off.rms / side, 0x1p-53), "x");
  const Figure exponent{name + ": exponent of the time to polygonise", exponent_of(time), ""};
  finding.figures.insert(finding.figures.end(),
                         {{name + ": a ray", times.nanoseconds(0), "ns"},
                          trace_wrong,
                          exact_figure(name + ": error of tracing, of the side", traced_off.rms / side),
                          exact_figure(at_finest + "triangles", triangles.back()),
                          exact_figure(at_finest + "error, of the side", rms.back()),
                          mesh_wrong,
                          coarser,
                          exponent,
                          {at_finest + "time over that of tracing 512 x 512 pixels", pictures, "x"}});
  conditions.push_back({Condition::Kind::needed, trace_wrong, Side::below, 1e-6});
  conditions.push_back({Condition::Kind::needed, coarser, Side::above, 1000});
  conditions.push_back({Condition::Kind::needed, mesh_wrong, Side::above, 0});
  conditions.push_back({Condition::Kind::needed, exponent, Side::above, 1});
}

/// A cube with a slot of a hundredth of its side, somewhere, asked by rays down the slot.
void measure_slots(const Effort& effort, Finding& finding, std::vector<Condition>& conditions) {
  Chance chance(effort.seed);
  std::vector<double> x, closed;
  for (const int cells : lattices(effort)) {  // 32 is the third
    effort.say("slots in " + std::to_string(cells) + " cells a side");
    double lost = 0, asked = 0;
    for (int slot = 0; slot < 12; ++slot) {
      const double at = chance.between(0.2, 0.8);
      const SolidTree tree = SolidTree(solid::Box{Vec3d(0), Vec3d(1)}) -
                             SolidTree(solid::Box{Vec3d(at, -1, 0.25), Vec3d(at + 0.01, 2, 2)});
      const auto cut = set_of<Level::watertight>(tree);
      const TracerPtr tracer = traced("wide-tree", polygons_of(*cut, cells));
      for (int i = 0; i < 8; ++i) {
        const Ray<double> ray{Vec3d(at + chance.between(0.002, 0.008), chance.between(0.1, 0.9), 2), Vec3d(0, 0, -1)};
        lost += std::fabs(hit_of(*tracer, ray) - first_of(*cut, ray)) > 0.25;
        ++asked;
      }
    }
    x.push_back(cells);
    closed.push_back(100 * lost / asked);
  }
  finding.growths.push_back({"slots: closed in percent", "cells a side", "", x, closed, {}, "slots"});
  const Figure figure = exact_figure("slots of a hundredth, 32 cells a side: closed", closed[2], "%");
  finding.figures.push_back(figure);
  conditions.push_back({Condition::Kind::needed, figure, Side::above, 25});
}

void measure_leaves(const Effort& effort, Finding& finding, std::vector<Condition>& conditions) {
  std::vector<double> leaves;
  std::vector<Rays> rays;
  std::vector<Line> lines;
  std::vector<std::shared_ptr<const OneSolid>> solids;
  for (int holes = 4; holes <= static_cast<int>(effort.count(1024, 128)); holes *= 2) {
    leaves.push_back(holes + 1);
    solids.push_back(set_of<Level::watertight>(load_solid("swiss-cheese:" + std::to_string(holes))));
    rays.push_back(rays_at(solids.back()->bounds(0), effort.count(5'000, 1'000), effort.seed));
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    lines.push_back({[&, i] {
                       double sum = 0;
                       for (const Ray<double>& ray : rays[i]) sum += first_of(*solids[i], ray);
                       return sum;
                     },
                     static_cast<double>(rays[i].size())});
  }
  const Times times = time_lines(effort, "solids of many parts", lines);
  std::vector<double> ns;
  for (std::size_t i = 0; i < lines.size(); ++i) ns.push_back(times.nanoseconds(i).median);
  finding.growths.push_back(growth_of("swiss-cheese: time a ray", "parts", "ns", leaves, ns));
  const Figure exponent{"swiss-cheese: exponent of a ray's time in parts", exponent_of(finding.growths.back()), ""};
  finding.figures.push_back(exponent);
  conditions.push_back({Condition::Kind::wanted, exponent, Side::below, 1});
}

Finding measure_csg(const Effort& effort) {
  Finding finding;
  std::vector<Condition> conditions;
  for (const std::string name : {"widget", "pawn", "swiss-cheese:12"}) measure_solid(effort, name, finding, conditions);
  measure_slots(effort, finding, conditions);
  measure_leaves(effort, finding, conditions);
  conclude(finding, conditions, "Solids of very many parts are not easy to trace, either");
  return finding;
}

}  // namespace

const Claim csg_claim{
    "csg", "CSG is easy to trace and hard to polygonise.",
    "Solids traced by interval lists, and as the triangles of marching tetrahedra on ever finer lattices: time, hits "
    "that are wrong (none, where there is one, or farther off than a thousandth of the side, for polygons than two "
    "cells) "
    "and how far off the others are, against the level exact; cubes with a slot of a hundredth of their side; and the "
    "time of a ray as the parts become many.",
    "Holds if tracing has no wrong hit, while the finest lattice has some and an error more than 1000 times as large, "
    "the time to polygonise grows faster than the cells along a side, and a quarter of the slots is lost at 32 cells; "
    "holds with a limit if the time of a ray grows as fast as the number of parts.",
    measure_csg};

}  // namespace sightline::bench
