#include "sightline/scene/solids.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sightline/csg/evaluator.h"
#include "sightline/math/random.h"

namespace sightline {
namespace {

std::vector<Boundary> boundaries_of(const Solid& solid, const Ray<double>& ray) {
  NoSolidProbe probe;
  SolidEvaluator<Level::exact> evaluator(solid, ray, probe);
  const SpanList list = evaluator.spans();
  const auto boundaries = evaluator[list];
  return {boundaries.begin(), boundaries.end()};
}

TEST(Solids, AllAreThere) {
  for (const SolidInfo& info : solid_infos()) {
    const Solid solid(load_solid(std::string(info.name)));
    const auto boundaries = boundaries_of(solid, {{info.origin[0], info.origin[1], info.origin[2]},
                                                  {info.direction[0], info.direction[1], info.direction[2]}});
    EXPECT_EQ(boundaries.empty(), info.name == "nothing") << info.name;
    EXPECT_EQ(&solid_info(std::string(info.name) + ":x"), &info);
  }
}

TEST(Solids, RefusesWhatThereIsNot) {
  for (const char* spec : {"", "octopus", "widgets", "widget:1", "menger:0", "menger:5", "menger:", "menger:2x",
                           "swiss-cheese:0", "swiss-cheese:4097", "lens:"}) {
    EXPECT_THROW(load_solid(spec), std::invalid_argument) << spec;
  }
  try {
    load_solid("octopus");
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    for (const SolidInfo& info : solid_infos()) EXPECT_NE(text.find(info.name), std::string::npos) << info.name;
  }
}

/// By the ternary digits of a place in the cube: two ones at one place are a hole.
bool is_in_sponge(Vec3d p, int levels) {
  p = 0.5 * (p + Vec3d(1));
  for (int level = 0; level < levels; ++level) {
    p *= 3.0;
    int ones = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double digit = std::floor(p[axis]);
      ones += digit == 1;
      p[axis] -= digit;
    }
    if (ones >= 2) return false;
  }
  return true;
}

TEST(Solids, MengersSpongeHasItsHoles) {
  Random random(5);
  for (int levels = 1; levels <= 3; ++levels) {
    const SolidTree tree = load_solid("menger:" + std::to_string(levels));
    EXPECT_EQ(tree.args.size(), 1u + (levels > 0 ? 3 : 0) + (levels > 1 ? 24 : 0) + (levels > 2 ? 192 : 0));
    const Solid solid(tree);
    int inside = 0;
    for (int i = 0; i < 600; ++i) {
      const auto number = [&] { return 2 * random.uniform_double() - 1; };
      const Vec3d p(number(), number(), number());
      int before = 0;
      for (const Boundary& boundary : boundaries_of(solid, {p, {number(), number(), number()}}))
        before += boundary.t < 0;
      EXPECT_EQ(before % 2 != 0, is_in_sponge(p, levels));
      inside += before % 2;
    }
    EXPECT_NEAR(inside / 600.0, std::pow(20.0 / 27, levels), 0.1);
  }
}

TEST(Solids, HolesOfCheeseAreTheSameEverywhere) {
  const SolidTree cheese = load_solid("swiss-cheese:3");
  ASSERT_EQ(cheese.args.size(), 4u);
  EXPECT_EQ(cheese.args[1].shape, load_solid("swiss-cheese:3").args[1].shape);
  EXPECT_EQ(load_solid("swiss-cheese").args.size(), 13u);
}

}  // namespace
}  // namespace sightline
