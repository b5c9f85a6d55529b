#include "sightline/scene/scene_graph.h"

#include <stdexcept>
#include <utility>

namespace sightline {

NodeId SceneGraph::add(NodeId parent, std::string name, const Transform& local) {
  const NodeId node = size();
  nodes_.push_back({std::move(name), local});
  append(node, parent);
  return node;
}

void SceneGraph::move(NodeId node, NodeId parent) {
  for (NodeId above = parent; above != no_node; above = this->parent(above)) {
    if (above != node) continue;
    throw std::invalid_argument("scene graph: expected a parent that is not below " + path(node) + ", found " +
                                path(parent));
  }
  if (node == root_node) throw std::invalid_argument("scene graph: the root has no parent");
  remove(node);
  append(node, parent);
}

Transform SceneGraph::world(NodeId node) const {
  std::vector<NodeId> way;
  for (NodeId above = node; above != no_node; above = parent(above)) way.push_back(above);
  Transform product = local(way.back());
  for (auto it = way.rbegin() + 1; it != way.rend(); ++it) product = product * local(*it);
  return product;
}

void SceneGraph::set_visible(NodeId node, bool is_visible) {
  if (is_visible == this->is_visible(node)) return;
  if (node >= hidden_.size()) hidden_.resize(node + std::size_t{1});
  hidden_[node] = !is_visible;
}

bool SceneGraph::is_shown(NodeId node) const {
  while (node != no_node && is_visible(node)) node = parent(node);
  return node == no_node;
}

std::string SceneGraph::path(NodeId node) const {
  std::vector<NodeId> way;
  for (NodeId above = node; above != root_node; above = parent(above)) way.push_back(above);
  std::string text = way.empty() ? "/" : "";
  for (auto it = way.rbegin(); it != way.rend(); ++it) {
    text += "/" + (name(*it).empty() ? std::to_string(*it) : name(*it));
  }
  return text;
}

NodeId SceneGraph::find(std::string_view path) const {
  NodeId node = root_node;
  while (node != no_node && !path.empty()) {
    if (path.front() != '/') return no_node;
    const std::string_view step = path.substr(1, path.find('/', 1) - 1);
    path.remove_prefix(1 + step.size());
    if (step.empty()) return node == root_node && path.empty() ? node : no_node;
    const auto is_meant = [&](NodeId child) {
      return name(child).empty() ? step == std::to_string(child) : step == name(child);
    };
    node = first_child(node);
    while (node != no_node && !is_meant(node)) node = next_sibling(node);
  }
  return node;
}

void SceneGraph::append(NodeId node, NodeId parent) {
  Node& above = nodes_[parent];
  nodes_[node].parent = parent;
  nodes_[node].next_sibling = no_node;
  (above.last_child == no_node ? above.first_child : nodes_[above.last_child].next_sibling) = node;
  above.last_child = node;
}

void SceneGraph::remove(NodeId node) {
  Node& above = nodes_[parent(node)];
  NodeId before = no_node;
  for (NodeId child = above.first_child; child != node; child = next_sibling(child)) before = child;
  (before == no_node ? above.first_child : nodes_[before].next_sibling) = next_sibling(node);
  if (above.last_child == node) above.last_child = before;
}

}  // namespace sightline
