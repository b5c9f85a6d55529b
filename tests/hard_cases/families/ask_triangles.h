#pragma once
/// Triangles asked through every structure: at levels fast and watertight with rays of float, at precise and exact with
/// rays of double, whose decisions are those of real arithmetic at both.

#include <functional>
#include <memory>
#include <vector>

#include "sightline/query/tracer.h"
#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

/// Rays of one question in both precisions: where float rounds them, they are two questions.
struct TriangleQuestions {
  std::vector<Ray<float>> narrow;
  std::vector<Ray<double>> wide;

  void add(const Ray<double>& ray);
};

/// Whether the answer to a question is the true one. Numbers are not looked at beyond what decides.
using IsTrue = std::function<bool(std::size_t question, bool is_wide, const Hit<double>& hit)>;

void ask_triangles(const std::shared_ptr<const TriangleMesh>& mesh, const TriangleQuestions& questions,
                   const IsTrue& is_true, Trial& trial);

/// For each ray the triangles it crosses first, by rational numbers; empty where it crosses none. Of those the lowest
/// is the true answer. At most one triangle is that near, or those that share an edge there.
std::vector<std::uint32_t> true_first(const TriangleMesh& mesh, const Ray<double>& ray);

/// Decided by true_first.
void ask_first_triangles(const std::shared_ptr<const TriangleMesh>& mesh, const TriangleQuestions& questions,
                         Trial& trial);

}  // namespace sightline::hard
