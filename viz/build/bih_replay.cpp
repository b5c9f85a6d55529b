/// What the builder of a bounding interval hierarchy weighs: bins over the centers, or none where it halves.

#include "sightline/accel/bounding_interval_hierarchy.h"
#include "viz/build/object_replay.h"

namespace sightline::viz {
namespace {

using detail::BihBox;
using detail::BihExtent;
using detail::BihSplit;

/// What a node holds; see detail::BihTask.
struct BihState {
  std::vector<std::uint32_t> ids;
  std::vector<BihBox> boxes;
  BihExtent extent;
  Aabb candidate;
};

class BihReplay final : public BuildReplay {
 public:
  BihReplay(const Primitives& primitives, const BoundingIntervalHierarchyOptions& options)
      : primitives_(primitives), options_(options), splitter_(options.quality, options.max_leaf_size) {}

  Decision decide(std::span<const int> way) override {
    const auto depth = static_cast<int>(way.size());
    const BihState& state = states_.at(
        way, [&] { return root(); }, [&](const BihState& from, int turn, int at) { return child(from, turn, at); });
    Decision decision;
    decision.primitives = state.ids;
    decision.cost_unit = "tests of eight triangles";
    decision.leaf_cost = tests(state.ids.size());
    if (!splitter_.halves() && state.ids.size() > 1) weigh(state, decision);
    const BihSplit split = split_of(state, depth);
    decision.is_divided = split.axis >= 0;
    explain(state, split, depth, decision);
    if (decision.is_divided) {
      decision.below = child(state, 0, depth).ids;
      decision.above = child(state, 1, depth).ids;
    }
    return decision;
  }

 private:
  static constexpr double node_cost = 0.5;  ///< These three are BihSplitter's own.
  static constexpr std::size_t block = 8;
  static double tests(std::size_t count) { return static_cast<double>((count + block - 1) / block); }
  std::size_t most_bins() const { return options_.quality == Quality::best ? 64 : 16; }

  BihState root() const {
    BihState root;
    for (std::uint32_t id = 0; id < primitives_.size(); ++id) add(root, id, BihBox::of(primitives_.bounds(id)));
    root.candidate = root.extent.bounds.box();
    return root;
  }

  static void add(BihState& state, std::uint32_t id, const BihBox& box) {
    state.ids.push_back(id);
    state.boxes.push_back(box);
    state.extent.extend(box);
  }

  BihSplit split_of(const BihState& state, int depth) const {
    Aabb candidate = state.candidate;
    return depth < options_.max_depth ? splitter_.split(state.boxes, state.extent, candidate) : BihSplit{};
  }

  BihState child(const BihState& state, int turn, int depth) const {
    BihState child;
    child.candidate = state.candidate;
    BihSplit split;
    if (depth < options_.max_depth) split = splitter_.split(state.boxes, state.extent, child.candidate);
    if (split.axis < 0) throw std::out_of_range("bih: the way ends in a leaf");
    if (splitter_.halves()) (turn == 0 ? child.candidate.hi : child.candidate.lo)[split.axis] = split.limit;
    for (std::size_t i = 0; i < state.ids.size(); ++i) {
      if (split.is_below(state.boxes[i]) == (turn == 0)) add(child, state.ids[i], state.boxes[i]);
    }
    return child;
  }

  int bins_for(const BihState& state) const {
    return static_cast<int>(std::min(state.boxes.size() / 4 + 6, most_bins()));
  }

  /// Where the split lies in space.
  static double place_of(const BihSplit& split) {
    return double(split.lowest) + double(split.limit) / double(split.scale);
  }

  void weigh(const BihState& state, Decision& decision) const {
    const int count = bins_for(state);
    decision.how = std::to_string(count) + " bins over the triangles' centers along each axis; a cut between any two";
    std::vector<BoundsReference> items;
    for (std::size_t i = 0; i < state.ids.size(); ++i) items.push_back({state.boxes[i].box(), state.ids[i]});
    const Straddlers straddlers(items);
    const double area = half_area(state.extent.bounds.box());
    for (int axis = 0; axis < 3; ++axis) {
      const float lo = state.extent.centers.lo[axis], length = state.extent.centers.hi[axis] - lo;
      const float scale = static_cast<float>(count) / length;
      if (!std::isfinite(length) || !std::isfinite(scale)) continue;
      std::vector<Aabb> boxes(count), above(count + 1);
      std::vector<std::uint32_t> counts(count);
      for (const BihBox& box : state.boxes) {
        const int bin = std::clamp(static_cast<int>((box.center(axis) - lo) * scale), 0, count - 1);
        boxes[bin].extend(box.box());
        ++counts[bin];
      }
      for (int bin = count; bin-- > 0;) {
        above[bin] = above[bin + 1];
        above[bin].extend(boxes[bin]);
      }
      Aabb below;
      std::uint32_t low = 0;
      for (int place = 1; place < count; ++place) {
        below.extend(boxes[place - 1]);
        low += counts[place - 1];
        const auto high = static_cast<std::uint32_t>(items.size()) - low;
        if (low == 0 || high == 0) continue;
        const double weight = half_area(below) * tests(low) + half_area(above[place]) * tests(high);
        const double at = place_of({axis, lo, scale, static_cast<float>(place)});
        decision.candidates.push_back({.axis = axis,
                                       .position = at,
                                       .cost = node_cost + weight / area,
                                       .below = low,
                                       .above = high,
                                       .straddling = straddlers.at(axis, at)});
      }
    }
  }

  void explain(const BihState& state, const BihSplit& split, int depth, Decision& decision) const {
    const std::string most = std::to_string(options_.max_leaf_size);
    if (split.axis < 0) {
      decision.reason = depth >= options_.max_depth ? "stays a leaf: it is as deep as nodes may be"
                        : splitter_.halves() || decision.candidates.empty()
                            ? "stays a leaf: it holds no more than " + most + " triangles"
                            : "stays a leaf for " + cost_text(decision.leaf_cost) + ": no cut costs less";
      return;
    }
    const double place = place_of(split);
    for (std::size_t i = 0; i < decision.candidates.size(); ++i) {
      const BuildCandidate& candidate = decision.candidates[i];
      if (candidate.axis == split.axis && candidate.position == place && split.scale != 1) decision.chosen = i;
    }
    if (decision.chosen) {
      decision.reason = "splits at " + place_text(split.axis, place) + " for " +
                        cost_text(decision.candidates[*decision.chosen].cost) + " " + decision.cost_unit +
                        ", a leaf would cost " + cost_text(decision.leaf_cost) +
                        (state.ids.size() > static_cast<std::size_t>(options_.max_leaf_size)
                             ? " and may hold " + most + " triangles at most"
                             : "");
      return;
    }
    if (splitter_.halves()) {
      decision.how = "the middle plane of the candidate box, which loses halves that hold no center (2006); no costs";
    }
    decision.chosen = decision.candidates.size();
    BuildCandidate middle{.axis = split.axis, .position = place, .label = "the middle, taken by rule"};
    Aabb below, above;
    for (const BihBox& box : state.boxes) {
      const bool is_below = split.is_below(box);
      (is_below ? below : above).extend(box.box());
      ++(is_below ? middle.below : middle.above);
      middle.straddling += box.lo[split.axis] < place && box.hi[split.axis] > place;
    }
    middle.cost = node_cost + (half_area(below) * tests(middle.below) + half_area(above) * tests(middle.above)) /
                                  half_area(state.extent.bounds.box());
    decision.reason = "is halved at " + place_text(split.axis, place) +
                      (splitter_.halves() ? ", the middle of its candidate box across the longest axis"
                                          : ": all centers fall into one bin");
    decision.candidates.push_back(middle);
  }

  const Primitives& primitives_;
  const BoundingIntervalHierarchyOptions options_;
  const detail::BihSplitter splitter_;
  WayStates<BihState> states_;
};

}  // namespace

std::unique_ptr<BuildReplay> make_bih_replay(const Primitives& primitives, const TracerSettings& settings) {
  BoundingIntervalHierarchyOptions options;
  for (const auto& [name, value] : settings.options) {
    set_option(BoundingIntervalHierarchy::name, options, name, value);
  }
  return std::make_unique<BihReplay>(primitives, options);
}

}  // namespace sightline::viz
