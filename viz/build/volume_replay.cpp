/// What the builders of bounding volume hierarchies weigh.

#include "sightline/accel/bounding_volume_tree.h"
#include "viz/build/object_replay.h"

namespace sightline::viz {
namespace {

template <class Volume>
class VolumeReplay final : public BuildReplay {
 public:
  using Options = BoundingVolumeOptions<Volume>;

  VolumeReplay(const Primitives& primitives, const Options& options)
      : primitives_(primitives),
        options_(options),
        costs_{options.traversal_cost, options.intersection_cost, options.max_leaf_size, options.bins, options.quality},
        objects_(costs_) {}

  Decision decide(std::span<const int> way) override {
    const auto depth = static_cast<int>(way.size());
    const ObjectState& state = states_.at(
        way, [&] { return root(); }, [&](const ObjectState& from, int turn, int at) { return child(from, turn, at); });
    ObjectOutcome outcome = objects_.divide(state, depth);
    Decision decision;
    decision.cost_unit = "triangle tests";
    decision.how = outcome.how;
    if (added_ > 0) {
      decision.how += "; long triangles were cut before, into " + std::to_string(added_) + " references more";
    }
    decision.primitives = ids_of(state);
    decision.leaf_cost = outcome.leaf_cost;
    decision.is_divided = outcome.is_divided;
    decision.reason = object_reason(outcome, costs_, depth >= ObjectReplay<Area>::heuristic_depth);
    decision.candidates = std::move(outcome.candidates);
    decision.chosen = outcome.chosen;
    decision.below = ids_of(outcome.below);
    decision.above = ids_of(outcome.above);
    return decision;
  }

 private:
  struct Area {
    float operator()(float x, float y, float z) const { return Volume::half_area_around(x, y, z); }
  };

  static std::vector<std::uint32_t> ids_of(const ObjectState& state) {
    std::vector<std::uint32_t> ids;
    for (const BoundsReference& item : state.items) ids.push_back(item.id);
    return ids;
  }

  ObjectState root() {
    int splits = 0;
    if constexpr (!Volume::needs_points) splits = splits_of(primitives_, options_.splits, options_.quality);
    LargeBuffer<BoundsReference> references = references_of(primitives_, splits);
    added_ = references.size() - primitives_.size();
    return objects_.root(references.part(0, references.size()));
  }

  ObjectState child(const ObjectState& state, int turn, int depth) const {
    ObjectOutcome outcome = objects_.divide(state, depth);
    if (!outcome.is_divided) throw std::out_of_range(std::string(Volume::tree_name) + ": the way ends in a leaf");
    return std::move(turn == 0 ? outcome.below : outcome.above);
  }

  const Primitives& primitives_;
  const Options options_;
  const ObjectSplitCosts costs_;
  const ObjectReplay<Area> objects_;
  std::size_t added_ = 0;
  WayStates<ObjectState> states_;
};

template <class Volume>
std::unique_ptr<BuildReplay> make_volume_replay(const Primitives& primitives, const TracerSettings& settings) {
  BoundingVolumeOptions<Volume> options;
  for (const auto& [name, value] : settings.options) set_option(Volume::tree_name, options, name, value);
  return std::make_unique<VolumeReplay<Volume>>(primitives, options);
}

}  // namespace

std::unique_ptr<BuildReplay> make_box_replay(const Primitives& primitives, const TracerSettings& settings) {
  return make_volume_replay<BoundingBox>(primitives, settings);
}
std::unique_ptr<BuildReplay> make_sphere_replay(const Primitives& primitives, const TracerSettings& settings) {
  return make_volume_replay<BoundingSphere>(primitives, settings);
}
std::unique_ptr<BuildReplay> make_cylinder_replay(const Primitives& primitives, const TracerSettings& settings) {
  return make_volume_replay<BoundingCylinder>(primitives, settings);
}

}  // namespace sightline::viz
