/// Trees of curved and flat shapes as whole lines of JSON, against the exact oracle of solids.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/csg/exact_solid.h"
#include "tests/csg/random_solid.h"
#include "viz/probe/answer.h"

namespace sightline {
namespace {

using nlohmann::json;

json list(const Vec3d& v) { return {v.x, v.y, v.z}; }

struct ShapeText {
  json operator()(const solid::HalfSpace& s) const {
    return {{"prim", "half"}, {"n", list(s.normal)}, {"w", s.offset}};
  }
  json operator()(const solid::Sphere& s) const { return {{"prim", "sphere"}, {"c", list(s.center)}, {"r", s.radius}}; }
  json operator()(const solid::Box& s) const { return {{"prim", "box"}, {"lo", list(s.lo)}, {"hi", list(s.hi)}}; }
  json operator()(const solid::Cylinder& s) const {
    return {{"prim", "cylinder"}, {"p", list(s.base)}, {"q", list(s.top)}, {"r", s.radius}};
  }
  json operator()(const solid::Cone& s) const {
    return {{"prim", "cone"}, {"p", list(s.apex)}, {"q", list(s.base)}, {"r", s.radius}};
  }
  json operator()(const solid::Quadric& s) const { return {{"prim", "quadric"}, {"q", s.coefficients}}; }
  json operator()(const Torus& s) const {
    return {{"prim", "torus"}, {"c", list(s.center)}, {"a", list(s.axis)}, {"R", s.major}, {"r", s.minor}};
  }
  json operator()(const std::shared_ptr<const ClosedMesh>& s) const {
    json vertices = json::array();
    for (const Vec3d& v : s->vertices()) vertices.push_back(list(v));
    return {{"prim", "mesh"}, {"v", vertices}, {"f", s->triangles()}};
  }
};

json text_of_node(const SolidTree& tree) {
  if (tree.kind == SolidTree::Kind::primitive) return std::visit(ShapeText(), tree.shape);
  json args = json::array();
  for (const SolidTree& arg : tree.args) args.push_back(text_of_node(arg));
  const bool is_complement = tree.kind == SolidTree::Kind::complement;
  const auto& info = operation_infos[static_cast<std::size_t>(tree.operation)];
  return {{"op", is_complement ? "compl" : std::string(info.name)}, {"args", args}};
}

/// What an answer says; bounds of its own it has none.
Spans spans_of_answer(const json& answer) {
  Spans spans;
  for (const json& interval : answer["intervals"]) {
    for (const json& end : interval) {
      if (end == "-inf") spans.begins_inside = true;
      if (!end.is_number()) continue;
      Boundary boundary;
      boundary.t = end.get<double>();
      boundary.radius = std::fabs(boundary.t);
      spans.boundaries.push_back(boundary);
    }
  }
  return spans;
}

/// That its intervals are those, of the first end at t >= 0, and that "inf" stands where there is no end.
void expect_truth(const json& answer, const oracle::ExactSpans& truth, Level level, const std::string& question) {
  const Spans spans = spans_of_answer(answer);
  ASSERT_EQ(oracle::fault_of(spans, truth, level), "") << info_of(level).name << ' ' << question << ' ' << answer;
  const bool ends_inside = truth.begins_inside != (truth.ends.size() % 2 == 1);
  const json& intervals = answer["intervals"];
  ASSERT_EQ(!intervals.empty() && intervals.back()[1] == "inf", ends_inside) << question << ' ' << answer;
  for (const json& interval : intervals) ASSERT_EQ(interval.size(), 2u) << question << ' ' << answer;
  std::size_t first = 0;
  while (first < truth.ends.size() && truth.ends[first].compare(oracle::Binary(0.0)) < 0) ++first;
  const json expected = first < truth.ends.size() ? json(spans.boundaries[first].t) : json();
  ASSERT_EQ(answer["t_first"], expected) << info_of(level).name << ' ' << question << ' ' << answer;
}

std::size_t ends_of(std::uint64_t seed, int trees, const std::function<SolidTree(const Dice&)>& primitive) {
  Random random(seed);
  const Dice dice = dice_of(random);
  std::size_t count = 0;
  for (int i = 0; i < trees && !testing::Test::HasFailure(); ++i) {
    const SolidTree tree = random_tree(dice, 1 + i % 4, primitive);
    const json node = text_of_node(tree);
    for (int k = 0; k < 3; ++k) {
      const Ray<double> ray = lattice_ray(dice);
      const json question{{"id", i}, {"ray", {{"o", list(ray.origin)}, {"d", list(ray.direction)}}}, {"tree", node}};
      const oracle::ExactSpans truth = oracle::exact_spans(tree, ray);
      count += truth.ends.size();
      for (const Level level : sure_levels) {
        const probe::Answer answer = probe::answer(question.dump(), 1, level);
        EXPECT_TRUE(answer.is_good) << question << ' ' << answer.text;
        if (answer.is_good) expect_truth(json::parse(answer.text), truth, level, question.dump());
      }
    }
  }
  return count;
}

/// Boxes, spheres and half-spaces that share faces, touch, and are cut along edges.
TEST(ProbeTrees, OfLatticeShapesAreExact) { EXPECT_GT(ends_of(21, 3'000, lattice_primitive), 6'000u); }

TEST(ProbeTrees, OfOtherShapesAreExact) {
  const auto known = [](const Dice& dice) {
    constexpr std::array kinds{0, 1, 2, 3, 3, 4, 4, 5, 7};  // all but tori
    return primitive_of_kind(kinds[static_cast<std::size_t>(dice(kinds.size()))], dice);
  };
  EXPECT_GT(ends_of(22, 1'500, known), 3'000u);
}

}  // namespace
}  // namespace sightline
