#include "sightline/scene/flatten.h"

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace sightline {
namespace {

/// Calls see(origin, geometry, world) for the nodes that have a geometry and are taken.
template <class See>
void for_each_element(const Scene& scene, const SceneFilter& takes, See&& see) {
  const SceneGraph& graph = scene.graph;
  std::vector<std::uint32_t> materials(graph.size(), no_item);
  graph.for_each_shown([&](NodeId node, const Transform& world) {
    materials[node] = graph.material(node);
    if (materials[node] == no_item && node != root_node) materials[node] = materials[graph.parent(node)];
    if (graph.geometry(node) == no_item) return;
    const SceneOrigin origin{node, materials[node]};
    if (!takes || takes(origin)) see(origin, scene.geometries[graph.geometry(node)], world);
  });
}

void place(SolidTree& tree, const Affine& to_node) {
  if (tree.kind == SolidTree::Kind::primitive) tree.frame = tree.frame * to_node;
  for (SolidTree& arg : tree.args) place(arg, to_node);
}

}  // namespace

SceneInstances instances_of(const Scene& scene, const SceneFilter& takes) {
  SceneInstances placed;
  std::vector<std::shared_ptr<const TriangleMesh>> meshes;
  std::map<const TriangleMesh*, std::uint32_t> numbers;
  std::vector<Placement> placements;

  for_each_element(scene, takes, [&](const SceneOrigin& origin, const Geometry& any, const Transform& world) {
    const auto* geometry = std::get_if<MeshGeometry>(&any.shape);
    if (geometry == nullptr) {
      ++placed.solids_left_out;
      return;
    }
    if (geometry->mesh->size() == 0) return;
    const auto [entry, is_first] = numbers.try_emplace(geometry->mesh.get(), static_cast<std::uint32_t>(meshes.size()));
    if (is_first) meshes.push_back(geometry->mesh);
    const Placement placement(world.matrix(), entry->second);
    if (const std::string_view expected = missing_of(placement, *geometry->mesh); !expected.empty()) {
      throw std::invalid_argument("node " + scene.graph.path(origin.node) + ": expected " + std::string(expected));
    }
    placements.push_back(placement);
    placed.origins.push_back(origin);
  });
  placed.instances = Instances(std::move(meshes), std::move(placements));
  return placed;
}

SceneSolids solids_of(const Scene& scene, const SceneFilter& takes) {
  SceneSolids placed;
  for_each_element(scene, takes, [&](const SceneOrigin& origin, const Geometry& any, const Transform& world) {
    const auto* here = std::get_if<SolidTree>(&any.shape);
    if (here == nullptr) return;
    SolidTree tree = *here;
    if (!world.matrix().is_identity()) place(tree, world.inverse());
    std::shared_ptr<const Solid> solid;
    try {
      solid = std::make_shared<const Solid>(tree);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("node " + scene.graph.path(origin.node) + ": " + error.what());
    }
    if (!solid->is_bounded() || solid->root().is_complement) {
      throw std::invalid_argument("node " + scene.graph.path(origin.node) +
                                  ": expected a solid with finite bounds, found one that goes on without end");
    }
    if (solid->bounds().is_empty()) return;
    placed.solids.push_back(std::move(solid));
    placed.origins.push_back(origin);
  });
  return placed;
}

}  // namespace sightline
