#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/math/transform.h"
#include "sightline/scene/matrix_stack.h"

namespace sightline {

using NodeId = std::uint32_t;
inline constexpr NodeId root_node = 0;
inline constexpr NodeId no_node = 0xffff'ffff;

/// Number of what a node refers to in the lists of its scene.
inline constexpr std::uint32_t no_item = 0xffff'ffff;

/// A tree of elements, each placed within its parent.
///   G1  A node's children are a list in the order in which they came; all but the root have one parent.
///   G2  No node is its own ancestor.
///   G3  Nothing here calls itself, so that graphs may be as deep as memory allows.
class SceneGraph {
 public:
  /// With the root alone.
  SceneGraph() : nodes_(1) {}

  NodeId add(NodeId parent, std::string name, const Transform& local = {});
  /// Takes a node with all below it to another parent, behind its children. \throws std::invalid_argument for the root,
  /// and where `parent` is below `node` or is it (G2).
  void move(NodeId node, NodeId parent);

  std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }
  const std::string& name(NodeId node) const { return nodes_[node].name; }
  NodeId parent(NodeId node) const { return nodes_[node].parent; }
  NodeId first_child(NodeId node) const { return nodes_[node].first_child; }
  NodeId next_sibling(NodeId node) const { return nodes_[node].next_sibling; }

  /// From the node to its parent.
  const Transform& local(NodeId node) const { return nodes_[node].local; }
  void set_local(NodeId node, const Transform& local) { nodes_[node].local = local; }
  /// From the node to the world: the product of its ancestors' transforms and its own, root first.
  Transform world(NodeId node) const;

  /// Of the scene's lists; no_item where there is none. A node without a material has its parent's.
  std::uint32_t geometry(NodeId node) const { return nodes_[node].geometry; }
  std::uint32_t material(NodeId node) const { return nodes_[node].material; }
  void set_geometry(NodeId node, std::uint32_t geometry) { nodes_[node].geometry = geometry; }
  void set_material(NodeId node, std::uint32_t material) { nodes_[node].material = material; }

  /// A node that is not visible hides itself and all below it: its geometry is not there, its lights are out. Cameras
  /// see from there all the same.
  bool is_visible(NodeId node) const { return node >= hidden_.size() || !hidden_[node]; }
  void set_visible(NodeId node, bool is_visible);
  /// Whether the node and all above it are visible.
  bool is_shown(NodeId node) const;

  /// Names from the root on, "/person/torso/arm"; nodes without a name by their number.
  std::string path(NodeId node) const;
  /// The first node that has the path, or no_node.
  NodeId find(std::string_view path) const;

  /// Calls visit(node, world) for `from` and all below it, parents first, children in their order (depth-first).
  template <class Visit>
  void for_each(Visit&& visit, NodeId from = root_node) const {
    walk(
        [&](NodeId node, const Transform& world) {
          visit(node, world);
          return true;
        },
        from);
  }

  /// The same of all nodes that are shown.
  template <class Visit>
  void for_each_shown(Visit&& visit) const {
    walk(
        [&](NodeId node, const Transform& world) {
          if (is_visible(node)) visit(node, world);
          return is_visible(node);
        },
        root_node);
  }

 private:
  struct Node {
    std::string name;
    Transform local;
    NodeId parent = no_node, first_child = no_node, last_child = no_node, next_sibling = no_node;
    std::uint32_t geometry = no_item, material = no_item;
  };

  void append(NodeId node, NodeId parent);
  void remove(NodeId node);

  /// `visit` tells whether to go on below the node.
  template <class Visit>
  void walk(Visit&& visit, NodeId from) const;

  std::vector<Node> nodes_;
  std::vector<bool> hidden_;  ///< Of nodes, up to the last one that ever was.
};

template <class Visit>
void SceneGraph::walk(Visit&& visit, NodeId from) const {
  MatrixStack stack;
  if (const NodeId above = parent(from); above != no_node) stack.multiply(world(above));
  for (NodeId node = from;;) {
    stack.push();
    stack.multiply(local(node));
    if (visit(node, stack.current()) && first_child(node) != no_node) {
      node = first_child(node);
      continue;
    }
    stack.pop();
    while (node != from && next_sibling(node) == no_node) {
      node = parent(node);
      stack.pop();
    }
    if (node == from) return;
    node = next_sibling(node);
  }
}

}  // namespace sightline
