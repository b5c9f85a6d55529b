#pragma once

#include <vector>

#include "sightline/math/ray.h"
#include "sightline/math/volume_ray.h"
#include "sightline/scene/live_scene.h"
#include "sightline/scene/view_frustum.h"

namespace sightline {

/// Nodes with geometry that are shown and may be met, in order, and how many bounds were asked.
struct Culled {
  std::vector<NodeId> nodes;
  std::size_t tests = 0;
};

/// Nodes whose geometry a ray may meet: none that it does meet is missing.
Culled cull(LiveScene& scene, const VolumeRay& ray, BoundKind kind);
/// Nodes whose geometry a camera may see, likewise.
Culled cull(LiveScene& scene, const ViewFrustum& view, BoundKind kind);

}  // namespace sightline
