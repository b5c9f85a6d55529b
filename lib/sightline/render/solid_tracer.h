#pragma once
/// Any structure of the registry over solids, behind one interface, as Tracer (query/tracer.h) is over triangles.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/csg/solid.h"
#include "sightline/csg/solid_probe.h"
#include "sightline/math/level.h"
#include "sightline/query/tracer.h"

namespace sightline {

/// Work of some rays.
struct SolidWork {
  TraversalStats traversal;
  SolidStats solids;
};

/// Const, and safe to ask from many threads. Hits have the number of the solid; u is that of the primitive, v that of
/// its face (boundary_of).
class SolidTracer {
 public:
  virtual ~SolidTracer() = default;

  virtual std::string_view name() const = 0;
  virtual std::span<const std::shared_ptr<const Solid>> solids() const = 0;
  virtual std::size_t structure_bytes() const = 0;
  virtual void for_each_cell(const std::function<void(const Cell&)>& see) const = 0;

  /// hits[i] becomes the nearest hit of rays[i]. Neighbours in the list go in packets where the structure takes them
  /// (query/packets.h); the hits are the same.
  virtual void closest_hits(std::span<const Ray<double>> rays, std::span<Hit<double>> hits) const = 0;
  virtual void any_hits(std::span<const Ray<double>> rays, std::span<std::uint8_t> is_hit) const = 0;
  /// The same, with the work counted.
  virtual void closest_hits(std::span<const Ray<double>> rays, std::span<Hit<double>> hits, SolidWork& work) const = 0;
  virtual void any_hits(std::span<const Ray<double>> rays, std::span<std::uint8_t> is_hit, SolidWork& work) const = 0;
};

/// Where a hit of a solid is, as Solid::normal asks.
inline Boundary boundary_of(const Hit<double>& hit) {
  Boundary boundary;
  boundary.t = hit.t;
  boundary.primitive = static_cast<std::uint32_t>(hit.u);
  boundary.face = static_cast<std::uint32_t>(hit.v);
  return boundary;
}

struct SolidTracerSettings {
  std::vector<TracerSettings::Option> options;  ///< Of the structure. By default it takes solids to be costly.
  bool in_packets = true;
};

/// \throws std::invalid_argument for an unknown accelerator, a bad option, and solids that are empty or have no bounds.
std::unique_ptr<SolidTracer> make_solid_tracer(std::string_view accelerator,
                                               std::vector<std::shared_ptr<const Solid>> solids, Level level,
                                               const SolidTracerSettings& settings = {});

}  // namespace sightline
