#pragma once
/// Solids as primitives of the accelerators: each is one, however many parts it has.

#include <bit>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/csg/evaluator.h"
#include "sightline/csg/packet_walk.h"
#include "sightline/math/raw_array.h"
#include "sightline/shape/shapes.h"

namespace sightline {

/// A crossing's u is the number of the primitive, its v that of the face: Solid::normal tells the rest.
inline Crossing crossing_of(const Boundary& boundary) {
  return {boundary.t, static_cast<double>(boundary.primitive), static_cast<double>(boundary.face)};
}

template <Level level>
class SolidSet {
 public:
  using Shape = Solid;

  class PreparedRay {
   public:
    PreparedRay(const Ray<double>& ray, const Aabb& extent) : wide_(ray), extent_(&extent) {}

    template <class Report>
    void for_each_crossing(const Solid& solid, Report&& report) const {
      NoSolidProbe probe;
      const SolidRay<level> ray(wide_, *extent_);
      SolidEvaluator<level> evaluator(solid, ray, probe);
      const SpanList list = evaluator.spans();
      for (const Boundary& boundary : evaluator[list]) report(crossing_of(boundary));
    }

   private:
    Ray<double> wide_;
    const Aabb* extent_;
  };

  SolidSet() = default;

  /// \throws std::invalid_argument naming the first solid that is empty, or has no bounds.
  explicit SolidSet(std::vector<std::shared_ptr<const Solid>> solids) : solids_(std::move(solids)) {
    for (std::size_t id = 0; id < solids_.size(); ++id) {
      const Solid& solid = *solids_[id];
      extent_.extend(solid.extent());
      const bool has_bounds = solid.is_bounded() && !solid.root().is_complement;
      if (has_bounds && !solid.bounds().is_empty()) continue;
      throw std::invalid_argument("solid " + std::to_string(id) + ": expected one with finite bounds, found one " +
                                  (has_bounds ? "that is empty" : "that goes on without end"));
    }
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(solids_.size()); }
  const Solid& operator[](std::uint32_t id) const { return *solids_[id]; }

  Aabb bounds(std::uint32_t id) const { return solids_[id]->bounds(); }
  Aabb clip(std::uint32_t id, const Aabb& box) const {
    const Aabb clipped = intersection(bounds(id), box);
    return clipped.is_empty() ? Aabb{} : clipped;
  }
  Hull hull(std::uint32_t id) const { return hull_of(bounds(id)); }
  CandidatePlanes planes(std::uint32_t id) const { return faces_of(bounds(id)); }
  PreparedRay prepare(const Ray<double>& ray) const { return {ray, extent_}; }
  /// Of all parts of all solids.
  const Aabb& extent() const { return extent_; }

 private:
  std::vector<std::shared_ptr<const Solid>> solids_;
  Aabb extent_;
};

static_assert(Shapes<SolidSet<Level::watertight>>);

/// Leaves of solids as queries test them: no farther than they ask, and no more boundaries than the first.
template <Level level, class Probe = NoSolidProbe>
class SolidLeaves {
 public:
  SolidLeaves(const SolidSet<level>& solids, std::span<const std::uint32_t> order, Probe& probe)
      : solids_(solids), order_(order), probe_(probe) {}

  /// Made ready when the first solid needs it: many rays meet none.
  template <class T>
  class PreparedRay {
   public:
    PreparedRay(const Ray<T>& ray, const Aabb& extent) : ray_(ray), wide_(wide(ray)), extent_(extent) {}

    const Ray<T>& ray() const { return ray_; }
    const SolidRay<level>& ready() {
      if (!ready_) ready_.emplace(wide_, extent_);
      return *ready_;
    }

   private:
    static const Ray<double>& wide(const Ray<double>& ray) { return ray; }
    static Ray<double> wide(const Ray<float>& ray) { return to_double(ray); }

    const Ray<T>& ray_;
    std::conditional_t<std::is_same_v<T, double>, const Ray<double>&, Ray<double>> wide_;
    const Aabb& extent_;
    std::optional<SolidRay<level>> ready_;
  };

  template <class T>
  PreparedRay<T> prepare(const Ray<T>& ray) const {
    return {ray, solids_.extent()};
  }

  /// Of all solids of a leaf.
  Aabb bounds(LeafRange leaf) const {
    Aabb bounds;
    for (const std::uint32_t id : order_.subspan(leaf.first, leaf.count)) bounds.extend(solids_.bounds(id));
    return bounds;
  }

  /// Calls see(id, crossing) for the first crossing of each solid in the ray's range and not beyond `far`, until it
  /// returns false.
  template <class T, class See>
  void for_first_crossings(PreparedRay<T>& ray, LeafRange leaf, T far, See&& see) const {
    for (const std::uint32_t id : order_.subspan(leaf.first, leaf.count)) {
      if (!see_first(id, ray, far, see)) return;
    }
  }

  /// Whether any solid has a crossing in the ray's range.
  template <class T>
  bool has_crossing(PreparedRay<T>& ray, LeafRange leaf) const {
    for (const std::uint32_t id : order_.subspan(leaf.first, leaf.count)) {
      if (crosses(id, ray)) return true;
    }
    return false;
  }

  /// Coherent rays, made ready when the first solid needs them: together, and those alone that are unclear together.
  class PreparedPacket {
   public:
    PreparedPacket(const RayPacket<double>& packet, std::span<const Ray<double>> rays, const Aabb& extent)
        : packet_(packet), rays_(rays), extent_(extent) {}

    const Ray<double>& ray(std::size_t i) const { return rays_[i]; }
    const RayPacket<double>::Lanes& limits() const { return packet_.farthest(); }
    const SolidPacket<level>& together() {
      if (!together_) together_.emplace(packet_);
      return *together_;
    }
    PreparedRay<double>& alone(std::size_t i) {
      if (!(made_ >> i & 1)) alone_.make(i, rays_[i], extent_), made_ |= 1u << i;
      return alone_[i];
    }

   private:
    const RayPacket<double>& packet_;
    std::span<const Ray<double>> rays_;
    const Aabb& extent_;
    std::optional<SolidPacket<level>> together_;
    std::uint32_t made_ = 0;  ///< Bits of those that are.
    RawArray<PreparedRay<double>, RayPacket<double>::size> alone_;
  };

  PreparedPacket prepare(const RayPacket<double>& packet, std::span<const Ray<double>> rays) const {
    return PreparedPacket(packet, rays, solids_.extent());
  }

  /// Calls see(place of the ray, id, crossing) for the rays of `met`, a bit each: of each ray and solid at most the
  /// first crossing in the ray's range, if it is not beyond the ray's limit. `see` may lower that.
  template <class See>
  void for_first_crossings(PreparedPacket& rays, LeafRange leaf, std::uint32_t met,
                           const RayPacket<double>::Lanes& limits, See&& see) const {
    for (const std::uint32_t id : order_.subspan(leaf.first, leaf.count)) {
      std::uint32_t unclear = met;
      if (const ConvexLanes* lanes = lanes_of(id)) {
        PacketWalk<level> walk(*lanes, rays.together());
        walk.template run<true>(met, slackened(limits));
        unclear = walk.unclear;
        count(*lanes, walk.reached);
        for (std::uint32_t rest = walk.found; rest != 0; rest &= rest - 1) {
          const auto i = static_cast<std::size_t>(std::countr_zero(rest));
          Boundary boundary = walk.boundary(i);
          if (!(std::fabs(boundary.t - limits[i]) > 3 * boundary.radius)) {
            unclear |= 1u << i;
            continue;
          }
          if (boundary.t > limits[i]) continue;
          if (!is_accurate(boundary.t, boundary.radius, level))
            boundary = refined_boundary(solids_[id], boundary, rays.alone(i).ready().quick());
          if (boundary.t > rays.ray(i).t_min)
            see(i, id, crossing_of(boundary));
          else
            unclear |= 1u << i;
        }
      }
      for (; unclear != 0; unclear &= unclear - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(unclear));
        const auto see_it = [&](std::uint32_t, const Crossing& crossing) {
          see(i, id, crossing);
          return true;
        };
        see_first(id, rays.alone(i), limits[i], see_it);
      }
    }
  }

  /// Those rays of `met` with a crossing of any solid in their range.
  std::uint32_t having_crossing(PreparedPacket& rays, LeafRange leaf, std::uint32_t met) const {
    std::uint32_t found = 0;
    for (std::size_t k = 0; k < leaf.count && met != 0; ++k) {
      const std::uint32_t id = order_[leaf.first + k];
      std::uint32_t unclear = met, surely = 0;
      if (const ConvexLanes* lanes = lanes_of(id)) {
        PacketWalk<level> walk(*lanes, rays.together());
        walk.template run<false>(met, slackened(rays.limits()));
        surely = walk.surely_within(rays.limits());
        unclear = walk.unclear | (walk.found & ~surely);
        count(*lanes, walk.reached);
      }
      for (; unclear != 0; unclear &= unclear - 1) {
        const int i = std::countr_zero(unclear);
        surely |= std::uint32_t{crosses(id, rays.alone(static_cast<std::size_t>(i)))} << i;
      }
      found |= surely;
      met &= ~surely;
    }
    return found;
  }

  /// The same for all crossings.
  template <class T, class See>
  void for_each_crossing(PreparedRay<T>& ray, LeafRange leaf, T, See&& see) const {
    bool goes_on = true;
    for (std::size_t i = 0; i < leaf.count && goes_on; ++i) {
      const std::uint32_t id = order_[leaf.first + i];
      SolidEvaluator<level, Probe> evaluator(solids_[id], ray.ready(), probe_);
      const SpanList list = evaluator.spans();
      for (const Boundary& boundary : evaluator[list]) goes_on = goes_on && see(id, crossing_of(boundary));
    }
  }

 private:
  /// Null where rays are not to go through the solid together.
  const ConvexLanes* lanes_of(std::uint32_t id) const {
    if (!has_lane_roots<level> || Probe::sees_transitions) return nullptr;
    const ConvexParts* parts = solids_[id].convex_parts();
    return parts ? parts->lanes.get() : nullptr;
  }
  static RayPacket<double>::Lanes slackened(const RayPacket<double>::Lanes& limits) {
    RayPacket<double>::Lanes slackened;
    for (std::size_t i = 0; i < limits.size(); ++i) slackened[i] = limits[i] + limit_slack<level>(limits[i]);
    return slackened;
  }
  /// As many solvings of each primitive as rays that were tested with them.
  void count(const ConvexLanes& lanes, std::uint32_t reached) const {
    if constexpr (std::is_same_v<Probe, NoSolidProbe>) return;
    for (; reached != 0; reached &= reached - 1) {
      for (std::uint32_t lane = 0; lane < lanes.count(); ++lane) probe_.primitive(lanes[lane].primitive);
    }
  }

  /// Whether the solid has a crossing in the ray's range.
  template <class T>
  bool crosses(std::uint32_t id, PreparedRay<T>& ray) const {
    const WalkOutcome outcome = walk_any(solids_[id], ray.ready(), ray.ray().t_min, ray.ray().t_max, probe_);
    if (outcome != WalkOutcome::unclear) return outcome == WalkOutcome::found;
    bool is_hit = false;
    const auto see = [&](std::uint32_t, const Crossing& crossing) {
      const T t = static_cast<T>(crossing.t);
      is_hit = t <= ray.ray().t_max && t < std::numeric_limits<T>::infinity();
      return false;
    };
    see_first(id, ray, ray.ray().t_max, see);
    return is_hit;
  }

  template <class T, class See>
  bool see_first(std::uint32_t id, PreparedRay<T>& ray, T far, See& see) const {
    const SolidRay<level>& ready = ray.ready();
    double t_min = ray.ray().t_min;
    Boundary boundary;
    while (is_found(solids_[id], ready, t_min, last_rounded_to(far), boundary)) {
      // Rounded to the ray's precision it may not be behind t_min any more.
      if (static_cast<T>(boundary.t) > ray.ray().t_min) return see(id, crossing_of(boundary));
      t_min = boundary.t;
    }
    return true;
  }

  bool is_found(const Solid& solid, const SolidRay<level>& ray, double t_min, double t_max, Boundary& first) const {
    const WalkOutcome outcome = walk_first(solid, ray, t_min, t_max, probe_, first);
    if (outcome != WalkOutcome::unclear) [[likely]]
      return outcome == WalkOutcome::found;
    return is_found_by_lists(solid, ray, t_min, t_max, first);
  }
  [[gnu::noinline]] bool is_found_by_lists(const Solid& solid, const SolidRay<level>& ray, double t_min, double t_max,
                                           Boundary& first) const {
    if (!ray.is_valid()) return false;
    const auto boundary = SolidEvaluator<level, Probe>(solid, ray, probe_).first_by_lists(t_min, t_max);
    if (boundary) first = *boundary;
    return boundary.has_value();
  }

  const SolidSet<level>& solids_;
  std::span<const std::uint32_t> order_;
  Probe& probe_;
};

}  // namespace sightline
