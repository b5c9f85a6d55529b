#include "sightline/scene/flatten.h"

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace sightline {

SceneInstances instances_of(const Scene& scene) {
  const SceneGraph& graph = scene.graph;
  SceneInstances placed;
  std::vector<std::shared_ptr<const TriangleMesh>> meshes;
  std::map<const TriangleMesh*, std::uint32_t> numbers;
  std::vector<Placement> placements;
  std::vector<std::uint32_t> materials(graph.size(), no_item);

  graph.for_each_shown([&](NodeId node, const Transform& world) {
    materials[node] = graph.material(node);
    if (materials[node] == no_item && node != root_node) materials[node] = materials[graph.parent(node)];
    if (graph.geometry(node) == no_item) return;
    const auto* geometry = std::get_if<MeshGeometry>(&scene.geometries[graph.geometry(node)].shape);
    if (geometry == nullptr) {
      ++placed.solids_left_out;
      return;
    }
    if (geometry->mesh->size() == 0) return;
    const auto [entry, is_first] = numbers.try_emplace(geometry->mesh.get(), static_cast<std::uint32_t>(meshes.size()));
    if (is_first) meshes.push_back(geometry->mesh);
    const Placement placement(world.matrix(), entry->second);
    if (const std::string_view expected = missing_of(placement, *geometry->mesh); !expected.empty()) {
      throw std::invalid_argument("node " + graph.path(node) + ": expected " + std::string(expected));
    }
    placements.push_back(placement);
    placed.origins.push_back({node, materials[node]});
  });
  placed.instances = Instances(std::move(meshes), std::move(placements));
  return placed;
}

}  // namespace sightline
