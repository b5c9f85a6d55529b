#include "viz/build/build_tree.h"

#include <algorithm>

namespace sightline::viz {
namespace {

/// No plane of a kd-tree leaves a child as large as its parent; such children are pieces of a leaf that is too full for
/// one link (kd_tree_packing.h).
bool is_piece(const Tracer& tracer, const Cell& cell, const Cell& parent) {
  if (tracer.name() != "kd-tree") return false;
  return std::get<Aabb>(cell.region) == std::get<Aabb>(parent.region);
}

}  // namespace

BuildTree::BuildTree(const Tracer& tracer) : order_(tracer.leaf_order().begin(), tracer.leaf_order().end()) {
  std::vector<std::size_t> path;
  tracer.for_each_cell([&](const Cell& cell) {
    const std::size_t index = nodes_.size();
    path.resize(std::min(path.size(), static_cast<std::size_t>(cell.depth)));
    if (!path.empty() && is_piece(tracer, cell, nodes_[path.back()].cell)) {
      BuildNode& leaf = nodes_[path.back()];
      leaf.cell.is_leaf = true;
      if (cell.is_leaf) leaf.ranges.push_back(cell.range), leaf.cell.range.count += cell.range.count;
      path.push_back(path.back());
      return;
    }
    BuildNode node{cell, {}, {}, {}};
    if (cell.is_leaf) node.ranges.push_back(cell.range);
    if (!path.empty()) {
      node.parent = path.back();
      nodes_[path.back()].children.push_back(index);
    }
    nodes_.push_back(std::move(node));
    path.push_back(index);
  });
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!nodes_[i].children.empty()) steps_.push_back(i);
  }
  std::stable_sort(steps_.begin(), steps_.end(),
                   [&](std::size_t a, std::size_t b) { return nodes_[a].cell.depth < nodes_[b].cell.depth; });
}

std::optional<std::size_t> BuildTree::step_of(std::size_t index) const {
  const auto found = std::find(steps_.begin(), steps_.end(), index);
  return found == steps_.end() ? std::nullopt : std::optional<std::size_t>(found - steps_.begin());
}

std::optional<std::size_t> BuildTree::named(std::uint32_t number) const {
  const auto found =
      std::find_if(nodes_.begin(), nodes_.end(), [&](const BuildNode& node) { return node.cell.node == number; });
  return found == nodes_.end() ? std::nullopt : std::optional<std::size_t>(found - nodes_.begin());
}

std::vector<int> BuildTree::way_to(std::size_t index) const {
  std::vector<int> way;
  for (; nodes_[index].parent; index = *nodes_[index].parent) {
    const std::vector<std::size_t>& children = nodes_[*nodes_[index].parent].children;
    way.push_back(static_cast<int>(std::find(children.begin(), children.end(), index) - children.begin()));
  }
  std::reverse(way.begin(), way.end());
  return way;
}

std::vector<std::uint32_t> BuildTree::primitives_below(std::size_t index) const {
  std::vector<std::uint32_t> ids;
  for (std::size_t i = index; i < nodes_.size(); ++i) {
    if (i != index && nodes_[i].cell.depth <= nodes_[index].cell.depth) break;  // depth first: the subtree is over
    for (const LeafRange range : nodes_[i].ranges) {
      ids.insert(ids.end(), order_.begin() + range.first, order_.begin() + range.first + range.count);
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

BuildTree::Below BuildTree::below(std::size_t index) const {
  Below below;
  for (std::size_t i = index; i < nodes_.size(); ++i) {
    if (i != index && nodes_[i].cell.depth <= nodes_[index].cell.depth) break;
    below.leaves += nodes_[i].cell.is_leaf;
    below.depth = std::max(below.depth, nodes_[i].cell.depth - nodes_[index].cell.depth);
  }
  return below;
}

}  // namespace sightline::viz
