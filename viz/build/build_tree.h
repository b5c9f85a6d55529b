#pragma once
/// A structure's cells as the tree that its builder made, and the order in which its nodes are stepped through.

#include <optional>
#include <vector>

#include "sightline/query/tracer.h"

namespace sightline::viz {

struct BuildNode {
  Cell cell;
  std::optional<std::size_t> parent;
  std::vector<std::size_t> children;
  std::vector<LeafRange> ranges;  ///< Of a leaf; several where a kd-tree keeps a full one in pieces.
};

/// Nodes stand as for_each_cell shows them: parents first. Steps are the nodes that are divided, breadth first: the
/// root, its children, theirs; within a depth in the order of for_each_cell.
class BuildTree {
 public:
  explicit BuildTree(const Tracer& tracer);

  const std::vector<BuildNode>& nodes() const { return nodes_; }
  const BuildNode& operator[](std::size_t index) const { return nodes_[index]; }
  /// Indices of the nodes that are divided.
  const std::vector<std::size_t>& steps() const { return steps_; }
  /// Of a node that is divided.
  std::optional<std::size_t> step_of(std::size_t index) const;
  /// The first node that probes name so.
  std::optional<std::size_t> named(std::uint32_t number) const;
  /// Which child to take at each node from the root.
  std::vector<int> way_to(std::size_t index) const;
  /// Ids of the leaf order in and below a node, sorted, each once.
  std::vector<std::uint32_t> primitives_below(std::size_t index) const;
  /// The leaves below a node, and how deep the deepest is below it.
  struct Below {
    std::size_t leaves = 0;
    int depth = 0;
  };
  Below below(std::size_t index) const;

 private:
  std::vector<BuildNode> nodes_;
  std::vector<std::size_t> steps_;
  std::vector<std::uint32_t> order_;
};

}  // namespace sightline::viz
