#include <gtest/gtest.h>

#include "tests/csg/exact_solid.h"
#include "tests/csg/random_solid.h"

namespace sightline {
namespace {

/// Of what a level promises, or for `fast` no more than that boundaries do not go back.
void expect_truth(const SolidTree& tree, const Solid& solid, const Ray<double>& ray) {
  const oracle::ExactSpans truth = oracle::exact_spans(tree, ray);
  for (const Level level : sure_levels) {
    EXPECT_EQ(oracle::fault_of(spans_of(solid, ray, level), truth, level), "")
        << info_of(level).name << ' ' << text_of(tree) << ' ' << text_of(ray);
  }
  const Spans rough = spans_of(solid, ray, Level::fast);
  for (std::size_t i = 1; i < rough.boundaries.size(); ++i) {
    EXPECT_LT(rough.boundaries[i - 1].t, rough.boundaries[i].t) << text_of(tree) << ' ' << text_of(ray);
  }
}

/// Of so many trees, each of which three rays are fired at.
std::size_t boundaries_of(const Dice& dice, int trees, const std::function<SolidTree(const Dice&)>& primitive) {
  std::size_t count = 0;
  for (int i = 0; i < trees && !testing::Test::HasFailure(); ++i) {
    const SolidTree tree = random_tree(dice, 1 + i % 4, primitive);
    const Solid solid(tree);
    for (int k = 0; k < 3; ++k) {
      const Ray<double> ray = lattice_ray(dice);
      expect_truth(tree, solid, ray);
      count += oracle::exact_spans(tree, ray).ends.size();
    }
  }
  return count;
}

/// Shared planes, tangent spheres, equal parts, rays through vertices, along edges and in faces.
TEST(Oracle, AgreesOnTenThousandTrees) {
  Random random(4);
  EXPECT_GT(boundaries_of(dice_of(random), 10'000, lattice_primitive), 20'000u);
}

/// Cylinders, cones, quadrics and convex meshes as well, turned and moved.
TEST(Oracle, AgreesOnOtherShapes) {
  Random random(5);
  const auto known = [](const Dice& dice) {
    SolidTree tree = any_primitive(dice);
    while (std::holds_alternative<Torus>(tree.shape)) tree = any_primitive(dice);
    return tree;
  };
  EXPECT_GT(boundaries_of(dice_of(random), 3'000, known), 6'000u);
}

}  // namespace
}  // namespace sightline
