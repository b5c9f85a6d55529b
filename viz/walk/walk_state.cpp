#include "viz/walk/walk_state.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace sightline::viz {
namespace {

using Kind = WalkStep::Kind;

/// With as many digits as tell it from the other.
std::string text_beside(double t, double other) {
  char text[32], beside[32];
  for (int digits = 4; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, t);
    std::snprintf(beside, sizeof beside, "%.*g", digits, other);
    if (std::string_view(text) != beside) break;
  }
  return std::isinf(t) || t == other ? text_of_t(t) : text;
}

constexpr std::uint32_t leaf_bit = 1u << 31;

/// "node 12", "leaf 340"
std::string name_of_node(std::uint32_t node) { return (node & leaf_bit ? "leaf " : "node ") + number_of_node(node); }

std::string visit_sentence(const Walk& walk, const WalkStep& step, std::size_t cell) {
  const std::string name = name_of_node(step.node), at = " at t = " + text_of_t(step.t);
  const Cell& opened = walk.cells[cell].cell;
  const bool is_empty = opened.node != step.node || (opened.is_leaf && opened.range.count == 0);
  if (is_empty) return "Passes through an empty cell, " + name + "," + at + ".";
  const Children children = children_of(walk, cell);
  if (children.met.empty() && children.beside.empty()) {
    return "Enters " + name + at + ": it has nothing to test.";
  }
  std::string text = "Opens " + name + ", entered" + at + ". ";
  if (children.met.empty()) return text + "The ray passes all its children by.";
  constexpr std::size_t most = 3;
  const std::size_t shown = std::min(children.met.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    const WalkStep& later = walk.steps[*walk.cells[children.met[i]].opened];
    std::string name_of_child = name_of_node(later.node);
    if (i == 0) name_of_child[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name_of_child[0])));
    text += (i == 0 ? "" : i + 1 == children.met.size() ? " and " : ", ") + name_of_child + " at " + text_of_t(later.t);
  }
  if (children.met.size() > most) text += " and " + std::to_string(children.met.size() - most) + " more";
  text += children.met.size() > 1 ? " are met" : " is met";
  if (!children.beside.empty()) text += "; " + std::to_string(children.beside.size()) + " passed by";
  return text + ".";
}

std::string candidate_sentence(const WalkStep& step, const Hit<float>& before) {
  const std::string name = "Tests triangle " + std::to_string(step.triangle) + ": ";
  if (!step.is_crossed) return name + "the ray misses it.";
  const std::string at = "crossed at t = " + text_of_t(step.t);
  if (step.is_hit) return name + at + ", the nearest hit so far. The far limit moves there.";
  if (before.is_hit() && before.prim_id == step.triangle) return name + at + " again; it is the nearest hit already.";
  return name + at + (step.t > before.t ? ", beyond" : ", as far as") + " the nearest hit so far, triangle " +
         std::to_string(before.prim_id) + ".";
}

}  // namespace

std::size_t current_cell(const Walk& walk, std::size_t step) { return walk.cell_of(walk.steps.at(step).node); }

std::vector<CellState> states_at(const Walk& walk, std::size_t step) {
  const std::size_t count = walk.cells.size();
  std::vector<std::uint8_t> leads_on(count), is_reached(count, 1);
  for (std::size_t i = count; i-- > 0;) {
    const WalkCell& cell = walk.cells[i];
    if (cell.parent && (cell.opened || leads_on[i])) leads_on[*cell.parent] = 1;
  }
  std::vector<CellState> states(count, CellState::unseen);
  for (std::size_t i = 0; i < count; ++i) {
    const WalkCell& cell = walk.cells[i];
    if (cell.parent) {
      const auto& above = walk.cells[*cell.parent].opened;
      is_reached[i] = above ? *above <= step : is_reached[*cell.parent];
    }
    if (cell.opened && *cell.opened <= step) {
      states[i] = walk.steps[*cell.opened].kind == Kind::cull ? CellState::culled : CellState::opened;
    } else if (!cell.opened && is_reached[i]) {
      states[i] = leads_on[i] ? CellState::opened : CellState::beside;
    }
  }
  for (const std::size_t i : walk.pending(step)) states[i] = CellState::pending;
  if (step < walk.steps.size()) states[current_cell(walk, step)] = CellState::current;
  return states;
}

Children children_of(const Walk& walk, std::size_t cell) {
  Children children;
  std::vector<std::uint8_t> is_direct(walk.cells.size()), leads_on(walk.cells.size());
  for (std::size_t i = walk.cells.size(); i-- > 0;) {
    if (walk.cells[i].parent && (walk.cells[i].opened || leads_on[i])) leads_on[*walk.cells[i].parent] = 1;
  }
  for (std::size_t i = cell + 1; i < walk.cells.size(); ++i) {
    const WalkCell& below = walk.cells[i];
    if (!below.parent || (*below.parent != cell && !is_direct[*below.parent])) continue;
    if (below.opened) {
      children.met.push_back(i);
    } else if (leads_on[i]) {
      is_direct[i] = 1;  // one of several levels that are opened at once
    } else {
      children.beside.push_back(i);
    }
  }
  std::ranges::sort(children.met, {}, [&](std::size_t i) { return *walk.cells[i].opened; });
  return children;
}

TraversalStats statistics_at(const Walk& walk, std::size_t step) {
  TraversalStats stats;
  for (std::size_t i = 0; i <= step && i < walk.steps.size(); ++i) {
    stats.nodes += walk.steps[i].kind == Kind::visit;
    stats.leaves += walk.steps[i].kind == Kind::leaf;
    stats.candidates += walk.steps[i].kind == Kind::candidate;
    stats.culled += walk.steps[i].kind == Kind::cull;
  }
  return stats;
}

double t_at(const Walk& walk, std::size_t step) {
  const WalkStep& at = walk.steps.at(step);
  if (at.kind != Kind::candidate || at.is_crossed) return std::min(at.t, at.far);
  while (step > 0 && walk.steps[step].kind == Kind::candidate) --step;
  return std::min(walk.steps[step].t, at.far);
}

std::string sentence_of(const Walk& walk, std::size_t index) {
  const WalkStep& step = walk.steps.at(index);
  const std::string name = number_of_node(step.node);
  switch (step.kind) {
    case Kind::visit:
      return visit_sentence(walk, step, current_cell(walk, index));
    case Kind::leaf: {
      const std::uint32_t count = walk.cells[current_cell(walk, index)].cell.range.count;
      return "Opens leaf " + name + ", entered at t = " + text_of_t(step.t) + ": " + std::to_string(count) +
             (count == 1 ? " candidate" : " candidates") + " to test.";
    }
    case Kind::candidate:
      return candidate_sentence(step, index > 0 ? walk.hit_at(index - 1) : Hit<float>());
    case Kind::cull:
      return "Drops " + name_of_node(step.node) + " unopened: it begins at t = " + text_beside(step.t, step.far) +
             ", beyond the far limit " + text_beside(step.far, step.t) + ".";
  }
  return {};
}

std::string number_of_node(std::uint32_t node) { return std::to_string(node & ~leaf_bit); }

std::string text_of_t(double t) {
  if (std::isinf(t)) return t > 0 ? "infinity" : "-infinity";
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", t);
  return text;
}

std::size_t leaf_beside(const Walk& walk, std::size_t step, int direction) {
  for (std::size_t at = step; direction > 0 ? at + 1 < walk.steps.size() : at > 0;) {
    at = direction > 0 ? at + 1 : at - 1;
    if (walk.steps[at].kind == Kind::leaf) return at;
  }
  return step;
}

}  // namespace sightline::viz
