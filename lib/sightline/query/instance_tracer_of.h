#pragma once
/// The one implementation of InstanceTracer, over any structure.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <array>
#include <cassert>
#include <utility>

#include "sightline/accel/box_primitives.h"
#include "sightline/query/instance_tracer.h"

namespace sightline::detail {

inline std::vector<Aabb> boxes_of(const Instances& instances) {
  std::vector<Aabb> boxes(instances.size());
  constexpr std::size_t task_size = 8192;  // fewer are not worth waking a thread
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, instances.size(), task_size), [&](const auto& part) {
    for (std::uint32_t i = part.begin(); i < part.end(); ++i) boxes[i] = instances.bounds(i);
  });
  return boxes;
}

/// Instances that a ray has been through: structures that divide space hold one in several leaves. Forgetting is no
/// fault, since being tested again changes nothing.
class RecentInstances {
 public:
  RecentInstances() { ids_.fill(no_primitive); }

  /// Whether it is among them; from now on it is.
  bool holds(std::uint32_t instance) {
    std::uint32_t& id = ids_[instance % ids_.size()];
    return std::exchange(id, instance) == instance;
  }

 private:
  std::array<std::uint32_t, 8> ids_;
};

template <class Derived, class T, class Base>
class InstanceQueriesOf : public Base {
 public:
  void closest_hits(std::span<const Ray<T>> rays, std::span<InstanceHit<T>> hits, Level level) const override {
    NoProbe probe;
    closest(rays, hits, level, probe);
  }
  void closest_hits(std::span<const Ray<T>> rays, std::span<InstanceHit<T>> hits, TraversalStats& stats,
                    Level level) const override {
    closest(rays, hits, level, stats);
  }
  void any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, Level level) const override {
    NoProbe probe;
    any(rays, is_hit, level, probe);
  }
  void any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, TraversalStats& stats,
                Level level) const override {
    any(rays, is_hit, level, stats);
  }

 private:
  template <class Probe>
  void closest(std::span<const Ray<T>> rays, std::span<InstanceHit<T>> hits, Level level, Probe& probe) const {
    assert(rays.size() == hits.size());
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = first_hit(rays[i], false, level, probe);
  }
  template <class Probe>
  void any(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, Level level, Probe& probe) const {
    assert(rays.size() == is_hit.size());
    for (std::size_t i = 0; i < rays.size(); ++i) is_hit[i] = first_hit(rays[i], true, level, probe).is_hit();
  }

  template <class Probe>
  InstanceHit<T> first_hit(const Ray<T>& ray, bool takes_any, Level level, Probe& probe) const {
    const Derived& self = static_cast<const Derived&>(*this);
    PlacedQuery<T> query(ray, self.instances(), takes_any);
    RecentInstances recent;
    self.accel().traverse(
        ray,
        [&](LeafRange leaf) {
          for (const std::uint32_t instance : self.accel().leaf_order().subspan(leaf.first, leaf.count)) {
            if (recent.holds(instance)) continue;
            if constexpr (std::is_same_v<Probe, NoProbe>) {
              self.tracer_of(instance).visit(query, instance, level);
            } else {
              self.tracer_of(instance).visit(query, instance, level, probe);
            }
            if (query.is_done()) return -std::numeric_limits<T>::infinity();
          }
          return query.far();
        },
        probe);
    return query.best();
  }
};

template <Accelerator A>
class InstanceTracerOf final : public InstanceQueriesOf<InstanceTracerOf<A>, double,
                                                        InstanceQueriesOf<InstanceTracerOf<A>, float, InstanceTracer>> {
 public:
  InstanceTracerOf(std::shared_ptr<const Instances> instances, std::vector<std::shared_ptr<const Tracer>> meshes,
                   A accel)
      : instances_(std::move(instances)), meshes_(std::move(meshes)), accel_(std::move(accel)) {}

  std::string_view name() const override { return A::name; }
  const Instances& instances() const override { return *instances_; }
  std::size_t structure_bytes() const override { return accel_.memory_bytes(); }
  void for_each_cell(const std::function<void(const Cell&)>& see) const override { accel_.for_each_cell(see); }

  bool refit(std::shared_ptr<const Instances> moved) override {
    if constexpr (Refittable<A>) {
      if (!accel_.can_refit() || !instances_->have_moved_to(*moved)) return false;
      const std::vector<Aabb> boxes = boxes_of(*moved);
      accel_ = A::refit(std::move(accel_), BoxPrimitives(boxes));
      instances_ = std::move(moved);
      return true;
    }
    return false;
  }

  const A& accel() const { return accel_; }
  const Tracer& tracer_of(std::uint32_t instance) const { return *meshes_[instances_->placements()[instance].mesh()]; }

 private:
  std::shared_ptr<const Instances> instances_;
  std::vector<std::shared_ptr<const Tracer>> meshes_;
  A accel_;
};

template <Accelerator A>
std::unique_ptr<InstanceTracer> make_instance_tracer_of(std::shared_ptr<const Instances> instances,
                                                        std::vector<std::shared_ptr<const Tracer>> meshes,
                                                        const TracerSettings& settings) {
  auto options = costly_primitives<A>();
  for (const auto& [name, value] : settings.options) set_option(A::name, options, name, value);
  tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);
  return arena.execute([&] {
    const std::vector<Aabb> boxes = boxes_of(*instances);
    return std::make_unique<InstanceTracerOf<A>>(std::move(instances), std::move(meshes),
                                                 A::build(BoxPrimitives(boxes), options));
  });
}

}  // namespace sightline::detail
