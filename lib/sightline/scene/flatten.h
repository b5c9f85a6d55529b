#pragma once
/// From a tree of elements to lists of meshes and solids that stand in the world.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "sightline/csg/solid.h"
#include "sightline/scene/scene.h"
#include "sightline/shape/instances.h"

namespace sightline {

/// Where something comes from that stands in the world.
struct SceneOrigin {
  NodeId node = no_node;             ///< Its geometry tells the normals and places in images.
  std::uint32_t material = no_item;  ///< The node's own, or else that of the nearest ancestor with one.
};

/// Says which elements are taken; empty for all.
using SceneFilter = std::function<bool(const SceneOrigin&)>;

/// The meshes of a scene where they stand, and the elements that they come from.
///   Instances come in the depth-first order of their nodes, one a node that is shown and has a mesh of at least one
///   triangle. A mesh that several nodes or geometries share is listed once, those that no such node has are not
///   listed.
struct SceneInstances {
  Instances instances;
  std::vector<SceneOrigin> origins;   ///< One for each instance.
  std::uint32_t solids_left_out = 0;  ///< Nodes shown whose solid has no triangles.
};

/// Places each mesh by the product of its node's and its ancestors' transforms, root first, rounded to float once.
/// \throws std::invalid_argument naming the node by its path where that product is not finite in float, singular there,
/// or places a vertex beyond the range of float.
SceneInstances instances_of(const Scene& scene, const SceneFilter& takes = {});

/// The solids of a scene where they stand, in the depth-first order of their nodes.
struct SceneSolids {
  std::vector<std::shared_ptr<const Solid>> solids;
  std::vector<SceneOrigin> origins;  ///< One for each solid.
};

/// Each primitive's frame becomes that of its node as well. Solids that are empty are left out.
/// \throws std::invalid_argument naming the node by its path where a solid goes on without end, or has no sense there.
SceneSolids solids_of(const Scene& scene, const SceneFilter& takes = {});

}  // namespace sightline
