#pragma once
/// Where a leaf's candidates are tested in relation to the loop over nodes.

#include "sightline/accel/accelerator.h"

namespace sightline::detail {

template <class T, class Visit>
[[gnu::noinline]] T visit_apart(Visit& visit, LeafRange leaf) {
  return visit(leaf);
}

/// The nearest hit is looked for out of the way of the loop over nodes, which needs the registers for itself; any hit
/// needs fewer. For loops with many numbers in hand: measured, it gains a box-tree 5 % and costs a kd-tree 3 %.
template <class T, class Visit>
T visit_leaf(Visit& visit, LeafRange leaf) {
  if constexpr (takes_any_order<Visit>) return visit(leaf);
  return visit_apart<T>(visit, leaf);
}

}  // namespace sightline::detail
