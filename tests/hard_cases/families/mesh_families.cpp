/// Rays close to edges and vertices of a closed mesh.

#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_triangles.h"
#include "tests/hard_cases/families/families.h"
#include "tests/hard_cases/families/naive.h"
#include "tests/hard_cases/leaks/closed_seeds.h"
#include "tests/hard_cases/leaks/leak_mesh.h"

namespace sightline::hard {
namespace {

void ask_aimed(LeakMesh::Aim aim, int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  const LeakMesh mesh("icosphere", icosphere(1), {"aside", 1, Vec3d(5.785, 0.072, -8.156), 0});
  const double beside = std::ldexp(1.0, -difficulty);
  TriangleQuestions questions;
  for (std::uint64_t group = 0; group < count; ++group) {
    std::array<Ray<float>, LeakMesh::group_size> narrow;
    std::array<Ray<double>, LeakMesh::group_size> wide;
    mesh.rays(seed, group, narrow.data(), aim, beside);
    mesh.rays(seed, group, wide.data(), aim, beside);
    questions.narrow.insert(questions.narrow.end(), narrow.begin(), narrow.end());
    questions.wide.insert(questions.wide.end(), wide.begin(), wide.end());
  }
  const IsTrue is_true = [](std::size_t, bool, const Hit<double>& hit) { return hit.is_hit(); };
  ask_triangles(mesh.mesh(), questions, is_true, trial);
  for (const Ray<float>& ray : questions.narrow) {
    trial.naive("Moeller-Trumbore in float").decide(moller_trumbore(ray, *mesh.mesh()).has_value(), [&] {
      return Example{text_of(ray), "a hit", "no hit"};
    });
  }
}

}  // namespace

Family mesh_edges() {
  return {"edges",
          "Rays close to edges of a closed mesh, from inside it or from outside as far as inside: each hits.",
          "rays pass up to 2^-k beside, of a mesh of size 2",
          "k: up to 2^-k beside",
          1,
          50,
          Oracle::closed_form,
          [](int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
            ask_aimed(LeakMesh::Aim::edges, difficulty, count, seed, trial);
          }};
}

Family mesh_vertices() {
  return {"vertices",
          "Rays close to vertices of a closed mesh, from inside it or from outside as far as inside: each hits.",
          "rays pass up to 2^-k beside, of a mesh of size 2",
          "k: up to 2^-k beside",
          1,
          50,
          Oracle::closed_form,
          [](int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
            ask_aimed(LeakMesh::Aim::vertices, difficulty, count, seed, trial);
          }};
}

}  // namespace sightline::hard
