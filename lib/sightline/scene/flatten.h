#pragma once
/// From a tree of elements to a list of meshes that stand in the world.

#include <cstdint>
#include <vector>

#include "sightline/scene/scene.h"
#include "sightline/shape/instances.h"

namespace sightline {

/// The meshes of a scene where they stand, and the elements that they come from.
///   Instances come in the depth-first order of their nodes, one a node that is shown and has a mesh of at least one
///   triangle. A mesh that several nodes or geometries share is listed once, those that no such node has are not
///   listed.
struct SceneInstances {
  struct Origin {
    NodeId node = no_node;             ///< Its geometry tells the normals and places in images.
    std::uint32_t material = no_item;  ///< The node's own, or else that of the nearest ancestor with one.
  };

  Instances instances;
  std::vector<Origin> origins;        ///< One for each instance.
  std::uint32_t solids_left_out = 0;  ///< Nodes shown whose solid has no triangles.
};

/// Places each mesh by the product of its node's and its ancestors' transforms, root first, rounded to float once.
/// \throws std::invalid_argument naming the node by its path where that product is not finite in float, singular there,
/// or places a vertex beyond the range of float.
SceneInstances instances_of(const Scene& scene);

}  // namespace sightline
