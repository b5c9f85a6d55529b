#include "viz/walk/walk_panels.h"

#include <algorithm>
#include <cmath>

#include "viz/partition_picture.h"
#include "viz/walk/split_plane.h"
#include "viz/walk/walk_colors.h"
#include "viz/walk/walk_progress.h"

namespace sightline::viz {
namespace {

using Align = Canvas::Align;

std::string plural(std::size_t count, const std::string& one, const std::string& many) {
  return with_commas(count) + " " + (count == 1 ? one : many);
}

void frame(Canvas& canvas, const Panel& p, double width, const Rgb& color, double opacity = 1) {
  const Canvas::Point a{p.x, p.y}, b{p.x + p.width, p.y}, c{b.x, p.y + p.height}, d{p.x, c.y};
  canvas.line(a, b, width, color, opacity);
  canvas.line(b, c, width, color, opacity);
  canvas.line(c, d, width, color, opacity);
  canvas.line(d, a, width, color, opacity);
}

void cross(Canvas& canvas, Canvas::Point at, double radius, const Rgb& color) {
  canvas.line({at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}, 2, color);
  canvas.line({at.x - radius, at.y + radius}, {at.x + radius, at.y - radius}, 2, color);
}

void node_mark(Canvas& canvas, Canvas::Point at, double radius, CellState state, bool is_new) {
  switch (state) {
    case CellState::unseen:
    case CellState::beside:
      canvas.disc(at, 0.7 * radius, state == CellState::beside ? Rgb{0.8, 0.81, 0.84} : pale);
      break;
    case CellState::culled:
      canvas.disc(at, radius, {0.97, 0.92, 0.95});
      cross(canvas, at, radius, color_of(state));
      break;
    default:
      canvas.disc(at, radius, color_of(state));
  }
  if (state == CellState::current) canvas.ring(at, radius + 3.5, 2.4, ink);
  if (!is_new || state == CellState::unseen) return;
  const double reach = radius + 2;
  canvas.line({at.x - reach, at.y + reach + 1}, {at.x + reach, at.y + reach + 1}, 2, ink);
}

void draw_title(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::size_t step,
                const WalkWords& words) {
  const Panel& p = layout.title;
  std::string title = model.structure + " on " + model.scene;
  if (!model.walk.steps.empty()) {
    title += ": step " + std::to_string(step) + " of 0 to " + std::to_string(model.last_step());
  }
  canvas.text({p.x, p.y + 20}, title, {large, ink, Align::left, true});
  std::string about = plural(model.tracer->mesh().size(), "triangle", "triangles") + words.mesh + "; " +
                      plural(model.walk.all_cells, "cell", "cells");
  if (model.tracer->is_lazy()) {
    about += ", of which this ray has made " + with_commas(model.walk.all_cells - model.cells_before);
  }
  about += ". H shows the keys of the window.";
  canvas.text({p.x, p.y + 48}, about, {small, soft_ink});
}

void draw_tree(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::span<const CellState> states,
               std::size_t current) {
  const TreeLayout tree = lay_out_tree(model.walk, states, current, layout.tree);
  std::string head = "Hierarchy: " + plural(tree.nodes.size(), "cell", "cells");
  if (tree.left_out > 0) head += ", " + with_commas(tree.left_out) + " more below those with +";
  if (tree.first_depth > 0) head += ", from depth " + std::to_string(tree.first_depth);
  canvas.text({layout.tree.x, layout.tree.y - 16}, head, {small, soft_ink});
  for (const auto& node : tree.nodes) {
    if (!node.above) continue;
    const auto& above = tree.nodes[*node.above];
    const bool is_faint = states[node.cell] == CellState::unseen || states[node.cell] == CellState::beside;
    canvas.line({above.x, above.y}, {node.x, node.y}, 1.4, is_faint ? pale : gray);
  }
  for (const auto& node : tree.nodes) {
    node_mark(canvas, {node.x, node.y}, tree.radius, states[node.cell], model.is_new[node.cell] != 0);
    if (node.hidden > 0) {
      canvas.line({node.x + tree.radius + 2, node.y}, {node.x + tree.radius + 8, node.y}, 1.6, soft_ink);
      canvas.line({node.x + tree.radius + 5, node.y - 3}, {node.x + tree.radius + 5, node.y + 3}, 1.6, soft_ink);
    }
  }
  for (const auto& node : tree.nodes) {
    if (node.cell != current || model.walk.steps.empty()) continue;
    const bool is_right = node.x < layout.tree.x + 0.8 * layout.tree.width;
    const std::string name = number_of_node(model.walk.cells[current].cell.node);
    const Canvas::TextStyle style{small, ink, is_right ? Align::left : Align::right, true};
    const double width = canvas.text_width(name, style), x = node.x + (is_right ? 1 : -1) * (tree.radius + 10);
    canvas.rectangle({is_right ? x - 3 : x - width - 3, node.y - 11}, width + 6, 22, {1, 1, 1}, 0.85);
    canvas.text({x, node.y}, name, style);
  }
}

void draw_treemap(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::span<const CellState> states,
                  std::size_t current) {
  const std::vector<Panel> panels = lay_out_treemap(model.walk, model.candidates, layout.treemap);
  canvas.text({layout.treemap.x, layout.treemap.y - 16}, "The same as areas: candidates below a cell",
              {small, soft_ink});
  canvas.rectangle({layout.treemap.x, layout.treemap.y}, layout.treemap.width, layout.treemap.height, band);
  std::vector<std::uint8_t> has_children(panels.size());
  for (const WalkCell& cell : model.walk.cells) {
    if (cell.parent) has_children[*cell.parent] = 1;
  }
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& p = panels[i];
    if (p.width < 0.5 || p.height < 0.5) continue;
    const bool is_opened_inner = has_children[i] != 0 && states[i] == CellState::opened;
    if (!is_opened_inner && states[i] != CellState::unseen) {
      // Opaque, so that what is within does not mix with it.
      const double share = states[i] == CellState::beside ? 0 : states[i] == CellState::current ? 1 : 0.62;
      canvas.rectangle({p.x, p.y}, p.width, p.height, over_white(color_of(states[i]), share));
    }
    if (states[i] == CellState::culled && p.width > 8 && p.height > 8) {
      canvas.line({p.x, p.y}, {p.x + p.width, p.y + p.height}, 1.5, color_of(CellState::culled));
      canvas.line({p.x, p.y + p.height}, {p.x + p.width, p.y}, 1.5, color_of(CellState::culled));
    }
    if (states[i] != CellState::unseen && p.width > 2.5 && p.height > 2.5) frame(canvas, p, 1, gray, 0.8);
  }
  if (model.walk.steps.empty()) return;
  Panel ring = panels[current];
  if (ring.width < 6) ring.x -= 3, ring.width += 6;
  if (ring.height < 6) ring.y -= 3, ring.height += 6;
  frame(canvas, ring, 3, ink);
}

void draw_legend(Canvas& canvas, const WalkLayout& layout, const WalkModel& model) {
  const Panel& p = layout.legend;
  constexpr std::array labels = {"the current cell", "put aside", "opened earlier", "culled", "passed by"};
  constexpr std::array states = {CellState::current, CellState::pending, CellState::opened, CellState::culled,
                                 CellState::beside};
  double x = p.x;
  const auto entry = [&](double y, const std::string& label, auto&& mark) {
    mark(Canvas::Point{x + 12, y});
    canvas.text({x + 32, y}, label, {small, ink});
    x += 58 + canvas.text_width(label, {small, ink});
  };
  for (std::size_t i = 0; i < states.size(); ++i) {
    entry(p.y + 14, labels[i], [&](Canvas::Point at) { node_mark(canvas, at, 9, states[i], false); });
  }
  if (has_split_planes(model.tracer->name())) {
    entry(p.y + 14, "split plane", [&](Canvas::Point at) {
      const Canvas::Point a{at.x - 11, at.y - 8}, b{at.x + 11, at.y - 8}, c{at.x + 11, at.y + 8},
          d{at.x - 11, at.y + 8};
      for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, d}, {d, a}, {a, c}, {b, d}}) {
        canvas.line(from, to, 2, split_color);
      }
    });
  }
  if (model.tracer->is_lazy()) {
    entry(p.y + 14, "made for this ray", [&](Canvas::Point at) {
      canvas.dashes({at.x - 10, at.y}, {at.x + 10, at.y}, 2, 4, 3, ink);
    });
  }
  x = p.x;
  const auto outline = [&](Canvas::Point at, const Rgb& color) {
    const Canvas::Point a{at.x - 10, at.y + 8}, b{at.x + 10, at.y + 8}, c{at.x, at.y - 9};
    canvas.line(a, b, 2, color), canvas.line(b, c, 2, color), canvas.line(c, a, 2, color);
  };
  const auto fill = [&](Canvas::Point at, const Rgb& color) {
    const Canvas::Point corners[] = {{at.x - 10, at.y + 8}, {at.x + 10, at.y + 8}, {at.x, at.y - 9}};
    canvas.polygon(corners, color);
  };
  const double y = p.y + 48;
  entry(y, "to be tested", [&](Canvas::Point at) { outline(at, orange); });
  entry(y, "tested", [&](Canvas::Point at) { outline(at, ink); });
  entry(y, "crossed", [&](Canvas::Point at) { fill(at, sky), outline(at, ink); });
  entry(y, "the nearest hit so far", [&](Canvas::Point at) { fill(at, vermillion); });
  entry(y, "the far limit", [&](Canvas::Point at) { canvas.ring(at, 8, 3, vermillion); });
  entry(y, "node", [&](Canvas::Point at) { canvas.rectangle({at.x - 4, at.y - 9}, 8, 18, gray); });
  entry(y, "leaf", [&](Canvas::Point at) { canvas.rectangle({at.x - 4, at.y - 9}, 8, 18, orange); });
}

}  // namespace

void draw_panels(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::size_t step,
                 const WalkWords& words) {
  draw_title(canvas, layout, model, step, words);
  draw_legend(canvas, layout, model);
  if (!model.walk.cells.empty()) {
    const std::vector<CellState> states = states_at(model.walk, step);
    const std::size_t current = model.walk.steps.empty() ? 0 : current_cell(model.walk, step);
    draw_tree(canvas, layout, model, states, current);
    draw_treemap(canvas, layout, model, states, current);
  }
  draw_facts(canvas, layout, model, step);
  draw_timeline(canvas, layout, model, step);
  const Canvas::TextStyle style{small, soft_ink};
  canvas.text({layout.command.x, layout.command.y + 12}, canvas.shortened(words.command, style, layout.command.width),
              style);
}

void draw_labels(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::size_t step,
                 const SpaceCamera& camera) {
  frame(canvas, layout.space, 1, faint_ink);
  if (model.walk.steps.empty()) return;
  const Ray<double> ray = to_double(model.walk.ray);
  const Stretch shown = shown_stretch(model.tracer->mesh().bounds(), model.walk.ray);
  const auto place = [&](double t) -> std::optional<Canvas::Point> {
    if (!(t >= shown.from && t <= shown.to)) return std::nullopt;
    const auto at = camera.project(ray.at(t));
    if (!at || std::fabs(at->x) > 1 || std::fabs(at->y) > 1) return std::nullopt;
    const Panel& p = layout.space;
    return Canvas::Point{p.x + (at->x + 1) / 2 * p.width, p.y + (1 - at->y) / 2 * p.height};
  };
  const auto label = [&](Canvas::Point at, double down, const std::string& text, const Rgb& color) {
    const Canvas::TextStyle style{medium, color, Align::left, true};
    const double width = canvas.text_width(text, style);
    const double x = std::min(at.x + 14, layout.space.x + layout.space.width - width - 10);
    canvas.rectangle({x - 4, at.y + down - 13}, width + 8, 26, {1, 1, 1}, 0.8);
    canvas.text({x, at.y + down}, text, style);
  };
  const double t = t_at(model.walk, step), far = model.walk.steps[step].far;
  if (const auto at = place(t)) {
    canvas.disc(*at, 6, ink);
    label(*at, -26, "t = " + text_of_t(t), ink);
  }
  if (const auto at = place(far)) {
    canvas.ring(*at, 10, 3.5, vermillion);
    label(*at, 28, "far limit " + text_of_t(far), {0.65, 0.26, 0});
  }
}

}  // namespace sightline::viz
