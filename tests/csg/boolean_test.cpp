#include "sightline/csg/boolean.h"

#include <gtest/gtest.h>

#include <array>

namespace sightline {
namespace {

enum class Outcome { enter, leave, discard };

/// Of one operation; whether the normal is flipped matters where something is entered or left.
struct Expected {
  Outcome outcome;
  bool is_flipped = false;
};
constexpr Expected none{Outcome::discard}, enter{Outcome::enter}, leave{Outcome::leave};
constexpr Expected enter_flipped{Outcome::enter, true}, leave_flipped{Outcome::leave, true};

struct Row {
  bool was_in_a, is_in_a, was_in_b, is_in_b;
  Expected unite, intersect, subtract, differ;
};

/// The table of the course: what a ray does that goes from (wasInA, wasInB) to (isInA, isInB). Where both change, the
/// normal is that of A.
// clang-format off
constexpr std::array<Row, 16> table{{
    // A: was, is; B: was, is
    //            A | B  A & B  A - B          A ^ B
    {0, 0, 0, 0, none,  none,  none,           none},
    {0, 0, 0, 1, enter, none,  none,           enter},
    {0, 0, 1, 0, leave, none,  none,           leave},
    {0, 0, 1, 1, none,  none,  none,           none},
    {0, 1, 0, 0, enter, none,  enter,          enter},
    {0, 1, 0, 1, enter, enter, none,           none},
    {0, 1, 1, 0, none,  none,  enter,          none},
    {0, 1, 1, 1, none,  enter, none,           leave_flipped},
    {1, 0, 0, 0, leave, none,  leave,          leave},
    {1, 0, 0, 1, none,  none,  leave,          none},
    {1, 0, 1, 0, leave, leave, none,           none},
    {1, 0, 1, 1, none,  leave, none,           enter_flipped},
    {1, 1, 0, 0, none,  none,  none,           none},
    {1, 1, 0, 1, none,  enter, leave_flipped,  leave_flipped},
    {1, 1, 1, 0, none,  leave, enter_flipped,  enter_flipped},
    {1, 1, 1, 1, none,  none,  none,           none},
}};
// clang-format on

void check(Operation operation, const Transition& step, const Expected& expected) {
  const bool was = was_inside(operation, step), is = is_inside(operation, step);
  const Outcome outcome = !is_kept(operation, step) ? Outcome::discard : is ? Outcome::enter : Outcome::leave;
  EXPECT_EQ(outcome, expected.outcome);
  EXPECT_EQ(was == is, expected.outcome == Outcome::discard);
  if (was != is) {
    EXPECT_EQ(flips_normal(operation, step, step.was_in_a != step.is_in_a), expected.is_flipped);
  }
}

TEST(Boolean, IsTheTableOfTheCourse) {
  for (const Row& row : table) {
    SCOPED_TRACE(testing::Message() << "was in A " << row.was_in_a << ", is in A " << row.is_in_a << ", was in B "
                                    << row.was_in_b << ", is in B " << row.is_in_b);
    const Transition step{row.was_in_a, row.is_in_a, row.was_in_b, row.is_in_b};
    check(Operation::unite, step, row.unite);
    check(Operation::intersect, step, row.intersect);
    check(Operation::subtract, step, row.subtract);
    check(Operation::differ, step, row.differ);
  }
}

/// Faces that coincide look the same way where both operands are entered, and opposite ways where one is left.
TEST(Boolean, TakesEitherOfCoincidentBoundaries) {
  const Transition into_both{false, true, false, true}, out_of_both{true, false, true, false};
  for (const Operation operation : {Operation::unite, Operation::intersect}) {
    EXPECT_FALSE(flips_normal(operation, into_both, false));
    EXPECT_FALSE(flips_normal(operation, out_of_both, false));
  }
  EXPECT_TRUE(flips_normal(Operation::subtract, {false, true, true, false}, false));
  EXPECT_TRUE(flips_normal(Operation::subtract, {true, false, false, true}, false));
}

TEST(Boolean, HasEachRowOnce) {
  std::array<int, 16> seen{};
  for (const Row& row : table) ++seen[8 * row.was_in_a + 4 * row.is_in_a + 2 * row.was_in_b + row.is_in_b];
  for (const int count : seen) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace sightline
