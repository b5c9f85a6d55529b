#include "tests/hard_cases/families/ask_triangles.h"

#include "tests/hard_cases/families/any_points.h"
#include "tests/shape/crossing_oracle.h"

namespace sightline::hard {
namespace {

template <class T>
std::vector<Hit<double>> hits_of(const Tracer& tracer, const std::vector<Ray<T>>& rays, Level level) {
  std::vector<Hit<T>> hits(rays.size());
  const Queries<T>& queries = tracer;
  queries.closest_hits(rays, hits, level);
  std::vector<Hit<double>> wide;
  for (const Hit<T>& hit : hits) wide.push_back({hit.t, hit.prim_id, hit.u, hit.v});
  return wide;
}

std::string text_of(const Hit<double>& hit) {
  return hit.is_hit() ? "triangle " + std::to_string(hit.prim_id) + " at " + text_of_number(hit.t) : "no hit";
}

}  // namespace

void TriangleQuestions::add(const Ray<double>& ray) {
  wide.push_back(ray);
  narrow.push_back(to_float(ray));
  narrow.back().t_max = static_cast<float>(ray.t_max);
}

void ask_triangles(const std::shared_ptr<const TriangleMesh>& mesh, const TriangleQuestions& questions,
                   const IsTrue& is_true, Trial& trial) {
  for (const AcceleratorInfo& info : accelerator_infos()) {
    const auto tracer = make_tracer(info.name, mesh);
    for (const LevelInfo& level : level_infos) {
      Tally& tally = trial.of(info.name, level.level);
      const bool is_wide = level.level == Level::precise || level.level == Level::exact;
      const auto hits =
          is_wide ? hits_of(*tracer, questions.wide, level.level) : hits_of(*tracer, questions.narrow, level.level);
      for (std::size_t i = 0; i < hits.size(); ++i) {
        tally.decide(is_true(i, is_wide, hits[i]), [&] {
          return Example{is_wide ? text_of(questions.wide[i]) : text_of(questions.narrow[i]), "another answer",
                         text_of(hits[i])};
        });
      }
    }
  }
}

std::vector<std::uint32_t> true_first(const TriangleMesh& mesh, const Ray<double>& ray) {
  MeshSeed seed;
  for (const Vec3f& p : mesh.positions()) seed.vertices.emplace_back(p);
  seed.triangles = mesh.triangles();
  const CrossingMap crossings = expected_crossings(exact(ray), seed);
  return crossings.empty() ? std::vector<std::uint32_t>() : crossings.begin()->second;
}

void ask_first_triangles(const std::shared_ptr<const TriangleMesh>& mesh, const TriangleQuestions& questions,
                         Trial& trial) {
  std::vector<std::vector<std::uint32_t>> narrow, wide;
  for (const Ray<float>& ray : questions.narrow) narrow.push_back(true_first(*mesh, to_double(ray)));
  for (const Ray<double>& ray : questions.wide) wide.push_back(true_first(*mesh, ray));
  const IsTrue is_true = [&](std::size_t i, bool is_wide, const Hit<double>& hit) {
    const std::vector<std::uint32_t>& first = is_wide ? wide[i] : narrow[i];
    return first.empty() ? !hit.is_hit() : hit.prim_id == first.front();
  };
  ask_triangles(mesh, questions, is_true, trial);
}

}  // namespace sightline::hard
