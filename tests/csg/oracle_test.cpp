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

/// Shared planes, tangent spheres, equal parts, rays through vertices, along edges and in faces.
TEST(Oracle, AgreesOnTenThousandTrees) {
  Random random(4);
  const Dice dice = dice_of(random);
  std::size_t ends = 0;
  for (int i = 0; i < 10'000 && !testing::Test::HasFailure(); ++i) {
    const SolidTree tree = random_tree(dice, 1 + i % 4, lattice_primitive);
    const Solid solid(tree);
    for (int k = 0; k < 3; ++k) {
      const Ray<double> ray = lattice_ray(dice);
      expect_truth(tree, solid, ray);
      ends += oracle::exact_spans(tree, ray).ends.size();
    }
  }
  EXPECT_GT(ends, 20'000u);
}

}  // namespace
}  // namespace sightline
