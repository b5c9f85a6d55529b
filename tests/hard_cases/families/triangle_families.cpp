/// Rays that pass close to the edge that two triangles share.

#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_triangles.h"
#include "tests/hard_cases/families/families.h"
#include "tests/hard_cases/families/naive.h"

namespace sightline::hard {
namespace {

void ask_with_naive(const std::shared_ptr<const TriangleMesh>& mesh, const TriangleQuestions& questions, Trial& trial) {
  ask_first_triangles(mesh, questions, trial);
  for (const Ray<float>& ray : questions.narrow) {
    const auto truth = true_first(*mesh, to_double(ray));
    const auto found = moller_trumbore(ray, *mesh);
    const bool is_right = truth.empty() ? !found : found && found->triangle == truth.front();
    trial.naive("Moeller-Trumbore in float").decide(is_right, [&] {
      return Example{text_of(ray), truth.empty() ? "no hit" : "triangle " + std::to_string(truth.front()),
                     found ? "triangle " + std::to_string(found->triangle) : "no hit"};
    });
  }
}

/// A slanted quad, cut along its diagonal.
void ask_near_diagonals(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const AnyFrame frame(random);
  const Vec3d center = any_point(random);
  const auto corner = [&](double x, double y) { return Vec3f(center + x * frame.x + y * frame.y); };
  const std::vector<Vec3f> corners{corner(-1, 0), corner(0, -1), corner(1, 0), corner(0, 1)};
  const auto mesh =
      std::make_shared<const TriangleMesh>(corners, std::vector<TriangleMesh::Corners>{{0, 1, 2}, {0, 2, 3}});
  TriangleQuestions questions;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3d a(corners[0]), c(corners[2]);
    const double beside = std::ldexp(i % 2 == 0 ? 1.0 : -1.0, -difficulty);
    const Vec3d target = a + (0.1 + 0.8 * random.uniform_double()) * (c - a) + beside * frame.y;
    const Vec3d eye = center + 2.0 * frame.z + any_point(random);
    questions.add({Vec3d(Vec3f(eye)), target - Vec3d(Vec3f(eye))});
  }
  ask_with_naive(mesh, questions, trial);
}

/// Two slivers on either side of a long edge. Rays stay in planes y = constant, so that float has them as they are
/// meant however thin the slivers.
void ask_slivers(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const auto width = static_cast<float>(std::pow(10.0, -difficulty));
  const std::vector<Vec3f> corners{{0, 0, 0}, {1, 0, 0.25f}, {0.5f, width, 0.125f}, {0.5f, -width, 0.125f}};
  const auto mesh =
      std::make_shared<const TriangleMesh>(corners, std::vector<TriangleMesh::Corners>{{0, 1, 2}, {1, 0, 3}});
  TriangleQuestions questions;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double x = 0.3 + 0.4 * random.uniform_double(), from = any_point(random).x;
    const auto y = static_cast<float>(width * any_point(random).x);
    questions.add({Vec3d(Vec3f(Vec3d(from, y, 2))), Vec3d(x - from, 0, 0.25 * x - 2)});
  }
  ask_with_naive(mesh, questions, trial);
}

}  // namespace

Family near_diagonals() {
  return {"diagonals",
          "Rays close beside the diagonal of a quad: each hits the triangle of its side, and no other.",
          "rays pass 2^-k beside the diagonal, of length 2",
          "k: 2^-k beside the diagonal",
          1,
          48,
          Oracle::rationals,
          ask_near_diagonals};
}

Family slivers() {
  return {"slivers",
          "Rays at two slivers with a long edge in common: which is hit, or none.",
          "slivers are 10^k times as long as wide",
          "k: aspect 10^k",
          0,
          12,
          Oracle::rationals,
          ask_slivers};
}

}  // namespace sightline::hard
