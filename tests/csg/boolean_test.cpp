#include "sightline/csg/boolean.h"

#include <gtest/gtest.h>

#include <array>

namespace sightline {
namespace {

enum class Outcome { enter, leave, discard };
enum class Normal { kept, flipped };
constexpr Outcome enter = Outcome::enter, leave = Outcome::leave, discard = Outcome::discard;
constexpr Normal kept = Normal::kept, flipped = Normal::flipped;

/// Of one operation; normals matter where something is entered or left.
struct Expected {
  Outcome outcome;
  Normal normal = kept;
};
struct Row {
  bool was_in_a, is_in_a, was_in_b, is_in_b;
  Expected unite, intersect, subtract, differ;
};

/// The table of the course: what a ray does that goes from (wasInA, wasInB) to (isInA, isInB). Where both change, the
/// normal is that of A.
constexpr std::array<Row, 16> table{{
    // A: was, is; B: was, is    A | B             A & B             A - B             A ^ B
    {0, 0, 0, 0, /**/ {discard}, /*    */ {discard}, /**/ {discard}, /*       */ {discard}},
    {0, 0, 0, 1, /**/ {enter, kept}, /**/ {discard}, /**/ {discard}, /*       */ {enter, kept}},
    {0, 0, 1, 0, /**/ {leave, kept}, /**/ {discard}, /**/ {discard}, /*       */ {leave, kept}},
    {0, 0, 1, 1, /**/ {discard}, /*    */ {discard}, /**/ {discard}, /*       */ {discard}},
    {0, 1, 0, 0, /**/ {enter, kept}, /**/ {discard}, /**/ {enter, kept}, /*   */ {enter, kept}},
    {0, 1, 0, 1, /**/ {enter, kept}, /**/ {enter, kept}, {discard}, /*        */ {discard}},
    {0, 1, 1, 0, /**/ {discard}, /*    */ {discard}, /**/ {enter, kept}, /*   */ {discard}},
    {0, 1, 1, 1, /**/ {discard}, /*    */ {enter, kept}, {discard}, /*        */ {leave, flipped}},
    {1, 0, 0, 0, /**/ {leave, kept}, /**/ {discard}, /**/ {leave, kept}, /*   */ {leave, kept}},
    {1, 0, 0, 1, /**/ {discard}, /*    */ {discard}, /**/ {leave, kept}, /*   */ {discard}},
    {1, 0, 1, 0, /**/ {leave, kept}, /**/ {leave, kept}, {discard}, /*        */ {discard}},
    {1, 0, 1, 1, /**/ {discard}, /*    */ {leave, kept}, {discard}, /*        */ {enter, flipped}},
    {1, 1, 0, 0, /**/ {discard}, /*    */ {discard}, /**/ {discard}, /*       */ {discard}},
    {1, 1, 0, 1, /**/ {discard}, /*    */ {enter, kept}, {leave, flipped}, /* */ {leave, flipped}},
    {1, 1, 1, 0, /**/ {discard}, /*    */ {leave, kept}, {enter, flipped}, /* */ {enter, flipped}},
    {1, 1, 1, 1, /**/ {discard}, /*    */ {discard}, /**/ {discard}, /*       */ {discard}},
}};

void check(Operation operation, const Transition& step, const Expected& expected) {
  const bool was = was_inside(operation, step), is = is_inside(operation, step);
  const Outcome outcome = !is_kept(operation, step) ? discard : is ? enter : leave;
  EXPECT_EQ(outcome, expected.outcome);
  EXPECT_EQ(was == is, expected.outcome == discard);
  if (expected.outcome != discard) {
    EXPECT_EQ(flips_normal(operation, step), expected.normal == flipped);
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

/// Of transitions that change both and are kept, A's boundary stays: the table's normals are those of A.
TEST(Boolean, TakesTheFirstOfCoincidentBoundaries) {
  for (const Row& row : table) {
    EXPECT_EQ(is_from_a({row.was_in_a, row.is_in_a, row.was_in_b, row.is_in_b}), row.was_in_a != row.is_in_a);
  }
}

TEST(Boolean, HasEachRowOnce) {
  std::array<int, 16> seen{};
  for (const Row& row : table) ++seen[8 * row.was_in_a + 4 * row.is_in_a + 2 * row.was_in_b + row.is_in_b];
  for (const int count : seen) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace sightline
