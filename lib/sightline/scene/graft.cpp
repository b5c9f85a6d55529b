#include "sightline/scene/graft.h"

#include <stdexcept>
#include <string>

namespace sightline {
namespace {

std::uint32_t moved(std::uint32_t number, std::uint32_t offset) {
  return number == no_item ? no_item : number + offset;
}

template <class T>
std::uint32_t append(std::vector<T>& into, const std::vector<T>& from) {
  const std::size_t offset = into.size();
  if (offset + from.size() > most_items) {
    throw std::length_error("at most " + std::to_string(most_items) + " geometries, materials and textures each");
  }
  into.insert(into.end(), from.begin(), from.end());
  return static_cast<std::uint32_t>(offset);
}

}  // namespace

ListOffsets append_lists(Scene& into, const Scene& from) {
  ListOffsets offsets;
  offsets.geometries = append(into.geometries, from.geometries);
  offsets.materials = append(into.materials, from.materials);
  offsets.textures = append(into.textures, from.textures);
  for (std::size_t i = offsets.materials; i < into.materials.size(); ++i) {
    Material& material = into.materials[i];
    material.color_texture = moved(material.color_texture, offsets.textures);
    material.normal_map = moved(material.normal_map, offsets.textures);
  }
  return offsets;
}

void graft(Scene& into, NodeId parent, const Scene& from, const ListOffsets& offsets) {
  const SceneGraph& graph = from.graph;
  if (graph.size() > most_nodes || into.graph.size() + graph.size() > most_nodes) {
    throw std::length_error("at most " + std::to_string(most_nodes) + " nodes");
  }
  const bool has_root = !graph.local(root_node).matrix().is_identity() || graph.geometry(root_node) != no_item ||
                        graph.material(root_node) != no_item || !graph.is_visible(root_node);
  std::vector<NodeId> copies(graph.size(), no_node);
  copies[root_node] = parent;
  graph.for_each([&](NodeId node, const Transform&) {
    if (node == root_node && !has_root) return;
    const NodeId above = node == root_node ? parent : copies[graph.parent(node)];
    const NodeId copy = into.graph.add(above, graph.name(node), graph.local(node));
    into.graph.set_geometry(copy, moved(graph.geometry(node), offsets.geometries));
    into.graph.set_material(copy, moved(graph.material(node), offsets.materials));
    into.graph.set_visible(copy, graph.is_visible(node));
    copies[node] = copy;
  });
  for (Light light : from.lights) {
    light.node = copies[light.node];
    into.lights.push_back(std::move(light));
  }
  for (SceneCamera camera : from.cameras) {
    camera.node = copies[camera.node];
    into.cameras.push_back(std::move(camera));
  }
  for (Animation animation : from.animations) {
    for (Channel& channel : animation.channels) channel.node = copies[channel.node];
    into.animations.push_back(std::move(animation));
  }
}

}  // namespace sightline
