#pragma once

#include <memory>

#include "bench/instances/contender.h"

namespace sightline::bench {

/// Embree's RTC_GEOMETRY_TYPE_INSTANCE over one scene a mesh, at its default quality.
std::unique_ptr<InstanceContender> make_embree_instances(const Instances& instances);

}  // namespace sightline::bench
