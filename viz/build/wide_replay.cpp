/// What a wide tree's builder weighs: which nodes of a binary tree to give up, so that their children move up.

#include <cmath>

#include "sightline/accel/wide_tree.h"
#include "viz/build/replay.h"

namespace sightline::viz {
namespace {

class WideReplay final : public BuildReplay {
 public:
  WideReplay(const Primitives& primitives, const WideTreeOptions& options)
      : options_(options),
        binary_(references_of(primitives, splits_of(primitives, options.splits, options.quality), WideLink::limit),
                options.quality, options.bins, options.max_leaf_size),
        collapse_(binary_, {options.traversal_cost, options.intersection_cost, options.max_leaf_size}) {}

  Decision decide(std::span<const int> way) override {
    std::uint32_t node = 0, first = 0;
    for (const int turn : way) step_down(node, first, turn);
    Decision decision;
    decision.cost_unit = "tests of a leaf";
    decision.chart = DecisionChart::by_cells;
    decision.position_title = "most children that the node may have";
    decision.primitives = ids_at(first, binary_[node].count);
    decision.how = "which nodes of the binary tree to give up; the cost is that of all below, children chosen at best";
    const bool may_be_leaf = binary_[node].count <= static_cast<std::uint32_t>(options_.max_leaf_size);
    decision.leaf_cost = may_be_leaf ? 1 : 0;
    const bool is_leaf = !way.empty() && collapse_.is_leaf(node);
    if (!binary_.is_leaf(node)) weigh(node, decision);
    if (is_leaf) {
      decision.reason = "stays a leaf: it holds " + std::to_string(binary_[node].count) +
                        ", and testing these together costs less than opening a node";
      return decision;
    }
    decision.is_divided = true;
    const auto children = collapse_.children(node);
    for (int child = 0; child < children.count; ++child) {
      const std::uint32_t count = binary_[children.nodes[child]].count;
      decision.parts.push_back(ids_at(first, count));
      first += count;
    }
    if (!decision.candidates.empty()) decision.chosen = decision.candidates.size() - 1;
    find_merged(node, children, decision);
    const std::string binary = decision.candidates.empty()
                                   ? ""
                                   : ": " + cost_text(decision.candidates.back().cost) + " " + decision.cost_unit +
                                         ", where two children would cost " +
                                         cost_text(decision.candidates.front().cost);
    decision.reason = "takes " + std::to_string(children.count) + " children and gives up " +
                      std::to_string(decision.merged.size()) + " binary nodes" + binary;
    return decision;
  }

 private:
  static constexpr int width = WideNode::width;
  using Collapse = TreeCollapse<width>;
  using ForestCosts = std::array<double, width + 1>;  ///< Of at most so many roots.

  void step_down(std::uint32_t& node, std::uint32_t& first, int turn) const {
    const auto children = collapse_.children(node);
    if (turn >= children.count) throw std::out_of_range("wide-tree: the way ends before");
    for (int child = 0; child < turn; ++child) first += binary_[children.nodes[child]].count;
    node = children.nodes[turn];
  }

  std::vector<std::uint32_t> ids_at(std::uint32_t first, std::uint32_t count) const {
    return {binary_.order.begin() + first, binary_.order.begin() + first + count};
  }

  /// Costs by area of a subtree as at most so many roots, as TreeCollapse finds them; the node itself has to divide.
  ForestCosts divided(std::uint32_t node) const {
    const ForestCosts left = planned(binary_.left(node)), right = planned(binary_.right(node));
    ForestCosts costs;
    costs.fill(std::numeric_limits<double>::infinity());
    for (int roots = 2; roots <= width; ++roots) {
      costs[roots] = costs[roots - 1];
      for (int to_left = 1; to_left < roots; ++to_left) {
        costs[roots] = std::min(costs[roots], left[to_left] + right[roots - to_left]);
      }
    }
    return costs;
  }

  ForestCosts planned(std::uint32_t node) const {
    const double area = half_area(binary_[node].box);
    const double as_leaf = binary_[node].count <= static_cast<std::uint32_t>(options_.max_leaf_size)
                               ? options_.intersection_cost * area
                               : std::numeric_limits<double>::infinity();
    ForestCosts costs;
    costs.fill(as_leaf);
    if (binary_.is_leaf(node)) return costs;
    const ForestCosts parts = divided(node);
    costs[1] = std::min(as_leaf, parts[width] + options_.traversal_cost * area);
    for (int roots = 2; roots <= width; ++roots) costs[roots] = std::min(parts[roots], costs[roots - 1]);
    return costs;
  }

  void weigh(std::uint32_t node, Decision& decision) const {
    const double area = half_area(binary_[node].box);
    if (!(area > 0)) return;
    const ForestCosts costs = divided(node);
    for (int roots = 2; roots <= width; ++roots) {
      decision.candidates.push_back(
          {.position = double(roots),
           .cost = (costs[roots] / area + options_.traversal_cost) / options_.intersection_cost,
           .below = binary_[node].count});
    }
    // What the library chose costs the least of all: up to the order of sums, that is the last of these.
    double taken = 0;
    const auto children = collapse_.children(node);
    for (int child = 0; child < children.count; ++child) taken += planned(children.nodes[child])[1];
    const bool is_node = children.nodes[0] != node;
    if (is_node && std::fabs(taken - costs[width]) > 1e-12 * taken) {
      throw ReplayError("wide-tree: the children taken are not the cheapest");
    }
  }

  /// What is between the node and its children.
  void find_merged(std::uint32_t node, const Collapse::Children& children, Decision& decision) const {
    const auto end = children.nodes.begin() + children.count;
    const auto visit = [&](const auto& self, std::uint32_t at) -> void {
      if (std::find(children.nodes.begin(), end, at) != end) return;
      if (at != node) decision.merged.push_back(binary_[at].box);
      if (binary_.is_leaf(at)) return;
      self(self, binary_.left(at));
      self(self, binary_.right(at));
    };
    visit(visit, node);
  }

  const WideTreeOptions options_;
  BinaryTree binary_;
  Collapse collapse_;
};

}  // namespace

std::unique_ptr<BuildReplay> make_wide_replay(const Primitives& primitives, const TracerSettings& settings) {
  WideTreeOptions options;
  for (const auto& [name, value] : settings.options) set_option(WideTree::name, options, name, value);
  return std::make_unique<WideReplay>(primitives, options);
}

}  // namespace sightline::viz
