#include <map>
#include <memory>
#include <numbers>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/chance.h"
#include "bench/accuracy/error_sum.h"
#include "bench/accuracy/oracle.h"
#include "bench/text_table.h"
#include "sightline/csg/face_roots.h"
#include "sightline/csg/solid_set.h"
#include "sightline/query/tracer.h"
#include "sightline/shape/sphere.h"

namespace sightline::bench {
namespace {

using Rays = std::vector<Ray<float>>;

/// An icosahedron whose triangles are cut into four `levels` times, all corners on the unit sphere.
std::shared_ptr<const TriangleMesh> icosphere(int levels) {
  const double g = std::numbers::phi;
  std::vector<Vec3d> points;
  for (const double one : {-1.0, 1.0}) {
    for (const double other : {-g, g}) {
      for (const Vec3d& p : {Vec3d(0, one, other), Vec3d(one, other, 0), Vec3d(other, 0, one)}) {
        points.push_back(glm::normalize(p));
      }
    }
  }
  // Faces are triples of corners at the shortest distance from each other.
  const double side = 2 / std::sqrt(1 + g * g);
  const auto are_neighbours = [&](std::uint32_t i, std::uint32_t k) {
    return std::fabs(glm::length(points[i] - points[k]) - side) < 0.01;
  };
  std::vector<TriangleMesh::Corners> faces;
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t k = i + 1; k < 12; ++k) {
      for (std::uint32_t l = k + 1; l < 12; ++l) {
        if (!are_neighbours(i, k) || !are_neighbours(k, l) || !are_neighbours(i, l)) continue;
        const bool faces_out = glm::dot(points[i], glm::cross(points[k], points[l])) > 0;
        faces.push_back(faces_out ? TriangleMesh::Corners{i, k, l} : TriangleMesh::Corners{i, l, k});
      }
    }
  }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t k) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(i, k), static_cast<std::uint32_t>(points.size()));
      if (is_new) points.push_back(glm::normalize(points[i] + points[k]));
      return at->second;
    };
    std::vector<TriangleMesh::Corners> finer;
    for (const auto& [i, k, l] : faces) {
      const std::uint32_t ik = middle(i, k), kl = middle(k, l), li = middle(l, i);
      for (const TriangleMesh::Corners& face :
           {TriangleMesh::Corners{i, ik, li}, {ik, k, kl}, {li, kl, l}, {ik, kl, li}}) {
        finer.push_back(face);
      }
    }
    faces = std::move(finer);
  }
  return std::make_shared<const TriangleMesh>(std::vector<Vec3f>(points.begin(), points.end()), std::move(faces));
}

Errors errors_of(const Rays& rays, const std::vector<std::vector<True>>& truths, const std::vector<Hit<float>>& hits) {
  ErrorSum sum;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool is_there = !truths[i].empty() && truths[i][0].high > 0;
    sum.decide(hits[i].is_hit() == is_there);
    if (is_there && hits[i].is_hit()) {
      sum.add(truths[i][0].off(double(hits[i].t)) * glm::length(Vec3d(rays[i].direction)));
    }
  }
  return sum.errors();
}

template <class Solve>
Choice analytic(const std::string& name, const std::shared_ptr<const Rays>& rays,
                const std::vector<std::vector<True>>& truths, double bytes, Solve solve) {
  std::vector<Hit<float>> hits(rays->size());
  const auto hit_of = [solve](const Ray<float>& ray) {
    const double t = solve(to_double(ray));
    return t > 0 ? Hit<float>{static_cast<float>(t), 0} : Hit<float>{};
  };
  for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = hit_of((*rays)[i]);
  return {name,
          errors_of(*rays, truths, hits),
          [rays, hit_of] {
            double met = 0;
            for (const Ray<float>& ray : *rays) met += hit_of(ray).is_hit();
            return met;
          },
          {{"bytes", bytes}}};
}

template <Level level>
double first_crossing(const Ray<double>& ray) {
  const RootList list = face_roots<level>(solid::Sphere{Vec3d(0), 1}, LocalRay<level>(ray));
  return list.count == 0 ? -1 : list.roots[0].t;
}

// ---- A ball with a hollow

const solid::Sphere whole{Vec3d(0), 1}, hollow{Vec3d(0.625, 0.25, 0.25), 0.75};

SolidShape faceted(const solid::Sphere& sphere, int levels) {
  const auto mesh = icosphere(levels);
  std::vector<Vec3d> points;
  for (const Vec3f& p : mesh->positions()) points.push_back(sphere.center + sphere.radius * Vec3d(p));
  return std::make_shared<const ClosedMesh>(std::move(points), mesh->triangles());
}

/// Where the ray first enters the ball outside of the hollow, or comes to the ball's rest on the hollow's far side.
std::vector<True> true_first_crossing(const Ray<double>& ray) {
  const auto of_whole = true_sphere_roots(whole.center, whole.radius, ray);
  const auto of_hollow = true_sphere_roots(hollow.center, hollow.radius, ray);
  if (of_whole.size() < 2) return {};
  if (of_hollow.size() < 2 || of_whole[0] < of_hollow[0] || of_hollow[1] < of_whole[0]) return {of_whole[0]};
  if (of_hollow[1] < of_whole[1]) return {of_hollow[1]};
  return {};
}

template <Level level>
Choice solid_choice(const std::string& name, const SolidShape& ball, const SolidShape& hole,
                    const std::shared_ptr<const Rays>& rays, const std::vector<std::vector<True>>& truths,
                    double triangles) {
  std::vector<std::shared_ptr<const Solid>> solids{std::make_shared<const Solid>(SolidTree(ball) - SolidTree(hole))};
  const auto set = std::make_shared<const SolidSet<level>>(std::move(solids));
  Choice choice = analytic(name, rays, truths, 0, [set](const Ray<double>& ray) {
    double first = -1;
    set->prepare(ray).for_each_crossing((*set)[0], [&](const Crossing& crossing) {
      if (first < 0 && crossing.t > 0) first = crossing.t;
    });
    return first;
  });
  choice.extras = {{"triangles", triangles}};
  return choice;
}

Panel solid_panel(const Effort& effort, const std::shared_ptr<const Rays>& rays) {
  std::vector<std::vector<True>> truths;
  for (const Ray<float>& ray : *rays) truths.push_back(true_first_crossing(to_double(ray)));
  Panel panel{"ball - ball",  "a solid of two spheres, and of two closed meshes; wrong: met or missed otherwise",
              "ray",          "of the hit point along the ray, in radii",
              ErrorKind::rms, static_cast<double>(rays->size())};
  for (int levels = 1; levels <= (effort.is_quick ? 3 : 5); ++levels) {
    const double triangles = 40 * std::pow(4.0, levels);
    panel.choices.push_back(solid_choice<Level::watertight>(plural(static_cast<std::size_t>(triangles), "triangle"),
                                                            faceted(whole, levels), faceted(hollow, levels), rays,
                                                            truths, triangles));
  }
  panel.choices.push_back(solid_choice<Level::fast>("spheres, fast", whole, hollow, rays, truths, 0));
  panel.choices.push_back(solid_choice<Level::watertight>("spheres, watertight", whole, hollow, rays, truths, 0));
  panel.choices.push_back(solid_choice<Level::exact>("spheres, exact", whole, hollow, rays, truths, 0));
  return panel;
}

std::vector<Panel> panels(const Effort& effort) {
  Chance chance(effort.seed);
  auto all = std::make_shared<Rays>();
  for (std::size_t i = 0; i < effort.count(20'000, 4'000); ++i) {
    const Vec3f from(4.0 * chance.direction()), to(std::sqrt(chance.unit()) * 1.2 * chance.direction());
    all->push_back({from, to - from});
  }
  const std::shared_ptr<const Rays> rays = all;
  std::vector<std::vector<True>> truths;
  for (const Ray<float>& ray : *rays) truths.push_back(true_sphere_roots(Vec3d(0), 1, to_double(ray)));
  Panel panel{"unit sphere",  "a sphere by itself and as triangles of a wide-tree; wrong: met or missed otherwise",
              "ray",          "of the hit point along the ray, in radii",
              ErrorKind::rms, static_cast<double>(rays->size())};
  for (int levels = 0; levels <= (effort.is_quick ? 5 : 7); ++levels) {
    const auto mesh = icosphere(levels);
    const std::shared_ptr<const Tracer> tracer = make_tracer("wide-tree", mesh);
    auto hits = std::make_shared<std::vector<Hit<float>>>(rays->size());
    tracer->closest_hits(std::span(*rays), std::span(*hits));
    panel.choices.push_back({plural(mesh->size(), "triangle"),
                             errors_of(*rays, truths, *hits),
                             [tracer, rays, hits] {
                               tracer->closest_hits(std::span<const Ray<float>>(*rays), std::span(*hits));
                               return static_cast<double>(hits->back().t);
                             },
                             {{"bytes", static_cast<double>(tracer->structure_bytes() + tracer->leaf_bytes())}}});
  }
  panel.choices.push_back(analytic("sphere of a set", rays, truths, sizeof(Sphere), [](const Ray<double>& ray) {
    double first = -1;
    SphereSet::PreparedRay(ray).for_each_crossing({Vec3f(0), 1}, [&](const Crossing& crossing) {
      if (first < 0) first = crossing.t;
    });
    return first;
  }));
  panel.choices.push_back(
      analytic("face of a solid, fast", rays, truths, sizeof(solid::Sphere), first_crossing<Level::fast>));
  panel.choices.push_back(
      analytic("face of a solid, watertight", rays, truths, sizeof(solid::Sphere), first_crossing<Level::watertight>));
  return {panel, solid_panel(effort, rays)};
}

}  // namespace

Axis tessellation_axis() { return {"tessellation", "whether a round shape is cut into triangles", panels}; }

}  // namespace sightline::bench
