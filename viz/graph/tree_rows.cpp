#include "viz/graph/tree_rows.h"

#include <algorithm>
#include <cassert>

namespace sightline::viz {
namespace {

constexpr std::size_t many_siblings = 12;  // shown at first, so that other parts of the tree find room

/// Nodes that have rows; adds some as long as there is room.
class Choice {
 public:
  Choice(const SceneGraph& graph, const TreeShape& shape, std::size_t most)
      : graph_(graph), shape_(shape), most_(most), states_(graph.size()) {
    add(root_node, no_node);
  }

  void show_way_to(NodeId focus) {
    std::vector<NodeId> way;
    for (NodeId node = focus; node != root_node; node = graph_.parent(node)) way.push_back(node);
    std::reverse(way.begin(), way.end());
    const auto with_siblings = std::count_if(way.begin(), way.end(), [&](NodeId node) {
      const NodeId first = graph_.first_child(graph_.parent(node));
      return first != node || graph_.next_sibling(first) != no_node;
    });
    const bool fits = 1 + way.size() + static_cast<std::size_t>(with_siblings) <= most_;
    const std::size_t room = most_ / 2 - 1;  // each may need a row for its siblings as well
    const std::size_t first = room / 3, last = way.size() - std::min(way.size(), room - room / 3);
    NodeId above = root_node;
    for (std::size_t i = 0; i < way.size(); ++i) {
      if (!fits && i >= first && i < last) {
        states_[way[i]].is_left_out = true;
        continue;
      }
      add(way[i], above);
      above = way[i];
    }
  }

  /// As many of the children as there is room for; whether that is all of them.
  bool show_children(NodeId node, std::size_t most) {
    std::size_t count = 0;
    for (NodeId child = graph_.first_child(node); child != no_node; child = graph_.next_sibling(child)) {
      if (states_[child].is_left_out) continue;
      if (states_[child].is_shown) {
        ++count;
        continue;
      }
      if (count >= most || rows_ + cost_of(child, node) > static_cast<int>(most_)) return false;
      add(child, node);
      ++count;
    }
    return true;
  }

  /// T3.
  void fill(NodeId focus) {
    for (const std::size_t most : {many_siblings, most_}) {
      for (NodeId node = focus; node != no_node; node = graph_.parent(node)) {
        if (states_[node].is_shown) show_children(node, most);
      }
      std::vector<NodeId> level{root_node};
      while (!level.empty() && rows_ < static_cast<int>(most_)) {
        std::vector<NodeId> next;
        for (const NodeId node : level) {
          show_children(node, most);
          for (NodeId child = graph_.first_child(node); child != no_node; child = graph_.next_sibling(child)) {
            if (states_[child].is_shown) next.push_back(child);
          }
        }
        level = std::move(next);
      }
    }
  }

  std::vector<TreeRow> rows() const {
    std::vector<TreeRow> rows;
    std::vector<Open> open;
    const auto tell_hidden = [&](Open& entry) {
      const State& state = states_[entry.node];
      if (!state.has_below || state.hidden == 0 || entry.is_told) return;
      entry.is_told = true;
      rows.push_back({no_node, entry.row, rows[static_cast<std::size_t>(entry.row)].indent + 1, state.hidden});
    };
    for (const NodeId node : shape_.order) {
      const State& state = states_[node];
      if (!state.is_shown) continue;
      while (!open.empty() && open.back().node != state.above) {
        tell_hidden(open.back());
        open.pop_back();
      }
      if (node != root_node && graph_.parent(node) != state.above) tell_hidden(open.back());
      const int above = open.empty() ? -1 : open.back().row;
      const int indent = above < 0 ? 0 : rows[static_cast<std::size_t>(above)].indent + 1;
      open.push_back({node, static_cast<int>(rows.size()), false});
      rows.push_back({node, above, indent, state.has_below ? 0 : state.hidden});
    }
    for (; !open.empty(); open.pop_back()) tell_hidden(open.back());
    assert(static_cast<int>(rows.size()) == rows_);
    return rows;
  }

 private:
  struct State {
    bool is_shown = false;
    bool is_left_out = false;  ///< In the middle of the way to the focus, and stays hidden.
    bool has_below = false;    ///< Something below it is shown.
    std::uint32_t hidden = 0;  ///< Below it, and not below what is shown there.
    NodeId above = no_node;    ///< The nearest one that is shown.
  };
  struct Open {
    NodeId node;
    int row;
    bool is_told;
  };

  static int more_row(const State& state) { return state.has_below && state.hidden > 0 ? 1 : 0; }

  /// Rows that it adds below `above`.
  int cost_of(NodeId node, NodeId above) const {
    if (above == no_node) return 1;
    const State& state = states_[above];
    return 1 + (state.hidden > shape_.sizes[node] ? 1 : 0) - more_row(state);
  }

  void add(NodeId node, NodeId above) {
    rows_ += cost_of(node, above);
    states_[node] = {true, false, false, shape_.sizes[node] - 1, above};
    if (above == no_node) return;
    states_[above].has_below = true;
    states_[above].hidden -= shape_.sizes[node];
  }

  const SceneGraph& graph_;
  const TreeShape& shape_;
  std::size_t most_;
  int rows_ = 0;
  std::vector<State> states_;
};

}  // namespace

TreeShape::TreeShape(const SceneGraph& graph) : depths(graph.size()), sizes(graph.size(), 1) {
  for (NodeId node = root_node; node != no_node;) {
    order.push_back(node);
    const NodeId above = graph.parent(node);
    depths[node] = above == no_node ? 0 : depths[above] + 1;
    deepest = std::max(deepest, depths[node]);
    NodeId next = graph.first_child(node);
    for (; next == no_node && node != no_node; node = graph.parent(node)) next = graph.next_sibling(node);
    node = next;
  }
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    if (const NodeId above = graph.parent(*it); above != no_node) sizes[above] += sizes[*it];
  }
}

std::vector<TreeRow> tree_rows(const SceneGraph& graph, const TreeShape& shape, NodeId focus, std::size_t most) {
  most = std::max<std::size_t>(most, 8);
  Choice choice(graph, shape, most);
  choice.show_way_to(focus);
  choice.fill(focus);
  return choice.rows();
}

}  // namespace sightline::viz
