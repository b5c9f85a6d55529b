#include "viz/build/object_replay.h"

namespace sightline::viz {

Straddlers::Straddlers(std::span<const BoundsReference> items) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const BoundsReference& item : items) {
      lows_[axis].push_back(item.box.lo[axis]);
      highs_[axis].push_back(item.box.hi[axis]);
    }
    std::sort(lows_[axis].begin(), lows_[axis].end());
    std::sort(highs_[axis].begin(), highs_[axis].end());
  }
}

std::uint32_t Straddlers::at(int axis, double place) const {
  const auto begun = std::partition_point(lows_[axis].begin(), lows_[axis].end(), [&](float x) { return x < place; });
  const auto over = std::partition_point(highs_[axis].begin(), highs_[axis].end(), [&](float x) { return x <= place; });
  const auto count = (begun - lows_[axis].begin()) - (over - highs_[axis].begin());
  return static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(0, count));  // flat boxes in the plane are over, not begun
}

std::string object_reason(const ObjectOutcome& outcome, const ObjectSplitCosts& costs, bool is_deep) {
  const std::string most = std::to_string(costs.max_leaf_size);
  if (!outcome.is_divided) {
    if (outcome.leaf_cost < 2) return "stays a leaf: it holds one triangle";
    if (costs.is_leaf_at_once(static_cast<std::uint32_t>(outcome.leaf_cost))) {
      return "stays a leaf: at the quality fast, " + most + " triangles or fewer are not weighed";
    }
    if (is_deep || outcome.candidates.empty()) return "stays a leaf: it holds no more than " + most + " triangles";
    return "stays a leaf for " + cost_text(outcome.leaf_cost) + ": no cut costs less";
  }
  if (outcome.is_median) {
    return std::string("is halved by number: ") +
           (is_deep ? "it lies deeper than costs are asked" : "all centers are in one place");
  }
  const BuildCandidate& taken = outcome.candidates[*outcome.chosen];
  const bool had_choice = outcome.leaf_cost <= costs.max_leaf_size;
  return "splits at " + place_text(taken.axis, taken.position) + " for " + cost_text(taken.cost) +
         " triangle tests, a leaf would cost " + cost_text(outcome.leaf_cost) +
         (had_choice ? "" : " and may hold " + most + " triangles at most");
}

}  // namespace sightline::viz
