/// What a BSP tree's builder weighs: axis planes between bins high up, planes of any orientation below.

#include <set>

#include "sightline/accel/bsp_tree.h"
#include "viz/build/replay.h"

namespace sightline::viz {
namespace {

/// What a cell holds; see BspBuilder.
struct BspState {
  bool has_fragments = false;
  Aabb box;
  BspBoxes boxes;  ///< While only axis planes are tried.
  ConvexCell cell;
  Fragments fragments;  ///< From there on where all planes are.
  double budget = 0;

  std::uint32_t count() const { return has_fragments ? fragments.size() : boxes.size(); }
};

class BspReplay final : public BuildReplay {
 public:
  BspReplay(const Primitives& primitives, const BspTreeOptions& options)
      : primitives_(primitives), options_(options), plan_(plan_of(primitives, options)), search_(search_of(plan_)) {}

  Decision decide(std::span<const int> way) override {
    const auto depth = static_cast<int>(way.size());
    const BspState& state = states_.at(
        way, [&] { return root(); },
        [&](const BspState& from, int turn, int at) { return settled(child(from, turn, at), at + 1); });
    Decision decision;
    decision.cost_unit = "triangle tests";
    decision.primitives = ids_of(state);
    decision.leaf_cost = per_test(plan_.costs.tests(state.count()));
    if (is_never_split(state.count(), depth)) {
      decision.reason =
          state.count() <= plan_.max_leaf_size
              ? "stays a leaf: cells of " + std::to_string(plan_.max_leaf_size) + " triangles or fewer are never split"
              : "stays a leaf: it is as deep as cells may be";
      decision.how = "nothing";
      return decision;
    }
    decision.how = state.has_fragments ? how_planes(state) : how_bins();
    Outcome outcome = state.has_fragments ? divide_fragments(state, &decision) : divide_boxes(state, &decision);
    if (state.has_fragments) decision.chart = DecisionChart::ranked;
    explain(outcome, decision);
    return decision;
  }

 private:
  // The builder's own (bsp_tree_builder.h, bsp_tree.h).
  static constexpr std::uint32_t least_sampled = 1024, sample_size = 192, crowd_size = 64;
  static constexpr double least_gain = 0.1, most_parts = 1.8, axis_cost_share = 0.4;

  struct Outcome {
    std::optional<SplitPlane> split;
    bool is_halved = false;
    std::string refusal;  ///< Why there is a leaf.
    double cost = 0;
    std::array<BspState, 2> children;
  };

  static BspPlan plan_of(const Primitives& primitives, const BspTreeOptions& options) {
    Aabb bounds;
    for (std::uint32_t id = 0; id < primitives.size(); ++id) bounds.extend(primitives.bounds(id));
    const Vec3d lo(bounds.lo), hi(bounds.hi);
    const double radius = 0.5 * glm::length(hi - lo);
    const int automatic_depth = std::min(64, static_cast<int>(12 + 1.6 * std::log2(double(primitives.size()))));
    return {primitives,
            0.5 * lo + 0.5 * hi,
            0x1p-21 * radius + 4 * double(std::numeric_limits<float>::denorm_min()),
            static_cast<std::uint32_t>(options.max_leaf_size),
            options.max_depth > 0 ? options.max_depth : automatic_depth,
            options.general_planes && options.quality != Quality::fast,
            {axis_cost_share * options.traversal_cost, options.traversal_cost, options.intersection_cost,
             options.leaf_cost},
            BspEffort::of(options.quality)};
  }
  static SplitSearch search_of(const BspPlan& plan) {
    return {plan.primitives, plan.center, plan.thickness / 2, plan.costs, plan.effort};
  }

  double per_test(double cost) const { return cost / plan_.costs.primitive; }
  bool is_never_split(std::uint32_t count, int depth) const {
    return count <= plan_.max_leaf_size || depth >= plan_.max_depth;
  }

  static std::vector<std::uint32_t> ids_of(const BspState& state) {
    std::vector<std::uint32_t> ids;
    for (std::uint32_t i = 0; i < state.count(); ++i) {
      ids.push_back(state.has_fragments ? state.fragments[i].id : state.boxes.references[i].id);
    }
    return ids;
  }

  BspState root() {
    BspState root;
    for (std::uint32_t id = 0; id < primitives_.size(); ++id) {
      root.boxes.references.push_back({primitives_.bounds(id), id});
      root.box.extend(primitives_.bounds(id));
    }
    root.budget = double(options_.reference_limit) * primitives_.size();
    return settled(std::move(root), 0);
  }

  BspState child(const BspState& state, int turn, int depth) {
    if (is_never_split(state.count(), depth)) throw std::out_of_range("bsp-tree: the way ends in a leaf");
    Outcome outcome = state.has_fragments ? divide_fragments(state, nullptr) : divide_boxes(state, nullptr);
    if (!outcome.split) throw std::out_of_range("bsp-tree: the way ends in a leaf");
    return std::move(outcome.children[static_cast<std::size_t>(turn)]);
  }

  /// Changes over to fragments where the builder does.
  BspState settled(BspState state, int depth) {
    const std::uint32_t count = state.count();
    if (state.has_fragments || is_never_split(count, depth) || !plan_.general_planes) return state;
    const bool changes = count <= plan_.effort.general_size || general_planes_pay(state) || !best_of_bins(state);
    if (!changes) return state;
    state.cell = fragments_of(state, 1, state.fragments);
    state.has_fragments = true;
    return state;
  }

  std::optional<BspBoxes::Choice> best_of_bins(const BspState& state) const {
    return state.boxes.best(state.box, plan_.effort.bins, plan_.thickness, plan_.costs.tests(state.count()),
                            plan_.costs);
  }

  ConvexCell fragments_of(const BspState& state, std::uint32_t step, Fragments& fragments) const {
    fragments.clear();
    for (std::uint32_t i = 0; i < state.boxes.size(); i += step) {
      const auto& [box, id] = state.boxes.references[i];
      fragments.add_within(id, box, state.box, plan_.thickness / 2, primitives_, plan_.center);
    }
    const double border = plan_.thickness / 2;
    return ConvexCell::box(Vec3d(state.box.lo) - plan_.center - border, Vec3d(state.box.hi) - plan_.center + border);
  }

  bool general_planes_pay(const BspState& state) {
    const std::uint32_t count = state.count();
    if (count < least_sampled) return false;
    Fragments sample;
    const ConvexCell convex = fragments_of(state, count / sample_size, sample);
    if (sample.size() == 0) return false;
    const double limit = plan_.costs.tests(count), weight = double(count) / sample.size();
    const auto axis = search_.best(convex, sample, limit, false, weight);
    return search_.best(convex, sample, (1 - least_gain) * (axis ? axis->cost : limit), true, weight).has_value();
  }

  // ---- Axis planes between bins

  Outcome divide_boxes(const BspState& state, Decision* decision) const {
    const std::uint32_t count = state.count();
    if (decision) weigh_bins(state, *decision);
    auto choice = best_of_bins(state);
    Outcome outcome;
    outcome.is_halved = !choice && count > crowd_size;
    if (outcome.is_halved) {
      const int axis = state.box.longest_axis();
      const float lo = state.box.lo[axis], hi = state.box.hi[axis], middle = lo + 0.5f * (hi - lo);
      if (lo < middle && middle < hi) choice = BspBoxes::Choice{SplitPlane::across(axis, middle), 0};
    }
    if (!choice) return refused("no plane costs less than a leaf");
    std::array<BspBoxes, 2> sides;
    state.boxes.split(choice->split, plan_.thickness / 2, primitives_, sides);
    const double parts = double(sides[0].size()) + double(sides[1].size()), share = state.budget / parts;
    if (share < 1) return refused("its share of the memory for references is used up");
    if (std::min(sides[0].size(), sides[1].size()) == count || (outcome.is_halved && parts > most_parts * count)) {
      return refused("both sides of the plane would hold almost all");
    }
    outcome.split = choice->split;
    outcome.cost = per_test(choice->cost);
    for (int side = 0; side < 2; ++side) {
      BspState& part = outcome.children[side];
      part.box = state.box;
      (side == 0 ? part.box.hi : part.box.lo)[choice->split.axis] = choice->split.offset;
      part.boxes = std::move(sides[side]);
      part.budget = share * part.boxes.size();
    }
    return outcome;
  }

  /// As BspBoxes::best.
  void weigh_bins(const BspState& state, Decision& decision) const {
    const int bins = plan_.effort.bins;
    const Aabb& cell = state.box;
    const double thickness = plan_.thickness;
    Aabb content;
    for (const auto& reference : state.boxes.references) content.extend(reference.box);
    const Vec3f size = content.hi - content.lo;
    const Vec3f scale = static_cast<float>(bins) / size;
    const Vec3d extent = Vec3d(cell.hi) - Vec3d(cell.lo) + thickness;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<std::uint32_t> starts(bins), ends(bins);
      for (const auto& [box, id] : state.boxes.references) {
        ++starts[clamp_to_index((box.lo[axis] - content.lo[axis]) * scale[axis], bins)];
        ++ends[clamp_to_index((box.hi[axis] - content.lo[axis]) * scale[axis], bins)];
      }
      const double cap = extent[(axis + 1) % 3] * extent[(axis + 2) % 3];
      const double rim = extent[(axis + 1) % 3] + extent[(axis + 2) % 3];
      std::uint32_t below = 0, above = state.count();
      for (int bin = 0; bin <= bins; ++bin) {
        const float place =
            bin == bins ? content.hi[axis] : content.lo[axis] + size[axis] * static_cast<float>(bin) / bins;
        if (place > cell.lo[axis] && place < cell.hi[axis]) {
          const double low = cap + (double(place) - cell.lo[axis] + thickness / 2) * rim;
          const double high = cap + (double(cell.hi[axis]) - place + thickness / 2) * rim;
          const double tests = low * plan_.costs.tests(below) + high * plan_.costs.tests(above);
          decision.candidates.push_back(
              {.axis = axis,
               .position = place,
               .cost = per_test(plan_.costs.axis_plane + tests / (cap + extent[axis] * rim)),
               .below = below,
               .above = above,
               .straddling = below + above > state.count() ? below + above - state.count() : 0});
        }
        if (bin == bins) break;
        below += starts[bin];
        above -= ends[bin];
      }
    }
  }

  // ---- Planes of any orientation

  Outcome divide_fragments(const BspState& state, Decision* decision) {
    const std::uint32_t count = state.count();
    const auto watch = [&](const SplitPlane& split, double cost, const auto& counts) {
      if (!decision) return;
      const Plane plane = split.plane(plan_.center);
      const double crossing = counts.below + counts.above + counts.on - count;
      BuildCandidate candidate{.axis = split.is_general ? -1 : split.axis,
                               .position = split.offset,
                               .plane = {plane.normal, plane.offset + glm::dot(plane.normal, plan_.center)},
                               .cost = per_test(cost),
                               .below = static_cast<std::uint32_t>(counts.below + 0.5),
                               .above = static_cast<std::uint32_t>(counts.above + 0.5),
                               .straddling = static_cast<std::uint32_t>(std::max(0.0, crossing))};
      decision->candidates.push_back(std::move(candidate));
    };
    const auto choice =
        search_.best(state.cell, state.fragments, plan_.costs.tests(count), plan_.general_planes, 1, watch);
    if (!choice) return refused("no plane costs less");
    Outcome outcome;
    outcome.cost = per_test(choice->cost);
    auto& [below, above] = outcome.children;
    const Plane plane = choice->split.plane(plan_.center);
    state.fragments.split(plane, plan_.thickness / 2, choice->keeps_on_below, primitives_, plan_.center,
                          below.fragments, above.fragments);
    const double share = state.budget / (double(below.fragments.size()) + double(above.fragments.size()));
    if (share < 1) return refused("its share of the memory for references is used up");
    if (std::min(below.fragments.size(), above.fragments.size()) == count) return refused("both sides would hold all");
    outcome.split = choice->split;
    const double tolerance = plan_.thickness * 0x1p-20;
    for (BspState* part : {&below, &above}) {
      part->has_fragments = true;
      part->budget = share * part->fragments.size();
    }
    state.cell.keep_below(plane, tolerance, below.cell);
    state.cell.keep_below({-plane.normal, -plane.offset}, tolerance, above.cell);
    return outcome;
  }

  static Outcome refused(const std::string& why) {
    Outcome outcome;
    outcome.refusal = why;
    return outcome;
  }

  // ---- Words

  std::string how_bins() const {
    return std::to_string(plan_.effort.bins) + " bins over the triangles' clipped boxes along each axis" +
           (plan_.general_planes ? "; with so many triangles, planes of any orientation are not tried yet" : "");
  }

  std::string how_planes(const BspState& state) const {
    std::string how = "axis planes where triangles begin or end";
    if (plan_.general_planes) {
      how += "; planes of " + std::to_string(std::min(plan_.effort.sampled_fragments, state.count())) +
             " triangles and of their edges";
    }
    if (plan_.effort.exact_costs < 1000) {
      how += "; shown are those whose cost was computed, the " + std::to_string(plan_.effort.exact_costs) +
             " most promising by an estimate";
    }
    return how;
  }

  void explain(const Outcome& outcome, Decision& decision) const {
    decision.is_divided = outcome.split.has_value();
    if (!outcome.split) {
      decision.reason = "stays a leaf for " + cost_text(decision.leaf_cost) + ": " + outcome.refusal;
      return;
    }
    decision.below = ids_of(outcome.children[0]);
    decision.above = ids_of(outcome.children[1]);
    const SplitPlane& split = *outcome.split;
    const Plane plane = split.plane(plan_.center);
    const std::string place = split.is_general ? plane_text(plane) : place_text(split.axis, split.offset);
    if (outcome.is_halved) {
      decision.reason = "is halved at " + place + ": no plane costs less than a leaf, and it holds many";
      decision.chosen = decision.candidates.size();
      decision.candidates.push_back({.axis = split.axis,
                                     .position = split.offset,
                                     .cost = decision.leaf_cost,
                                     .label = "the middle, taken by rule"});
    } else {
      for (std::size_t i = 0; i < decision.candidates.size() && !decision.chosen; ++i) {
        const BuildCandidate& c = decision.candidates[i];
        const bool is_it = split.is_general ? c.axis < 0 && c.plane.normal == plane.normal : c.axis == split.axis;
        if (is_it && c.cost == outcome.cost && c.position == double(split.offset)) decision.chosen = i;
      }
      if (!decision.chosen) throw ReplayError("bsp-tree: the plane taken was not among those weighed");
      decision.reason = "splits " + std::string(split.is_general ? "by the plane " : "at ") + place + " for " +
                        cost_text(outcome.cost) + " triangle tests, a leaf would cost " + cost_text(decision.leaf_cost);
    }
    BuildCandidate& chosen = decision.candidates[*decision.chosen];
    chosen.below = static_cast<std::uint32_t>(decision.below.size());
    chosen.above = static_cast<std::uint32_t>(decision.above.size());
    chosen.straddling = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(
        0, std::ssize(decision.below) + std::ssize(decision.above) - std::ssize(decision.primitives)));
  }

  std::string plane_text(const Plane& plane) const {
    const Vec3d& n = plane.normal;
    char text[96];
    std::snprintf(text, sizeof text, "%.3g x %+.3g y %+.3g z = %.4g", n.x, n.y, n.z,
                  plane.offset + glm::dot(n, plan_.center));
    return text;
  }

  const Primitives& primitives_;
  const BspTreeOptions options_;
  const BspPlan plan_;
  SplitSearch search_;
  WayStates<BspState> states_;
};

}  // namespace

std::unique_ptr<BuildReplay> make_bsp_replay(const Primitives& primitives, const TracerSettings& settings) {
  BspTreeOptions options;
  for (const auto& [name, value] : settings.options) set_option(BspTree::name, options, name, value);
  return std::make_unique<BspReplay>(primitives, options);
}

}  // namespace sightline::viz
