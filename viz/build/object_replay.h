#pragma once
/// What is weighed where primitives, not space, are divided: by the sorted row of their boxes, or by bins.

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>
#include <vector>

#include "sightline/accel/object_split.h"
#include "sightline/accel/object_sweep.h"
#include "sightline/accel/reference_sweep.h"
#include "viz/build/replay.h"

namespace sightline::viz {

/// How many of some boxes lie on both sides of a plane.
class Straddlers {
 public:
  explicit Straddlers(std::span<const BoundsReference> items);
  std::uint32_t at(int axis, double place) const;

 private:
  std::array<std::vector<float>, 3> lows_, highs_;
};

/// References at a node, in the order in which the builder has them there.
struct ObjectState {
  std::vector<BoundsReference> items;
  bool is_swept = false;  ///< Divided by ObjectSweep from here on, whose order `items` keep.
};

/// What the builder did with a state, and what it weighed.
struct ObjectOutcome {
  std::vector<BuildCandidate> candidates;
  std::optional<std::size_t> chosen;
  bool is_divided = false, is_median = false;
  double leaf_cost = 0, cost = 0;
  ObjectState below, above;
  std::string how;
};

/// Asks the library's own dividers for each state, and weighs their candidates beside them.
template <class Area>
class ObjectReplay {
 public:
  static constexpr int heuristic_depth = 48;  ///< Below, parts are halved: V3 of bounding_volume_tree.h.

  explicit ObjectReplay(const ObjectSplitCosts& costs) : costs_(costs) {}

  ObjectState root(std::span<const BoundsReference> references) const {
    ObjectState state{{references.begin(), references.end()}, false};
    if (costs_.quality == Quality::best) {
      for (std::uint32_t i = 0; i < state.items.size(); ++i) state.items[i].number = i;
    }
    return settled(std::move(state));
  }

  /// \throws ReplayError where the cheapest candidate is not what the library took.
  ObjectOutcome divide(const ObjectState& state, int depth) const {
    if (state.items.empty()) return {};
    ObjectOutcome outcome =
        !state.is_swept && costs_.quality != Quality::best ? by_bins(state, depth) : by_row(state, depth);
    if (outcome.is_divided) {
      outcome.below = settled(std::move(outcome.below));
      outcome.above = settled(std::move(outcome.above));
    }
    return outcome;
  }

 private:
  using Sweep = ObjectSweep<Area>;

  /// As `grow` of the builders: few references are swept, in the order in which they come there.
  ObjectState settled(ObjectState state) const {
    if (state.is_swept || costs_.quality == Quality::fast || state.items.size() > Sweep::most) return state;
    if (costs_.quality == Quality::best) {  // ReferenceSweep hands them over in the order along x
      const std::vector<std::uint32_t> order = row_along(state.items, 0);
      std::vector<BoundsReference> sorted;
      for (const std::uint32_t i : order) sorted.push_back(state.items[i]);
      state.items = std::move(sorted);
    }
    state.is_swept = true;
    return state;
  }

  /// By center, then by place: as both sweeps sort.
  static std::vector<std::uint32_t> row_along(std::span<const BoundsReference> items, int axis) {
    std::vector<std::uint32_t> order(items.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return ReferenceCenter::on(items[a], axis) < ReferenceCenter::on(items[b], axis);
    });
    return order;
  }

  double per_test(const ScaledArea<Area>& area, double weight) const {
    return costs_.inner_node / costs_.primitive + (area.whole() > 0 ? weight / area.whole() : 0);
  }

  // ---- Rows of boxes, one reference each

  ObjectOutcome by_row(const ObjectState& state, int depth) const {
    const auto count = static_cast<std::uint32_t>(state.items.size());
    ObjectOutcome outcome;
    outcome.leaf_cost = count;
    outcome.how = "every cut of the triangles' boxes, sorted by their centers along each axis (sweep)";
    const Aabb box = bounds_of(state.items).box.box();
    const ScaledArea<Area> area(box);
    const std::array<std::vector<std::uint32_t>, 3> rows{row_along(state.items, 0), row_along(state.items, 1),
                                                         row_along(state.items, 2)};
    const Straddlers straddlers(state.items);
    ObjectCut best;
    for (int axis = 0; axis < 3; ++axis) weigh_row(state, rows[axis], axis, area, straddlers, best, outcome);

    const auto halves = library_halves(state, depth);
    outcome.is_divided = halves.has_value();
    if (!halves) return outcome;
    outcome.is_median = depth >= heuristic_depth || best.place == 0;
    const bool is_forced_pair = state.is_swept && !outcome.is_median && count == 2 && costs_.max_leaf_size == 1;
    int axis = best.axis, place = best.place;
    if (outcome.is_median) axis = box.longest_axis(), place = static_cast<int>(count / 2);
    if (is_forced_pair) axis = 0, place = 1;
    std::vector<bool> is_below(count);
    for (int i = 0; i < place; ++i) is_below[rows[axis][i]] = true;
    for (std::uint32_t i = 0; i < count; ++i) {
      (is_below[i] ? outcome.below : outcome.above).items.push_back(state.items[i]);
    }
    outcome.below.is_swept = outcome.above.is_swept = state.is_swept;
    expect(*halves, outcome);
    if (!outcome.is_median) {
      for (std::size_t i = 0; i < outcome.candidates.size(); ++i) {
        if (outcome.candidates[i].axis == axis && outcome.candidates[i].below == static_cast<std::uint32_t>(place)) {
          outcome.chosen = i;
          outcome.cost = outcome.candidates[i].cost;
        }
      }
    }
    return outcome;
  }

  void weigh_row(const ObjectState& state, const std::vector<std::uint32_t>& row, int axis,
                 const ScaledArea<Area>& area, const Straddlers& straddlers, ObjectCut& best,
                 ObjectOutcome& outcome) const {
    const std::size_t count = row.size();
    std::vector<Aabb> above(count + 1);
    for (std::size_t i = count; i-- > 0;) {
      above[i] = above[i + 1];
      above[i].extend(state.items[row[i]].box);
    }
    Aabb below;
    for (std::size_t place = 1; place < count; ++place) {
      below.extend(state.items[row[place - 1]].box);
      const auto low = static_cast<float>(place), high = static_cast<float>(count) - low;
      const float weight = area.of(below.extent()) * low + area.of(above[place].extent()) * high;
      best.improve({weight, std::fabs(low - high), axis, static_cast<int>(place)});
      const double at = ReferenceCenter::on(state.items[row[place]], axis);
      outcome.candidates.push_back({.axis = axis,
                                    .position = at,
                                    .cost = per_test(area, weight),
                                    .below = static_cast<std::uint32_t>(place),
                                    .above = static_cast<std::uint32_t>(count - place),
                                    .straddling = straddlers.at(axis, at)});
    }
  }

  struct LibraryHalves {
    std::array<std::vector<std::uint32_t>, 2> ids;
    std::array<Aabb, 2> boxes;
  };

  template <class Halves>
  static std::optional<LibraryHalves> listed(const std::optional<Halves>& halves) {
    if (!halves) return std::nullopt;
    LibraryHalves listed;
    const auto list = [&](const auto& part, int side) {
      for (std::uint32_t i = 0; i < part.count(); ++i) listed.ids[side].push_back(part.id(i));
      listed.boxes[side] = part.box();
    };
    list(halves->below, 0);
    list(halves->above, 1);
    return listed;
  }

  std::optional<LibraryHalves> library_halves(const ObjectState& state, int depth) const {
    if (state.is_swept) {
      Sweep sweep(state.items, costs_);
      return listed(depth < heuristic_depth ? sweep.cheapest(sweep.whole()) : sweep.median(sweep.whole()));
    }
    LargeBuffer<BoundsReference> items(state.items.size());
    std::copy(state.items.begin(), state.items.end(), items.data());
    ReferenceSweep<Area> sweep(std::move(items), costs_);
    return listed(depth < heuristic_depth ? sweep.cheapest(sweep.whole()) : sweep.median(sweep.whole()));
  }

  static void expect(const LibraryHalves& halves, const ObjectOutcome& outcome) {
    for (const int side : {0, 1}) {
      const ObjectState& state = side == 0 ? outcome.below : outcome.above;
      std::vector<std::uint32_t> ids, library = halves.ids[side];
      for (const BoundsReference& item : state.items) ids.push_back(item.id);
      std::sort(ids.begin(), ids.end());
      std::sort(library.begin(), library.end());
      if (ids != library) throw ReplayError("the cheapest cut is not the one that the library makes");
    }
  }

  // ---- Bins

  /// As ObjectSplitter: the number of bins and where they lie.
  struct Bins {
    int count, first_axis, end_axis;
    CenterBounds centers;

    double edge(int axis, int place) const {
      return centers.lo()[axis] + double(place) * (double(centers.hi()[axis]) - centers.lo()[axis]) / count;
    }
    int bin_of(const BoundsReference& item, int axis) const {
      const float scale = static_cast<float>(count) / (centers.hi()[axis] - centers.lo()[axis]);
      const float place = (ReferenceCenter::on(item, axis) - centers.lo()[axis]) * scale;
      return static_cast<int>(std::min(place > 0 ? place : 0.0f, static_cast<float>(count - 1)));
    }
  };

  Bins bins_of(const ReferenceBounds& bounds, std::size_t size) const {
    constexpr std::size_t many = 1024;
    constexpr int few_bins = 16;
    const bool is_fast = costs_.quality == Quality::fast;
    const int widest = bounds.centers.longest_axis();
    return {size < many ? std::min(costs_.bins, few_bins) : costs_.bins, is_fast ? widest : 0, is_fast ? widest + 1 : 3,
            bounds.centers};
  }

  ObjectOutcome by_bins(const ObjectState& state, int depth) const {
    std::vector<BoundsReference> items = state.items;
    const ReferenceSet set{items, bounds_of(items)};
    const ScaledArea<Area> area(set.box());
    const Bins bins = bins_of(set.bounds, items.size());
    ObjectOutcome outcome;
    outcome.leaf_cost = static_cast<double>(items.size());
    outcome.how = std::to_string(bins.count) + " bins over the triangles' centers along " +
                  (bins.end_axis - bins.first_axis == 1 ? "the widest axis" : "each axis") + "; a cut between any two";
    const Straddlers straddlers(items);
    ObjectCut best;
    for (int axis = bins.first_axis; axis < bins.end_axis; ++axis) {
      weigh_bins(items, bins, axis, area, straddlers, best, outcome);
    }
    const ObjectSplitter<Area> splitter(costs_);
    const auto halves = depth < heuristic_depth ? splitter.cheapest(set) : splitter.median(set);
    outcome.is_divided = halves.has_value();
    if (!halves) return outcome;
    outcome.is_median = depth >= heuristic_depth || best.place == 0;
    outcome.below.items.assign(halves->below.items.begin(), halves->below.items.end());
    outcome.above.items.assign(halves->above.items.begin(), halves->above.items.end());
    if (outcome.is_median) return outcome;
    for (std::size_t i = 0; i < outcome.candidates.size(); ++i) {
      const BuildCandidate& candidate = outcome.candidates[i];
      if (candidate.axis == best.axis && candidate.position == bins.edge(best.axis, best.place)) outcome.chosen = i;
    }
    if (!outcome.chosen || outcome.candidates[*outcome.chosen].below != halves->below.count()) {
      throw ReplayError("the cheapest cut between bins is not the one that the library makes");
    }
    outcome.cost = outcome.candidates[*outcome.chosen].cost;
    return outcome;
  }

  void weigh_bins(std::span<const BoundsReference> items, const Bins& bins, int axis, const ScaledArea<Area>& area,
                  const Straddlers& straddlers, ObjectCut& best, ObjectOutcome& outcome) const {
    std::vector<Aabb> boxes(bins.count);
    std::vector<std::uint32_t> counts(bins.count);
    for (const BoundsReference& item : items) {
      const int bin = bins.bin_of(item, axis);
      boxes[bin].extend(item.box);
      ++counts[bin];
    }
    std::vector<Aabb> above(bins.count + 1);
    for (int bin = bins.count; bin-- > 0;) {
      above[bin] = above[bin + 1];
      above[bin].extend(boxes[bin]);
    }
    Aabb below;
    std::uint32_t low = 0;
    for (int place = 1; place < bins.count; ++place) {
      below.extend(boxes[place - 1]);
      low += counts[place - 1];
      const auto high = static_cast<std::uint32_t>(items.size()) - low;
      if (low == 0 || high == 0) continue;
      const float weight =
          area.of(below.extent()) * static_cast<float>(low) + area.of(above[place].extent()) * static_cast<float>(high);
      best.improve({weight, std::fabs(static_cast<float>(low) - static_cast<float>(high)), axis, place});
      const double at = bins.edge(axis, place);
      outcome.candidates.push_back({.axis = axis,
                                    .position = at,
                                    .cost = per_test(area, weight),
                                    .below = low,
                                    .above = high,
                                    .straddling = straddlers.at(axis, at)});
    }
  }

  const ObjectSplitCosts costs_;
};

/// The sentence about a division of objects.
std::string object_reason(const ObjectOutcome& outcome, const ObjectSplitCosts& costs, bool is_deep);

}  // namespace sightline::viz
