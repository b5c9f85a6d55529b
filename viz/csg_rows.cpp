#include "viz/csg_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "sightline/csg/span_list.h"
#include "viz/material_color.h"

namespace sightline::viz {
namespace {

using Point = Canvas::Point;
using Align = Canvas::Align;

constexpr double step_in = 22;  // of the tree, a level

/// Two circles, with what the operation makes of them filled.
void draw_sign(Canvas& canvas, Operation operation, Point center, double radius) {
  constexpr int slices = 36;
  const double apart = 0.58 * radius, height = 2 * radius / slices;
  for (int i = 0; i < slices; ++i) {
    const double y = -radius + (i + 0.5) * height, half = std::sqrt(std::max(0.0, radius * radius - y * y));
    std::array<double, 4> ends{-apart - half, -apart + half, apart - half, apart + half};
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double middle = 0.5 * (ends[k] + ends[k + 1]);
      if (!is_inside(operation, std::fabs(middle + apart) < half, std::fabs(middle - apart) < half)) continue;
      canvas.rectangle({center.x + ends[k], center.y + y - height / 2}, ends[k + 1] - ends[k], height,
                       {0.45, 0.50, 0.60});
    }
  }
  for (const double side : {-apart, apart}) canvas.ring({center.x + side, center.y}, radius, 1.3, ink);
}

void draw_complement_sign(Canvas& canvas, Point center, double radius) {
  canvas.rectangle({center.x - 1.5 * radius, center.y - radius}, 3 * radius, 2 * radius, {0.45, 0.50, 0.60});
  canvas.disc(center, 0.72 * radius, {1, 1, 1});
  canvas.ring(center, 0.72 * radius, 1.3, ink);
}

class RowsDrawing {
 public:
  RowsDrawing(Canvas& canvas, const CsgLayout& layout, const LadderLayout& rows, const Ladder& ladder,
              const LadderSolid& solid)
      : canvas_(canvas), layout_(layout), rows_(rows), ladder_(ladder), solid_(solid) {}

  void run() {
    draw_bands();
    draw_guides();
    for (const ShownRow& row : rows_.rows) {
      draw_tree(row);
      draw_bar(row);
      draw_steps(row);
    }
    draw_left_out();
    draw_axis();
  }

 private:
  const LadderRow& node(const ShownRow& row) const { return ladder_.rows[row.row]; }
  double x_of(double t) const { return rows_.x_of(layout_, t); }
  double middle(const ShownRow& row) const {
    return row.y + (node(row).kind == SolidTree::Kind::operation ? 16 * rows_.scale : row.height / 2);
  }
  bool is_hit(double t) const { return ladder_.hit && ladder_.hit->boundary.t == t; }
  double bottom() const { return rows_.rows_bottom + 8; }

  void draw_bands() {
    const double left = layout_.tree_left() - 6, right = layout_.bars_right() + 14;
    for (const ShownRow& row : rows_.rows) {
      if (node(row).kind != SolidTree::Kind::operation) continue;
      canvas_.rectangle({left, row.y + 1}, right - left, row.height - 2, band);
    }
    if (rows_.has_origin && rows_.t_min < 0) {
      const double x = layout_.bars_left();
      canvas_.rectangle({x, CsgLayout::top}, x_of(0) - x, bottom() - CsgLayout::top, {0.2, 0.25, 0.35}, 0.07);
    }
  }

  /// Through the section and all rows, at every boundary of a primitive.
  void draw_guides() {
    std::set<double> places;
    for (const LadderRow& row : ladder_.rows) {
      for (const Boundary& boundary : row.boundaries) places.insert(boundary.t);
    }
    for (const double t : places) {
      if (is_hit(t)) continue;
      canvas_.dashes({x_of(t), CsgLayout::top}, {x_of(t), bottom()}, 1, 3, 3, {0.35, 0.40, 0.50}, 0.42);
    }
    if (rows_.has_origin) {
      canvas_.line({x_of(0), CsgLayout::top}, {x_of(0), bottom()}, 1.6, ink);
    }
    if (ladder_.hit) {
      const double x = x_of(ladder_.hit->boundary.t);
      canvas_.line({x, CsgLayout::top}, {x, bottom()}, 2.2, accent);
    }
  }

  void draw_tree(const ShownRow& row) {
    const double scale = rows_.scale, x = layout_.tree_left() + step_in * row.depth * scale, y = middle(row);
    if (row.parent >= 0) {
      const ShownRow& above = rows_.rows[static_cast<std::size_t>(row.parent)];
      const double stem = layout_.tree_left() + step_in * above.depth * scale + 9 * scale;
      canvas_.line({stem, middle(above) + 12 * scale}, {stem, y}, 1.3, faint_ink);
      canvas_.line({stem, y}, {x - 1, y}, 1.3, faint_ink);
    }
    double right = x;
    if (row.role != ' ') {
      canvas_.text({x + 1, y}, std::string(1, row.role), {13 * scale, soft_ink, Align::left, true});
      right += 15 * scale;
    }
    const LadderRow& n = node(row);
    std::string material;
    if (n.kind == SolidTree::Kind::primitive) {
      const Rgb color = material_color(solid_.material(n.primitive), n.primitive);
      canvas_.rectangle({right, y - 8 * scale}, 16 * scale, 16 * scale, diluted(color, 1.0));
      right += 23 * scale;
      material = solid_.material(n.primitive);
    } else {
      const Point center{right + 14 * scale, y};
      n.kind == SolidTree::Kind::operation ? draw_sign(canvas_, n.operation, center, 8.5 * scale)
                                           : draw_complement_sign(canvas_, center, 8.5 * scale);
      right += 36 * scale;
    }
    const Canvas::TextStyle style{15 * scale, ink, Align::left, n.kind != SolidTree::Kind::primitive};
    std::string name = name_of(n, solid_.plain());
    const double room = layout_.bars_left() - 26 - right;
    if (canvas_.text_width(name, style) > room && n.operation == Operation::differ) name = "sym. difference";
    canvas_.text({right, y}, name, style);
    if (!material.empty()) {
      right += canvas_.text_width(name, style) + 8;
      const Canvas::TextStyle fine{13 * scale, soft_ink};
      if (right + canvas_.text_width(material, fine) < layout_.bars_left() - 6)
        canvas_.text({right, y}, material, fine);
    }
    if (n.is_fold && row.height > 30)
      canvas_.text({right, y + 17 * scale}, "folded in pairs", {11.5 * scale, soft_ink});
  }

  void draw_bar(const ShownRow& row) {
    const LadderRow& n = node(row);
    const double left = layout_.bars_left(), right = layout_.bars_right(), y = middle(row);
    const double height = (row.row == 0 ? 19 : 15) * rows_.scale;
    canvas_.line({left, y}, {right, y}, 1, faint_ink);
    for_each_span(n.boundaries, n.begins_inside, [&](double, double, const Boundary* enter, const Boundary* leave) {
      const double from = enter ? x_of(enter->t) : left - 2, to = leave ? x_of(leave->t) : right + 2;
      const auto [begin, end] = bar_colors(solid_, enter, leave);
      canvas_.gradient({from, y - height / 2}, to - from, height, diluted(begin, 0.62), diluted(end, 0.62));
      const double cap = std::min(4.0, (to - from) / 2);
      if (enter) canvas_.rectangle({from, y - height / 2}, cap, height, begin);
      if (leave) canvas_.rectangle({to - cap, y - height / 2}, cap, height, end);
      if (!enter) canvas_.arrow_head({left - 12, y}, M_PI, 15 * rows_.scale, diluted(begin, 0.8));
      if (!leave) canvas_.arrow_head({right + 12, y}, 0, 15 * rows_.scale, diluted(end, 0.8));
    });
    if (n.is_empty()) canvas_.text({right, y - 9 * rows_.scale}, "empty", {12 * rows_.scale, soft_ink, Align::right});
  }

  void draw_steps(const ShownRow& row) {
    const LadderRow& n = node(row);
    const double scale = rows_.scale, y = middle(row);
    if (row.row == 0 && ladder_.hit) {
      canvas_.ring({x_of(ladder_.hit->boundary.t), y}, 11.5 * scale, 3 * scale, accent);
    }
    if (n.steps.empty()) return;
    const double upper = y + 18 * scale, lower = upper + 12.5 * scale, size = 13 * scale, apart = 21 * scale;
    const Canvas::TextStyle fine{11.5 * scale, soft_ink, Align::right};
    canvas_.text({layout_.bars_left() - 4, upper}, "A", fine);
    canvas_.text({layout_.bars_left() - 4, lower}, "B", fine);
    const std::vector<double> places = spread(n.steps, apart);
    for (std::size_t i = 0; i < n.steps.size(); ++i) {
      const LadderStep& step = n.steps[i];
      const double x = x_of(step.t);
      draw_mark({x, y}, step.is_kept);
      if (std::fabs(places[i] - x) > 3) canvas_.line({x, y + 6 * scale}, {places[i], upper - 7 * scale}, 1, soft_ink);
      const Transition& c = step.change;
      canvas_.rectangle({places[i] - 9 * scale, upper - 7 * scale}, 18 * scale, 27 * scale, band);
      draw_pair(places[i], upper, c.was_in_a, c.is_in_a, size);
      draw_pair(places[i], lower, c.was_in_b, c.is_in_b, size);
    }
  }

  void draw_mark(Point at, bool is_kept) {
    const double radius = 5.6 * rows_.scale;
    canvas_.disc(at, radius + 1.6, {1, 1, 1});
    if (is_kept) {
      canvas_.disc(at, radius, ink);
    } else {
      canvas_.ring(at, radius - 0.8, 1.7, soft_ink);
    }
  }

  /// Bold where it changes.
  void draw_pair(double x, double y, bool was, bool is, double size) {
    const std::string text = std::string(was ? "1" : "0") + (is ? "1" : "0");
    canvas_.text({x, y}, text, {size, was != is ? ink : soft_ink, Align::center, was != is});
  }

  /// Moves what stands too close apart, no farther than it must.
  std::vector<double> spread(const std::vector<LadderStep>& steps, double apart) const {
    std::vector<double> places;
    for (const LadderStep& step : steps) places.push_back(x_of(step.t));
    for (int round = 0; round < 200; ++round) {
      for (std::size_t i = 1; i < places.size(); ++i) {
        const double overlap = apart - (places[i] - places[i - 1]);
        if (overlap > 0) places[i - 1] -= overlap / 2, places[i] += overlap / 2;
      }
    }
    return places;
  }

  void draw_left_out() {
    std::string text;
    if (rows_.missed > 0) text = std::to_string(rows_.missed) + " more primitives, which the ray misses";
    if (rows_.cut > 0) {
      text += (text.empty() ? "" : "; ") + std::to_string(rows_.cut) + " more rows, for which there is no room";
    }
    if (!text.empty()) {
      canvas_.text({layout_.tree_left(), bottom() + 38}, "not drawn: " + text, {12.5, soft_ink});
    }
  }

  /// Values of t in two lines, those of the result first; what finds no room has its line alone.
  void draw_axis() {
    std::vector<double> places;
    if (ladder_.hit) places.push_back(ladder_.hit->boundary.t);
    if (rows_.has_origin) places.push_back(0);
    for (const LadderRow& row : ladder_.rows) {
      for (const Boundary& boundary : row.boundaries) {
        if (std::find(places.begin(), places.end(), boundary.t) == places.end()) places.push_back(boundary.t);
      }
    }
    canvas_.text({layout_.bars_left() - 14, bottom() + 11}, "t =", {13, soft_ink, Align::right});
    std::array<std::vector<std::pair<double, double>>, 2> taken;
    for (const double t : places) {
      const Canvas::TextStyle style{13.5, is_hit(t) ? accent : ink, Align::center, is_hit(t)};
      const std::string text = short_text(t);
      const double half = canvas_.text_width(text, style) / 2 + 5, x = x_of(t);
      for (std::size_t line = 0; line < taken.size(); ++line) {
        const bool is_free = std::none_of(taken[line].begin(), taken[line].end(), [&](const auto& other) {
          return x - half < other.second && x + half > other.first;
        });
        if (!is_free) continue;
        taken[line].emplace_back(x - half, x + half);
        canvas_.text({x, bottom() + 11 + 17 * static_cast<double>(line)}, text, style);
        break;
      }
    }
  }

  Canvas& canvas_;
  const CsgLayout& layout_;
  const LadderLayout& rows_;
  const Ladder& ladder_;
  const LadderSolid& solid_;
};

}  // namespace

void draw_rows(Canvas& canvas, const CsgLayout& layout, const LadderLayout& rows, const Ladder& ladder,
               const LadderSolid& solid) {
  RowsDrawing(canvas, layout, rows, ladder, solid).run();
}

void draw_legend(Canvas& canvas, const CsgLayout& layout, const Ladder& ladder) {
  const Canvas::TextStyle style{13.5, ink}, bold{13, ink, Canvas::Align::center, true};
  double x = layout.tree_left() + 6;
  const double y = layout.height() - CsgLayout::bottom + 34;
  const auto say = [&](const std::string& text) {
    canvas.text({x, y}, text, style);
    x += canvas.text_width(text, style) + 26;
  };
  canvas.disc({x, y}, 5.6, ink);
  x += 12, say("kept: the result changes");
  canvas.ring({x, y}, 4.8, 1.7, soft_ink);
  x += 12, say("discarded: it goes on");
  canvas.ring({x, y}, 8, 3, accent);
  x += 16, say("the hit: first boundary with t >= 0");
  canvas.text({x + 4, y - 6}, "01", bold);
  canvas.text({x + 4, y + 7}, "11", bold);
  x += 20, say("was, is in A; was, is in B");

  const LadderRow& root = ladder.rows.front();
  if (root.kind != SolidTree::Kind::operation) return;
  constexpr std::array rules{"wasInA or wasInB  differs from  isInA or isInB",
                             "wasInA and wasInB  differs from  isInA and isInB",
                             "wasInA and not wasInB  differs from  isInA and not isInB",
                             "(wasInA differs from wasInB)  differs from  (isInA differs from isInB)"};
  constexpr std::array names{"union", "intersection", "difference", "symmetric difference"};
  const auto kind = static_cast<std::size_t>(root.operation);
  canvas.text({layout.tree_left(), y + 27},
              std::string("In the ") + names[kind] + " a transition is kept where  " + rules[kind], {13.5, soft_ink});
}

std::string short_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", number);
  return text.data();
}

Rgb color_of(const LadderSolid& solid, const Boundary& boundary) {
  return material_color(solid.material(boundary.primitive), boundary.primitive);
}

BarColors bar_colors(const LadderSolid& solid, const Boundary* enter, const Boundary* leave) {
  const Rgb none{0.55, 0.58, 0.64};
  const Rgb begin = enter ? color_of(solid, *enter) : leave ? color_of(solid, *leave) : none;
  return {begin, leave ? color_of(solid, *leave) : begin};
}

}  // namespace sightline::viz
