#pragma once
/// Two levels: any structure of the registry over instances, and below it the structures of their meshes, one for all
/// instances of a mesh, each of any kind.
///
///   J1  Hits are those of the flattened mesh, bit for bit: a triangle is tested in the world, where its instance puts
///       it, by the test that the flattened mesh is traced with. The lower structure only finds candidates.
///   J2  Memory grows with the number of instances by a placement and what the upper structure needs, whatever the
///       meshes hold.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "sightline/query/placed_query.h"
#include "sightline/query/tracer.h"
#include "sightline/shape/instances.h"

namespace sightline {

/// As Queries (tracer.h).
template <class T>
class InstanceQueries {
 public:
  virtual ~InstanceQueries() = default;

  virtual void closest_hits(std::span<const Ray<T>> rays, std::span<InstanceHit<T>> hits,
                            Level level = Level::watertight) const = 0;
  /// The same, with the work in both levels counted.
  virtual void closest_hits(std::span<const Ray<T>> rays, std::span<InstanceHit<T>> hits, TraversalStats& stats,
                            Level level = Level::watertight) const = 0;
  virtual void any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit,
                        Level level = Level::watertight) const = 0;
  virtual void any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, TraversalStats& stats,
                        Level level = Level::watertight) const = 0;
};

class InstanceTracer : public InstanceQueries<float>, public InstanceQueries<double> {
 public:
  using InstanceQueries<float>::closest_hits, InstanceQueries<double>::closest_hits;
  using InstanceQueries<float>::any_hits, InstanceQueries<double>::any_hits;

  /// Of the upper structure.
  virtual std::string_view name() const = 0;
  virtual const Instances& instances() const = 0;
  /// Of the upper structure: nodes and order.
  virtual std::size_t structure_bytes() const = 0;
  virtual void for_each_cell(const std::function<void(const Cell&)>& see) const = 0;

  /// Follows instances that have moved, as many and of the same meshes, by fitting the upper structure to where they
  /// stand. False, and nothing changes, where it cannot do that, or where these are others. Not while anybody asks.
  virtual bool refit(std::shared_ptr<const Instances> moved) = 0;
};

/// `meshes` are tracers of the meshes of `instances`, in their order. The upper structure takes instances to be costly
/// (box_primitives.h) where its options do not say otherwise; `settings.pack_leaves` is of no account.
/// \throws std::invalid_argument for an unknown accelerator, a bad option, and tracers that are not of these meshes.
std::unique_ptr<InstanceTracer> make_instance_tracer(std::string_view accelerator,
                                                     std::shared_ptr<const Instances> instances,
                                                     std::vector<std::shared_ptr<const Tracer>> meshes,
                                                     const TracerSettings& settings = {});

}  // namespace sightline
