#include "viz/graph/graph_table.h"

#include <cstdio>

namespace sightline::viz {
namespace {

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

std::string volume_text(const Bound& bound) {
  if (is_nothing(bound)) return "none";
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", volume_of(bound));
  return text;
}

std::string ordinal(std::size_t number) {
  const std::size_t last = number % 10, tens = number / 10 % 10;
  const char* const ending = tens == 1 ? "th" : last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th";
  return std::to_string(number) + ending;
}

}  // namespace

std::string still_table(const SceneGraph& graph, const TreeShape& shape, const Snapshot& snapshot) {
  std::string text = "depth  volume        node\n";
  for (const NodeId node : shape.order) {
    text += padded(std::to_string(shape.depths[node]), 7) + padded(volume_text(snapshot.bounds[node]), 14) +
            graph.path(node) + "\n";
  }
  return text;
}

std::string change_table(const SceneGraph& graph, const TreeShape& shape, const Change& change, bool is_short) {
  std::vector<std::size_t> numbers(graph.size(), 0);
  for (std::size_t i = 0; i < change.way.size(); ++i) numbers[change.way[i]] = i + 1;
  std::vector<bool> is_carried(graph.size(), false);
  std::string text = "event        depth  before        after         node\n";
  for (const NodeId node : shape.order) {
    is_carried[node] = node == change.node || (node != root_node && is_carried[graph.parent(node)]);
    const bool is_told = numbers[node] > 0;
    if (is_short && !is_told) continue;
    const std::string event = is_told ? ordinal(numbers[node]) : is_carried[node] ? "moves along" : "-";
    text += padded(event, 13) + padded(std::to_string(shape.depths[node]), 7) +
            padded(volume_text(change.before->bounds[node]), 14) + padded(volume_text(change.after->bounds[node]), 14) +
            graph.path(node) + "\n";
  }
  text += "computed when asked for: " + counted(change.work.worlds, "place") + ", " +
          counted(change.work.bounds, "bound") + ", from " + counted(change.work.children_read, "bound") +
          " of children\n";
  return text;
}

std::string motion_table(const SceneGraph& graph, const std::vector<GraphFrame>& frames, NodeId node) {
  std::string text = "frame            told    root          " + graph.path(node) + "\n";
  for (const GraphFrame& frame : frames) {
    text += padded(frame.title, 17) + padded(std::to_string(frame.told.size()), 8) +
            padded(volume_text(frame.bounds->bounds[root_node]), 14) + volume_text(frame.bounds->bounds[node]) + "\n";
  }
  return text;
}

}  // namespace sightline::viz
