/// Triangles and rays through whole numbers, where planes, edges and vertices meet all the time.

#include <algorithm>
#include <array>
#include <tuple>

#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_triangles.h"
#include "tests/hard_cases/families/families.h"
#include "tests/hard_cases/families/naive.h"

namespace sightline::hard {
namespace {

using Whole = std::array<std::int64_t, 3>;

Whole operator-(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
std::int64_t dot(const Whole& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Whole cross(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec3f to_float(const Whole& p) { return {float(p[0]), float(p[1]), float(p[2])}; }

/// t = up / down, down > 0. Numbers are below 2^26.
struct TrueCrossing {
  std::int64_t up, down;
  std::uint32_t triangle;
};

struct Lattice {
  std::vector<Whole> points;
  std::vector<TriangleMesh::Corners> triangles;

  /// Of all triangles that the line meets beyond 0: by volumes of tetrahedra over the line, whose signs agree.
  std::vector<TrueCrossing> crossings(const Whole& origin, const Whole& direction) const {
    std::vector<TrueCrossing> found;
    for (std::uint32_t id = 0; id < triangles.size(); ++id) {
      const Whole a = points[triangles[id][0]] - origin, b = points[triangles[id][1]] - origin,
                  c = points[triangles[id][2]] - origin;
      const std::int64_t u = dot(direction, cross(c, b)), v = dot(direction, cross(a, c)),
                         w = dot(direction, cross(b, a));
      if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) continue;
      const Whole normal = cross(b - a, c - a);
      const std::int64_t slope = dot(normal, direction), level = dot(normal, a);
      if (slope == 0 || level == 0 || (level < 0) != (slope < 0)) continue;
      found.push_back({std::abs(level), std::abs(slope), id});
    }
    return found;
  }
};

/// Nearer ones first as T has them; equal ones by their number.
template <class T>
const TrueCrossing* first_of(const std::vector<TrueCrossing>& crossings) {
  const auto key = [](const TrueCrossing& c) {
    return std::tuple(static_cast<T>(static_cast<double>(c.up) / static_cast<double>(c.down)), c.triangle);
  };
  const auto nearest = std::ranges::min_element(crossings, {}, key);
  return nearest == crossings.end() ? nullptr : &*nearest;
}

/// t of double is not correctly rounded (query/leaves.h): what is closer than its bound may come first.
bool is_first(const std::vector<TrueCrossing>& crossings, bool is_wide, const Hit<double>& hit) {
  const TrueCrossing* first = is_wide ? first_of<double>(crossings) : first_of<float>(crossings);
  if (!first) return !hit.is_hit();
  if (hit.prim_id == first->triangle) return true;
  const auto met = std::ranges::find(crossings, hit.prim_id, &TrueCrossing::triangle);
  if (!is_wide || met == crossings.end()) return false;
  const auto t = [](const TrueCrossing& c) { return static_cast<double>(c.up) / static_cast<double>(c.down); };
  const bool is_equal = met->up * first->down == first->up * met->down;
  return !is_equal && t(*met) - t(*first) < 0x1p-34 * t(*first);
}

void ask_lattice(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  const std::uint32_t side = 1u << (6 - difficulty);
  Random random(seed);
  const auto point = [&] {
    const auto x = random.below(side + 1), y = random.below(side + 1), z = random.below(side + 1);
    return Whole{x, y, z};
  };
  Lattice lattice;
  std::vector<Vec3f> positions;
  for (std::uint32_t id = 0; id < 64; ++id) {
    lattice.triangles.push_back({3 * id, 3 * id + 1, 3 * id + 2});
    for (int i = 0; i < 3; ++i) lattice.points.push_back(point());
  }
  for (const Whole& p : lattice.points) positions.push_back(to_float(p));
  const auto mesh = std::make_shared<const TriangleMesh>(positions, lattice.triangles);
  TriangleQuestions questions;
  std::vector<std::vector<TrueCrossing>> truths;
  while (truths.size() < count) {
    const Whole from = point(), way = point() - from;
    if (way == Whole{0, 0, 0}) continue;
    questions.add({Vec3d(to_float(from)), Vec3d(to_float(way))});
    truths.push_back(lattice.crossings(from, way));
  }
  const IsTrue is_true = [&](std::size_t i, bool is_wide, const Hit<double>& hit) {
    return is_first(truths[i], is_wide, hit);
  };
  ask_triangles(mesh, questions, is_true, trial);
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const auto found = moller_trumbore(questions.narrow[i], *mesh, Edges::left_out);
    const Hit<double> hit{0, found ? found->triangle : no_primitive, 0, 0};
    trial.naive("Moeller-Trumbore without edges").decide(is_first(truths[i], false, hit), [&] {
      return Example{text_of(questions.narrow[i]), "another answer",
                     found ? "triangle " + std::to_string(found->triangle) : "no hit"};
    });
  }
}

}  // namespace

Family lattice_scenes() {
  return {"lattice",
          "64 triangles with corners at whole numbers, and rays from whole numbers to others: which is hit first.",
          "whole numbers from 0 to 2^(6 - k), so that ever more coincides",
          "k: lattice of 2^(6-k) cells a side",
          0,
          5,
          Oracle::brute_force,
          ask_lattice};
}

}  // namespace sightline::hard
