#pragma once
/// Boolean operations on what a ray passes through, as the state machine that constructive solid geometry is taught by.
/// Roth, "Ray Casting for Modeling Solids", 1982; Goldstein and Nagel, "3-D Visual Simulation", 1971.

#include <array>
#include <string_view>

namespace sightline {

enum class Operation {
  unite,      ///< In A or in B.
  intersect,  ///< In A and in B.
  subtract,   ///< In A and not in B.
  differ,     ///< In one of both, not in both.
};

struct OperationInfo {
  Operation operation;
  std::string_view name;  ///< In files.
  std::string_view sign;  ///< In tables.
};
inline constexpr std::array<OperationInfo, 4> operation_infos{{
    {Operation::unite, "union", "A | B"},
    {Operation::intersect, "inter", "A & B"},
    {Operation::subtract, "diff", "A - B"},
    {Operation::differ, "xor", "A ^ B"},
}};

/// Whether a point is in the result, given whether it is in the operands.
constexpr bool is_inside(Operation operation, bool is_in_a, bool is_in_b) {
  switch (operation) {
    case Operation::unite:
      return is_in_a || is_in_b;
    case Operation::intersect:
      return is_in_a && is_in_b;
    case Operation::subtract:
      return is_in_a && !is_in_b;
    case Operation::differ:
      return is_in_a != is_in_b;
  }
  return false;
}

/// What happens at one place of a ray: where it was just before, and where it is just after. Operands whose boundaries
/// coincide both change in one transition.
struct Transition {
  bool was_in_a, is_in_a, was_in_b, is_in_b;

  friend bool operator==(const Transition&, const Transition&) = default;
};

constexpr bool was_inside(Operation operation, const Transition& t) {
  return is_inside(operation, t.was_in_a, t.was_in_b);
}
constexpr bool is_inside(Operation operation, const Transition& t) {
  return is_inside(operation, t.is_in_a, t.is_in_b);
}

/// A transition is kept where it enters or leaves the result, and discarded where that goes on, in or out: so slivers
/// of no length vanish, and parts that abut are one. For the difference A - B:
///   kept = (wasInA and not wasInB) differs from (isInA and not isInB).
constexpr bool is_kept(Operation operation, const Transition& t) {
  return was_inside(operation, t) != is_inside(operation, t);
}

/// Whether the normal of A's boundary, else of B's, points into the result at a kept transition: where the operand is
/// left as the result is entered, and the other way round. Where both change, either's boundary is the result's.
constexpr bool flips_normal(Operation operation, const Transition& t, bool is_from_a) {
  return (is_from_a ? t.is_in_a : t.is_in_b) != is_inside(operation, t);
}

}  // namespace sightline
