#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "sightline/math/level.h"
#include "sightline/query/tracer.h"

namespace sightline::hard {

/// Triangles asked by packets of sixteen rays (query/packets.h).
class PacketTracer {
 public:
  virtual ~PacketTracer() = default;

  virtual void closest_hits(std::span<const Ray<float>> rays, std::span<Hit<float>> hits, Level level) const = 0;
  virtual void closest_hits(std::span<const Ray<double>> rays, std::span<Hit<double>> hits, Level level) const = 0;
  virtual void any_hits(std::span<const Ray<float>> rays, std::span<std::uint8_t> is_hit, Level level) const = 0;
  virtual void any_hits(std::span<const Ray<double>> rays, std::span<std::uint8_t> is_hit, Level level) const = 0;
};

/// Null for structures that take no packets: to them these are single rays. \throws std::invalid_argument.
std::unique_ptr<PacketTracer> make_packet_tracer(std::string_view accelerator,
                                                 const std::shared_ptr<const TriangleMesh>& mesh,
                                                 const TracerSettings& settings);

}  // namespace sightline::hard
