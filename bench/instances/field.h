#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "sightline/shape/instances.h"

namespace sightline::bench {

/// `count` instances of a mesh, each turned at random, at the points of a lattice that is as near to a cube as can be.
std::shared_ptr<const Instances> field_of(const std::shared_ptr<const TriangleMesh>& mesh, std::uint32_t count);

struct InstanceRays {
  std::string_view name;
  std::string_view description;
  std::vector<Ray<float>> rays;
};

/// Rays of a camera that sees all, and rays between random points of the middle.
std::vector<InstanceRays> instance_rays(const Instances& instances, std::size_t count);

}  // namespace sightline::bench
