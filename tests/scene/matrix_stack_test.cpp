#include "sightline/scene/matrix_stack.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sightline/math/random.h"
#include "tests/math/exact.h"

namespace sightline {
namespace {

void step(MatrixStack& stack, Random& random) {
  const auto number = [&] { return 2 * random.uniform_double() - 1; };
  switch (random.below(3)) {
    case 0:
      return stack.translate({number(), number(), number()});
    case 1:
      return stack.rotate({number(), number(), 1}, 360 * number());
    default:
      return stack.scale({1 + 0.5 * number(), -1 + 0.5 * number(), 1});
  }
}

/// mat-pop-inverse.
TEST(MatrixStack, PopRestoresBitForBit) {
  Random random(1);
  MatrixStack stack;
  for (int i = 0; i < 10; ++i) step(stack, random);
  const Transform kept = stack.current();
  for (int i = 0; i < 100'000; ++i) {
    stack.push();
    step(stack, random);
    ASSERT_NE(stack.current(), kept);
    stack.pop();
    ASSERT_EQ(stack.current(), kept) << "pop " << i;
  }
  std::vector<Transform> all;
  for (int i = 0; i < 1000; ++i) {
    all.push_back(stack.current());
    stack.push();
    step(stack, random);
  }
  for (; !all.empty(); all.pop_back()) {
    stack.pop();
    ASSERT_EQ(stack.current(), all.back());
  }
  EXPECT_EQ(stack.depth(), 0u);
  EXPECT_THROW(stack.pop(), std::logic_error);
}

/// M_person * M_torso * M_arm * M_hand * M_finger, of whole numbers and quarter turns, which are not rounded.
TEST(MatrixStack, StepsAreDoneWithinWhatIsCurrent) {
  MatrixStack stack;
  stack.translate({10, 0, 0});
  stack.rotate({0, 0, 1}, 90);
  stack.scale({2, 3, 4});
  EXPECT_EQ(stack.current().point({1, 1, 1}), Vec3d(10 - 3, 2, 4));
  EXPECT_EQ(stack.current(), Transform::translation({10, 0, 0}) * Transform::rotation(Vec3d(0, 0, 1), 90) *
                                 Transform::scaling({2, 3, 4}));
}

/// The inverse comes from no inversion, and stays one: the product with the matrix is 1 but for the roundings of 30
/// steps, each at most 4 units of the sums of the factors' sizes.
TEST(MatrixStack, TheInverseComesAlong) {
  Random random(2);
  for (int round = 0; round < 100; ++round) {
    MatrixStack stack;
    for (int i = 0; i < 30; ++i) step(stack, random);
    const exact::Map matrix(stack.current().matrix()), inverse(stack.current().inverse());
    const exact::Map one(inverse, matrix);
    exact::Rational size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t j = 0; j < 3; ++j)
          size = std::max<exact::Rational>(size, abs(inverse.rows[i][j] * matrix.rows[j][k]));
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        ASSERT_LE(abs(one.rows[i][k] - exact::Rational(i == k)), (size + 1) * exact::Rational(0x1p-40))
            << "round " << round;
      }
    }
  }
}

TEST(MatrixStack, ScopesRestoreHoweverTheyAreLeft) {
  MatrixStack stack;
  stack.translate({1, 2, 3});
  const Transform kept = stack.current();
  {
    const auto scope = stack.scope();
    stack.rotate({1, 1, 1}, 33);
    stack.push();
    stack.push();
  }
  EXPECT_EQ(stack.current(), kept);
  EXPECT_EQ(stack.depth(), 0u);
  try {
    const auto scope = stack.scope();
    stack.scale({2, 0, 1});
    FAIL() << "expected a singular scaling to be refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("other than 0"), std::string::npos);
  }
  EXPECT_EQ(stack.current(), kept);
}

}  // namespace
}  // namespace sightline
