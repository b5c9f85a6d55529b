#pragma once
/// The one implementation of SolidTracer, over any structure, at any level.

#include <cassert>
#include <utility>

#include "sightline/accel/box_primitives.h"
#include "sightline/accel/registry.h"
#include "sightline/csg/solid_set.h"
#include "sightline/query/packets.h"
#include "sightline/query/primitives_of.h"
#include "sightline/render/solid_tracer.h"

namespace sightline::detail {

template <Level level, Accelerator A>
class SolidTracerOf final : public SolidTracer {
 public:
  SolidTracerOf(std::vector<std::shared_ptr<const Solid>> list, const typename A::Options& options, bool in_packets)
      : list_(std::move(list)),
        solids_(list_),
        accel_(A::build(PrimitivesOf(solids_), options)),
        in_packets_(in_packets) {}

  std::string_view name() const override { return A::name; }
  std::span<const std::shared_ptr<const Solid>> solids() const override { return list_; }
  std::size_t structure_bytes() const override { return accel_.memory_bytes(); }
  void for_each_cell(const std::function<void(const Cell&)>& see) const override { accel_.for_each_cell(see); }

  void closest_hits(std::span<const Ray<double>> rays, std::span<Hit<double>> hits) const override {
    NoProbe probe;
    NoSolidProbe solid_probe;
    closest(rays, hits, probe, solid_probe);
  }
  void any_hits(std::span<const Ray<double>> rays, std::span<std::uint8_t> is_hit) const override {
    NoProbe probe;
    NoSolidProbe solid_probe;
    any(rays, is_hit, probe, solid_probe);
  }
  void closest_hits(std::span<const Ray<double>> rays, std::span<Hit<double>> hits, SolidWork& work) const override {
    closest(rays, hits, work.traversal, work.solids);
  }
  void any_hits(std::span<const Ray<double>> rays, std::span<std::uint8_t> is_hit, SolidWork& work) const override {
    any(rays, is_hit, work.traversal, work.solids);
  }

 private:
  template <class Probe, class SolidProbe>
  void closest(std::span<const Ray<double>> rays, std::span<Hit<double>> hits, Probe& probe,
               SolidProbe& solid_probe) const {
    assert(rays.size() == hits.size());
    const SolidLeaves<level, SolidProbe> leaves(solids_, accel_.leaf_order(), solid_probe);
    if (in_packets_) return packet_closest_hits(accel_, leaves, rays, hits, probe);
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closest_hit(accel_, leaves, rays[i], probe);
  }
  template <class Probe, class SolidProbe>
  void any(std::span<const Ray<double>> rays, std::span<std::uint8_t> is_hit, Probe& probe,
           SolidProbe& solid_probe) const {
    assert(rays.size() == is_hit.size());
    const SolidLeaves<level, SolidProbe> leaves(solids_, accel_.leaf_order(), solid_probe);
    if (in_packets_) return packet_any_hits(accel_, leaves, rays, is_hit, probe);
    for (std::size_t i = 0; i < rays.size(); ++i) is_hit[i] = any_hit(accel_, leaves, rays[i], probe);
  }

  std::vector<std::shared_ptr<const Solid>> list_;
  SolidSet<level> solids_;
  A accel_;
  bool in_packets_;
};

/// Null where the registry has no such structure.
template <Level level>
std::unique_ptr<SolidTracer> make_solid_tracer_at(std::string_view accelerator,
                                                  std::vector<std::shared_ptr<const Solid>> solids,
                                                  const SolidTracerSettings& settings) {
  std::unique_ptr<SolidTracer> tracer;
  Accelerators::for_each([&]<class A>(auto) {
    if (A::name != accelerator) return;
    auto options = costly_primitives<A>();
    for (const auto& [name, value] : settings.options) set_option(A::name, options, name, value);
    tracer = std::make_unique<SolidTracerOf<level, A>>(std::move(solids), options, settings.in_packets);
  });
  return tracer;
}

}  // namespace sightline::detail
