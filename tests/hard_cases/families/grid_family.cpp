/// Long walks through the corners of a grid's cells.

#include <cmath>

#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_triangles.h"
#include "tests/hard_cases/families/families.h"

namespace sightline::hard {
namespace {

/// Cells of size 1 on the diagonal of a plane, each with a triangle across that the diagonal x = y, z = 0.25 passes
/// beside, exactly at a corner of it or at a distance; the last one alone is hit.
std::shared_ptr<const TriangleMesh> diagonal_row(std::uint32_t length) {
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  for (std::uint32_t i = 0; i < length; ++i) {
    const auto x = static_cast<float>(i);
    const bool is_last = i + 1 == length;
    // Across the diagonal from (x + 0.75, x + 0.25) to (x + 0.25, x + 0.75), above it or around it.
    const float low = is_last ? 0 : 0.5f;
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    positions.insert(positions.end(),
                     {{x + 0.75f, x + 0.25f, low}, {x + 0.25f, x + 0.75f, low}, {x + 0.5f, x + 0.5f, 1}});
  }
  return std::make_shared<const TriangleMesh>(std::move(positions), std::move(triangles));
}

/// Amanatides and Woo's walk in float, adding up: the cell after so many steps of a ray from (0.5, 0.5).
bool adds_up(std::uint32_t steps, const glm::vec2& direction, const glm::ivec2& truth) {
  const glm::vec2 delta = 1.0f / direction;
  glm::vec2 next = 0.5f * delta;
  glm::ivec2 cell(0);
  for (std::uint32_t i = 0; i < steps; ++i) {
    const int axis = next.x < next.y ? 0 : 1;
    next[axis] += delta[axis];
    ++cell[axis];
  }
  return cell == truth;
}

/// The cell after so many plane crossings of a ray from (0.5, 0.5) with whole-numbered direction: plane n of x is met
/// at (n + 1/2) / dx, compared by whole numbers; the lower axis first where both are met at once.
glm::ivec2 true_cell(std::uint32_t steps, const glm::ivec2& direction) {
  std::int64_t x = 0, y = 0;
  for (std::uint32_t i = 0; i < steps; ++i) ((2 * x + 1) * direction.y < (2 * y + 1) * direction.x ? x : y) += 1;
  return {static_cast<int>(x), static_cast<int>(y)};
}

void ask_marching(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const std::uint32_t length = 1u << difficulty;
  const auto mesh = diagonal_row(length);
  TriangleQuestions questions;
  for (std::uint64_t i = 0; i < count; ++i) {
    // Along the diagonal, through all corners of cells, back or forth, with directions of any length that float has.
    const double size = std::ldexp(1.0 + random.below(1u << 10), -static_cast<int>(random.below(20)));
    const double before = -1.0 - random.below(8), behind = length + 1.0 + random.below(8);
    const bool is_forth = i % 2 == 0;
    const Vec3d from = is_forth ? Vec3d(before, before, 0.25) : Vec3d(behind, behind, 0.25);
    questions.add({from, Vec3d(is_forth ? size : -size, is_forth ? size : -size, 0)});
  }
  const IsTrue is_true = [&](std::size_t, bool, const Hit<double>& hit) { return hit.prim_id == length - 1; };
  ask_triangles(mesh, questions, is_true, trial);
  for (std::uint64_t i = 0; i < 8 * count; ++i) {
    const glm::ivec2 direction(1 + 2 * static_cast<int>(random.below(50)), 1 + 2 * static_cast<int>(random.below(50)));
    const glm::ivec2 truth = true_cell(length, direction);
    trial.naive("steps added up in float").decide(adds_up(length, glm::vec2(direction) / 101.0f, truth), [&] {
      return Example{std::to_string(direction.x) + ", " + std::to_string(direction.y),
                     "cell " + std::to_string(truth.x), "another"};
    });
  }
}

}  // namespace

Family grid_marching() {
  return {
      "marching",
      "Rays along the diagonal of a row of cells, through all their corners: the only triangle in the way, at its end.",
      "a row of 2^k cells",
      "k: 2^k cells",
      1,
      14,
      Oracle::closed_form,
      ask_marching};
}

}  // namespace sightline::hard
