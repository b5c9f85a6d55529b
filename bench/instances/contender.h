#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sightline/query/placed_query.h"

namespace sightline::bench {

/// A structure over instances, ours or a peer's, ready to be asked on the calling thread.
class InstanceContender {
 public:
  virtual ~InstanceContender() = default;
  virtual std::string name() const = 0;
  virtual bool is_peer() const = 0;
  /// That it takes beside the meshes and what they need for themselves.
  virtual std::size_t bytes() const = 0;
  virtual void closest_hits(std::span<const Ray<float>> rays, std::span<InstanceHit<float>> hits) const = 0;
};

}  // namespace sightline::bench
