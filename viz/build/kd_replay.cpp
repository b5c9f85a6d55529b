/// What a kd-tree's builder weighs: every plane at which a primitive begins or ends (perfect splits).

#include "sightline/accel/kd_tree.h"
#include "viz/build/replay.h"

namespace sightline::viz {
namespace {

using detail::EventKind;
using detail::KdEvent;
using detail::KdEventList;
using detail::KdSide;
using detail::KdSplit;

/// What a cell holds, as the builder has it: see KdTreeBuilder::Content.
struct KdState {
  Aabb cell;
  std::array<KdEventList, 3> events;
  std::uint32_t count = 0;
  std::uint64_t budget = 0;
};

/// Of the rules that the builder keeps to itself (kd_tree_builder.h).
constexpr std::uint32_t crowd_size = 64;
constexpr double least_gain = 0.1, most_parts = 1.8;

class KdReplay final : public BuildReplay {
 public:
  KdReplay(const Primitives& primitives, const KdTreeOptions& options)
      : primitives_(primitives),
        options_(options),
        costs_{options.traversal_cost, options.intersection_cost, 1 - double(options.empty_bonus)},
        sides_(primitives.size()) {
    const bool is_best = options.quality == Quality::best;
    reference_limit_ = is_best ? 256 : 64;
    max_depth_ = options.max_depth > 0 ? options.max_depth
                                       : static_cast<int>(8 + (is_best ? 2 : 1.3) * std::log2(primitives.size()));
  }

  Decision decide(std::span<const int> way) override {
    const KdState& state = states_.at(
        way, [&] { return root(); },
        [&](const KdState& from, int turn, int depth) { return child(from, turn, depth); });
    const Outcome outcome = outcome_of(state, static_cast<int>(way.size()));
    Decision decision;
    decision.cost_unit = "triangle tests";
    decision.how = options_.quality == Quality::fast
                       ? "every plane at which a triangle begins or ends, along the widest axis that has one worth it"
                       : "every plane at which a triangle's clipped box begins or ends, along all axes";
    for (const KdEvent event : state.events[0]) {
      if (event.kind() != EventKind::end) decision.primitives.push_back(event.id());
    }
    decision.leaf_cost = state.count;
    weigh(state, outcome, decision);
    decision.is_divided = outcome.split.has_value();
    decision.reason = outcome.reason;
    if (outcome.split) {
      for (std::size_t i = 0; i < decision.candidates.size() && !outcome.is_halved; ++i) {
        const BuildCandidate& candidate = decision.candidates[i];
        if (candidate.axis == outcome.split->axis && candidate.position == double(outcome.split->place)) {
          decision.chosen = i;
        }
      }
      if (outcome.is_halved) {
        decision.chosen = decision.candidates.size();
        decision.candidates.push_back(halving_candidate(state, *outcome.split));
      }
      decision.below = ids_of(child(state, 0, static_cast<int>(way.size())));
      decision.above = ids_of(child(state, 1, static_cast<int>(way.size())));
    }
    return decision;
  }

 private:
  struct Outcome {
    std::optional<KdSplit> split;
    bool is_halved = false;
    std::string reason;
  };

  static std::vector<std::uint32_t> ids_of(const KdState& state) {
    std::vector<std::uint32_t> ids;
    for (const KdEvent event : state.events[0]) {
      if (event.kind() != EventKind::end) ids.push_back(event.id());
    }
    return ids;
  }

  KdState root() {
    KdState root;
    root.count = primitives_.size();
    root.budget =
        std::min<std::uint64_t>(std::uint64_t(reference_limit_) * root.count, detail::KdChild::position_limit);
    std::vector<Aabb> boxes;
    for (std::uint32_t id = 0; id < root.count; ++id) {
      boxes.push_back(primitives_.bounds(id));
      root.cell.extend(boxes.back());
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (std::uint32_t id = 0; id < root.count; ++id) add_events(boxes[id], axis, id, root.events[axis]);
      std::sort(root.events[axis].begin(), root.events[axis].end());
    }
    clip_slack_ = 0x1p-48 * max_norm(Vec3d(root.cell.hi) - Vec3d(root.cell.lo));
    return root;
  }

  static void add_events(const Aabb& part, int axis, std::uint32_t id, KdEventList& events) {
    const bool is_flat = part.lo[axis] == part.hi[axis];
    events.emplace_back(part.lo[axis], is_flat ? EventKind::flat : EventKind::start, id);
    if (!is_flat) events.emplace_back(part.hi[axis], EventKind::end, id);
  }

  Outcome outcome_of(const KdState& state, int depth) const {
    const auto leaf = [](const std::string& reason) { return Outcome{std::nullopt, false, "stays a leaf: " + reason}; };
    if (state.count <= static_cast<std::uint32_t>(options_.max_leaf_size)) {
      return leaf("cells of " + std::to_string(options_.max_leaf_size) +
                  " triangles or fewer are not weighed; the chart shows what would have been found");
    }
    if (depth >= max_depth_) return leaf("it is as deep as cells may be, " + std::to_string(max_depth_));
    const double unsplit = costs_.intersection * state.count;
    const KdSplit cheapest =
        cheapest_split(state.events, state.count, state.cell, costs_, options_.quality == Quality::fast);
    KdSplit split = cheapest;
    bool is_halved = false;
    if (state.count > crowd_size && !(cheapest.axis >= 0 && cheapest.cost < (1 - least_gain) * unsplit)) {
      const KdSplit half = halving_split(state.events, state.count, state.cell);
      is_halved = half.axis >= 0 && double(half.count_below) + half.count_above <= most_parts * state.count;
      if (is_halved) split = half;
    }
    if (split.axis < 0) return leaf("no plane costs less than testing all it holds");
    if (std::uint64_t(split.count_below) + split.count_above > state.budget) {
      return leaf("its share of the memory for references is used up");
    }
    const std::string place = place_text(split.axis, split.place);
    if (is_halved) {
      return {split, true,
              "is halved at " + place + ": no plane saves a tenth of the " + cost_text(state.count) +
                  " that a leaf would cost, and it holds more than " + std::to_string(crowd_size)};
    }
    const bool is_empty = split.count_below == 0 || split.count_above == 0;
    return {split, false,
            "splits at " + place + " for " + cost_text(split.cost / costs_.intersection) +
                " triangle tests, a leaf would cost " + cost_text(state.count) +
                (is_empty ? "; one side is empty, which is rewarded" : "")};
  }

  KdState child(const KdState& state, int turn, int depth) {
    const Outcome outcome = outcome_of(state, depth);
    if (!outcome.split) throw std::out_of_range("kd-tree: the way ends in a leaf");
    const KdSplit& split = *outcome.split;
    KdState child;
    child.cell = state.cell;
    (turn == 0 ? child.cell.hi : child.cell.lo)[split.axis] = split.place;
    const std::uint32_t of_turn = turn == 0 ? split.count_below : split.count_above;
    if (split.count_below == 0 || split.count_above == 0) {  // the other child takes all there is
      if (of_turn > 0) child.events = state.events, child.count = state.count, child.budget = state.budget;
      return child;
    }
    std::vector<std::uint32_t> straddlers;
    const std::uint32_t only_high = take_sides(state.events[split.axis], split, state.count, sides_.data(), straddlers);
    const std::uint32_t high = only_high + static_cast<std::uint32_t>(straddlers.size()), low = state.count - only_high;
    child.count = turn == 0 ? low : high;
    const std::uint64_t low_budget = state.budget * low / (std::uint64_t(low) + high);
    child.budget = turn == 0 ? low_budget : state.budget - low_budget;
    const KdSide own = turn == 0 ? KdSide::below : KdSide::above;
    for (int axis = 0; axis < 3; ++axis) {
      for (const KdEvent event : state.events[axis]) {
        if (sides_[event.id()] == own) child.events[axis].push_back(event);
      }
    }
    add_straddlers(straddlers, child);
    return child;
  }

  void add_straddlers(const std::vector<std::uint32_t>& straddlers, KdState& child) const {
    Aabb widened;
    for (int axis = 0; axis < 3; ++axis) {
      widened.lo[axis] = round_down(child.cell.lo[axis] - clip_slack_);
      widened.hi[axis] = round_up(child.cell.hi[axis] + clip_slack_);
    }
    std::array<KdEventList, 3> fresh;
    for (const std::uint32_t id : straddlers) {
      Aabb part = intersection(primitives_.clip(id, widened), child.cell);
      if (part.is_empty()) part = intersection(primitives_.bounds(id), child.cell);
      if (part.is_empty()) part = child.cell;
      for (int axis = 0; axis < 3; ++axis) add_events(part, axis, id, fresh[axis]);
    }
    for (int axis = 0; axis < 3; ++axis) merge_into(child.events[axis], fresh[axis]);
  }

  /// Each event as a candidate, as in cheapest_split; of those at one place the cheapest.
  void weigh(const KdState& state, const Outcome& outcome, Decision& decision) const {
    const Vec3d extent = Vec3d(state.cell.hi) - Vec3d(state.cell.lo);
    const bool is_widest_only = options_.quality == Quality::fast;
    for (int turn = 0; turn < 3; ++turn) {
      const int axis = is_widest_only ? (state.cell.longest_axis() + turn) % 3 : turn;
      if (is_widest_only && outcome.split && !decision.candidates.empty() &&
          decision.candidates.back().axis == outcome.split->axis) {
        break;
      }
      const float lo = state.cell.lo[axis], hi = state.cell.hi[axis];
      if (!(lo < hi) || state.events[axis].empty()) continue;
      double cap = extent[(axis + 1) % 3] * extent[(axis + 2) % 3];
      double rim = extent[(axis + 1) % 3] + extent[(axis + 2) % 3];
      if (!(cap + extent[axis] * rim > 0)) cap = 0, rim = 1;
      const double scale = costs_.intersection / (cap + extent[axis] * rim);
      const double cap_below = cap - lo * rim, cap_above = cap + hi * rim;
      const auto take = [&](float place, std::int32_t low, std::int32_t high) {
        const double moved = place * rim, weight = low * (cap_below + moved) + high * (cap_above - moved);
        const double share = low == 0 || high == 0 ? costs_.empty_share : 1;
        add(decision, {.axis = axis,
                       .position = place,
                       .cost = (costs_.traversal + scale * weight) * share / costs_.intersection,
                       .below = static_cast<std::uint32_t>(low),
                       .above = static_cast<std::uint32_t>(high),
                       .straddling = static_cast<std::uint32_t>(std::max(0, low + high - int(state.count)))});
      };
      auto low = std::int32_t{0}, high = static_cast<std::int32_t>(state.count);
      for (const KdEvent event : state.events[axis]) {
        const float place = event.place();
        const EventKind kind = event.kind();
        const bool is_within = place > lo && place < hi;
        high -= kind == EventKind::end;
        if (is_within) take(place, low, high);
        low += kind != EventKind::end;
        if (kind != EventKind::flat) continue;
        --high;
        if (is_within) take(place, low, high);
      }
      const float last = state.events[axis].back().place();
      if (last > lo && last < hi) take(last, static_cast<std::int32_t>(state.count), 0);
    }
  }

  static void add(Decision& decision, BuildCandidate candidate) {
    auto& all = decision.candidates;
    if (all.empty() || all.back().axis != candidate.axis || all.back().position != candidate.position) {
      all.push_back(std::move(candidate));
    } else if (candidate.cost < all.back().cost) {
      all.back() = std::move(candidate);
    }
  }

  BuildCandidate halving_candidate(const KdState& state, const KdSplit& half) const {
    Aabb below = state.cell, above = state.cell;
    below.hi[half.axis] = above.lo[half.axis] = half.place;
    const double weight = half_area(below) * half.count_below + half_area(above) * half.count_above;
    return {.axis = half.axis,
            .position = half.place,
            .cost = costs_.traversal / costs_.intersection + weight / half_area(state.cell),
            .below = half.count_below,
            .above = half.count_above,
            .straddling = half.count_below + half.count_above - state.count,
            .label = "the middle, taken by rule"};
  }

  const Primitives& primitives_;
  const KdTreeOptions options_;
  const detail::KdCosts costs_;
  std::uint32_t reference_limit_;
  int max_depth_;
  double clip_slack_ = 0;
  std::vector<KdSide> sides_;
  WayStates<KdState> states_;
};

}  // namespace

std::unique_ptr<BuildReplay> make_kd_replay(const Primitives& primitives, const TracerSettings& settings) {
  KdTreeOptions options;
  for (const auto& [name, value] : settings.options) set_option(KdTree::name, options, name, value);
  return std::make_unique<KdReplay>(primitives, options);
}

}  // namespace sightline::viz
