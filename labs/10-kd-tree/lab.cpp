/// Lab 10: what is asked of a student's kd-tree.

#include <cmath>

#include "labs/check/structure_checks.h"
#include "labs/check/text.h"
#include "labs/labs.h"

namespace sightline::labs {
namespace {

/// A cell of whole numbers, split within.
struct Division {
  Aabb cell;
  int axis;
  float split;
  std::uint32_t below, above;
};

Division division_of(const Case& at) {
  const auto size = [&](std::size_t i) { return static_cast<float>(1 + std::abs(at.head[i])); };
  Division division{{Vec3f(0), {size(0), size(1), size(2)}}, std::abs(at.head[3]) % 3, 0, 0, 0};
  // A quarter, a half or three quarters of the way: exact.
  division.split = division.cell.hi[division.axis] * static_cast<float>(1 + std::abs(at.head[4]) % 3) / 4;
  division.below = static_cast<std::uint32_t>(std::abs(at.head[5]));
  division.above = static_cast<std::uint32_t>(std::abs(at.head[6]));
  return division;
}

Check split_cost_check() {
  Check check{
      "split-cost",
      "2. What a split costs",
      "The heuristic decides every plane of the tree: with a wrong cost the hits stay right and the tree is slow.",
      {"The chance that a ray which meets the cell also meets a half is the ratio of their surface areas.",
       "half_area() is given. The cost of the plane test counts once, whatever the halves hold."},
      {7, 0, 0, 9},
      200,
      false,
      {},
      {},
      {}};
  check.describe = [](const Case& at) {
    const Division d = division_of(at);
    return "cell (0 0 0) to (" + number(d.cell.hi.x) + " " + number(d.cell.hi.y) + " " + number(d.cell.hi.z) +
           "), split at " + "xyz"[d.axis] + std::string(" = ") + number(d.split) + ", " + std::to_string(d.below) +
           " below, " + std::to_string(d.above) + " above";
  };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Division d = division_of(at);
    const auto got = subject.ask<double>("split-cost", d.cell, d.axis, d.split, d.below, d.above);
    const auto area = [](Vec3d e) { return e.x * e.y + e.y * e.z + e.z * e.x; };  // exact: small quarters
    Vec3d below(d.cell.hi), above(d.cell.hi);
    below[d.axis] = d.split;
    above[d.axis] -= d.split;
    const double expected = 1 + 1.5 * (area(below) * d.below + area(above) * d.above) / area(Vec3d(d.cell.hi));
    // One division is rounded, and in another order of operations its neighbor may come out.
    if (std::fabs(got - expected) <= 4 * 0x1p-53 * expected) return std::nullopt;
    return Trouble{number(expected), number(got)};
  };
  return check;
}

Check sides_check() {
  Check check{"sides",
              "3. Who goes where",
              "A primitive that is on no side is lost; one that is on both without need makes the tree grow.",
              {"Four questions: all below, all above, across, in the plane. Which comparisons may be equal?"},
              {3, 0, 0, 3},
              300,
              false,
              {},
              {},
              {}};
  const auto extent = [](const Case& at) {
    return std::pair{std::min(at.head[0], at.head[1]), std::max(at.head[0], at.head[1])};
  };
  const auto text = [](int sides) {
    return sides == 0 ? "neither" : sides == 1 ? "below" : sides == 2 ? "above" : sides == 3 ? "both" : "no answer";
  };
  check.describe = [extent](const Case& at) {
    const auto [lo, hi] = extent(at);
    return "from " + std::to_string(lo) + " to " + std::to_string(hi) + ", split at " + std::to_string(at.head[2]);
  };
  check.ask = [extent, text](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto [lo, hi] = extent(at);
    const int split = at.head[2];
    const int expected = lo < split && hi > split ? 3 : hi > split ? 2 : 1;
    const int got = subject.ask<std::uint8_t>("sides", float(lo), float(hi), float(split));
    if (got == expected) return std::nullopt;
    return Trouble{text(expected), text(got)};
  };
  return check;
}

}  // namespace

Lab kd_tree_lab() {
  Lab lab{"10", "kd-tree", "Kd-tree", {"kd_tree.h"}, {}, picture_of_structure, "student::KdTree"};
  lab.checks = {split_cost_check(), sides_check()};
  for (Check& check : structure_checks({.walk = "5. The walk",
                      .construction = "4. The best plane",
                      .budget = "6. Is it good?",
                      .most_nodes = 28,
                      .most_candidates = 16.5})) {
    lab.checks.push_back(std::move(check));
  }
  return lab;
}

}  // namespace sightline::labs
