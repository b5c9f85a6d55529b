#pragma once

#include <array>

namespace sightline {

/// A real root: |exact - t| <= radius, where radii are proven (levels precise and exact) and 0 elsewhere.
struct Root {
  double t;
  double radius;
  int multiplicity;
};

/// The distinct real roots of a polynomial of degree at most 4, in ascending order.
struct RootList {
  std::array<Root, 4> roots;
  int count = 0;
  bool begins_negative = false;  ///< The polynomial's sign far below all roots; without roots, whether it is <= 0.
  bool is_certain = true;        ///< Number, order, multiplicities and the first sign are proven, or taken as computed.

  void add(const Root& root) { roots[static_cast<std::size_t>(count++)] = root; }
};

}  // namespace sightline
