#include "viz/build/build_chart.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRenderWindow.h>
#include <vtkStringArray.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/build/replay.h"
#include "viz/paper.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr std::size_t most_bars = 40;
constexpr int svg_width = 960, svg_height = 620;

/// Indices of the candidates, the cheapest first.
std::vector<std::size_t> ranked(const Decision& decision) {
  std::vector<std::size_t> order(decision.candidates.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return decision.candidates[a].cost < decision.candidates[b].cost;
  });
  return order;
}

/// Curves over a chart that has the axes alone, in pixels: VTK 9.1 writes what is scaled to an SVG file in the wrong
/// place.
class DrawnCosts : public vtkContextItem {
 public:
  static DrawnCosts* New();
  vtkTypeMacro(DrawnCosts, vtkContextItem)

      vtkChartXY* chart = nullptr;
  const Decision* decision = nullptr;
  CostRange costs;
  std::string title;
  double scale = 1;

  bool Paint(vtkContext2D* painter) override {
    painter_ = painter;
    painter->GetTextProp()->SetFontFamilyToArial();
    painter->GetTextProp()->SetFontSize(static_cast<int>(19 * scale));
    painter->GetTextProp()->SetBold(false);
    painter->GetTextProp()->SetOrientation(0);
    legend_ = x_of(chart->GetAxis(vtkAxis::BOTTOM)->GetMinimum()) + px(10);
    if (!title.empty()) write(px(24), y_of(costs.hi) + px(52), title, ink);
    if (decision->chart == DecisionChart::ranked) {
      draw_bars();
    } else {
      draw_curves();
    }
    draw_leaf();
    if (decision->chart != DecisionChart::ranked) draw_chosen();
    return true;
  }

 private:
  float px(double units) const { return static_cast<float>(units * scale); }
  float x_of(double value) const { return pixel(vtkAxis::BOTTOM, 0, value); }
  float y_of(double value) const { return pixel(vtkAxis::LEFT, 1, value); }
  float pixel(int which, int along, double value) const {
    vtkAxis& axis = *chart->GetAxis(which);
    const double low = axis.GetMinimum(), high = axis.GetMaximum();
    const double from = axis.GetPoint1()[along], to = axis.GetPoint2()[along];
    return static_cast<float>(from + (value - low) / (high - low) * (to - from));
  }
  void pen(const Rgb& color, double width, int style = vtkPen::SOLID_LINE) {
    painter_->GetPen()->SetColorF(color[0], color[1], color[2]);
    painter_->GetPen()->SetWidth(px(width));
    painter_->GetPen()->SetLineType(style);
  }
  void brush(const Rgb& color) { painter_->GetBrush()->SetColorF(color[0], color[1], color[2], 1); }
  void write(float x, float y, const std::string& text, const Rgb& color, bool to_left = false) {
    painter_->GetTextProp()->SetColor(color[0], color[1], color[2]);
    to_left ? painter_->GetTextProp()->SetJustificationToRight() : painter_->GetTextProp()->SetJustificationToLeft();
    painter_->GetTextProp()->SetVerticalJustificationToBottom();
    painter_->DrawString(x, y, text);
  }

  /// Dashes are made here, as long in SVG files as on the screen.
  void line(float x0, float y0, float x1, float y1, double dash) {
    const float dx = x1 - x0, dy = y1 - y0, length = std::hypot(dx, dy);
    if (dash <= 0 || !(length > 0)) return painter_->DrawLine(x0, y0, x1, y1);
    const float step = px(dash);
    for (float at = 0; at < length; at += 2 * step) {
      const float end = std::min(at + step, length);
      painter_->DrawLine(x0 + dx * at / length, y0 + dy * at / length, x0 + dx * end / length, y0 + dy * end / length);
    }
  }

  void draw_curves() {
    const float top = y_of(costs.hi) + px(14);
    for (int axis = decision->chart == DecisionChart::by_cells ? -1 : 0; axis < 3; ++axis) {
      std::vector<std::vector<float>> pieces(1);  // parted where a cost is beyond the chart
      std::size_t count = 0;
      for (const BuildCandidate& candidate : decision->candidates) {
        if (candidate.axis != axis || !candidate.label.empty()) continue;
        if (candidate.cost > costs.hi) {
          if (!pieces.back().empty()) pieces.emplace_back();
          continue;
        }
        ++count;
        pieces.back().push_back(x_of(candidate.position));
        pieces.back().push_back(y_of(candidate.cost));
      }
      if (count == 0) continue;
      const Rgb color = axis < 0 ? ink : axis_colors[static_cast<std::size_t>(axis)];
      for (const std::vector<float>& points : pieces) draw_piece(points, color, axis, count <= 80);
      draw_key(axis, color, top);
    }
  }

  /// x solid, y in long dashes, z in short ones, measured along the curve. Few candidates show as marks, too.
  void draw_piece(const std::vector<float>& points, const Rgb& color, int axis, bool has_marks) {
    const double dash = axis == 1 ? 14 : axis == 2 ? 5 : 0;
    pen(color, 2.2);
    float along = 0;
    for (std::size_t i = 2; i + 1 < points.size(); i += 2) {
      along = dashed(points[i - 2], points[i - 1], points[i], points[i + 1], px(dash), along);
    }
    if (!has_marks && points.size() > 2) return;
    brush(color);
    pen(color, 1);
    for (std::size_t i = 0; i + 1 < points.size(); i += 2)
      painter_->DrawEllipse(points[i], points[i + 1], px(3.2), px(3.2));
  }

  /// One stretch of a dashed curve that is `along` long so far; returns its length after it.
  float dashed(float x0, float y0, float x1, float y1, float dash, float along) {
    const float dx = x1 - x0, dy = y1 - y0, length = std::hypot(dx, dy);
    if (!(dash > 0)) {
      painter_->DrawLine(x0, y0, x1, y1);
      return along + length;
    }
    for (float at = 0; at < length;) {
      const float phase = std::fmod(along + at, 2 * dash);
      const float end = std::min(length, at + std::max(0.01f * dash, (phase < dash ? dash : 2 * dash) - phase));
      if (phase < dash) {
        painter_->DrawLine(x0 + dx * at / length, y0 + dy * at / length, x0 + dx * end / length,
                           y0 + dy * end / length);
      }
      at = end;
    }
    return along + length;
  }

  void draw_key(int axis, const Rgb& color, float y) {
    const std::string name = axis < 0 ? "cost" : std::string("planes across ") + "xyz"[axis];
    pen(color, 2.6);
    line(legend_, y + px(9), legend_ + px(44), y + px(9), axis == 1 ? 14 : axis == 2 ? 5 : 0);
    write(legend_ + px(52), y, name, ink);
    legend_ += px(axis < 0 ? 130 : 222);
  }

  void draw_bars() {
    const std::vector<std::size_t> order = ranked(*decision);
    for (std::size_t rank = 0; rank < std::min(order.size(), most_bars); ++rank) {
      const BuildCandidate& candidate = decision->candidates[order[rank]];
      const bool is_chosen = decision->chosen == order[rank];
      const Rgb color = is_chosen             ? ink
                        : candidate.axis >= 0 ? axis_colors[static_cast<std::size_t>(candidate.axis)]
                                              : Rgb{0.62, 0.64, 0.70};
      pen(color, 1);
      brush(color);
      const double cost = std::min(candidate.cost, costs.hi);
      const float left = x_of(double(rank) + 0.62), right = x_of(double(rank) + 1.38), base = y_of(costs.lo);
      painter_->DrawRect(left, base, right - left, y_of(cost) - base);
      if (is_chosen) write(left, y_of(cost) + px(4), "taken: " + cost_text(candidate.cost), ink);
    }
    const float top = y_of(costs.hi) + px(12);
    for (int axis = -1; axis < 3; ++axis) {
      const bool is_there = std::ranges::any_of(decision->candidates, [&](const auto& c) { return c.axis == axis; });
      if (!is_there) continue;
      const Rgb color = axis < 0 ? Rgb{0.62, 0.64, 0.70} : axis_colors[static_cast<std::size_t>(axis)];
      pen(color, 1);
      brush(color);
      painter_->DrawRect(legend_, top + px(2), px(16), px(16));
      const std::string name = axis >= 0 ? std::string("across ") + "xyz"[axis] : decision->other_title;
      write(legend_ + px(24), top, name, ink);
      legend_ += px(axis < 0 ? 250 : 140);
    }
  }

  void draw_leaf() {
    if (!(decision->leaf_cost >= costs.lo && decision->leaf_cost <= costs.hi)) return;
    vtkAxis& axis = *chart->GetAxis(vtkAxis::BOTTOM);
    const float left = x_of(axis.GetMinimum()), right = x_of(axis.GetMaximum()), y = y_of(decision->leaf_cost);
    pen(ink, 2);
    line(left, y, right, y, 9);
    write(right - px(4), y + px(3), decision->leaf_title + ": " + cost_text(decision->leaf_cost), ink, true);
  }

  void draw_chosen() {
    if (!decision->chosen) return;
    const BuildCandidate& chosen = decision->candidates[*decision->chosen];
    const float x = x_of(chosen.position), y = y_of(std::min(chosen.cost, costs.hi));
    pen(ink, 1.4);
    line(x, y_of(costs.lo), x, y_of(costs.hi), 0);
    brush({1, 1, 1});
    pen(ink, 3);
    painter_->DrawEllipse(x, y, px(8), px(8));
    vtkAxis& axis = *chart->GetAxis(vtkAxis::BOTTOM);
    const bool is_right = chosen.position > 0.5 * (axis.GetMinimum() + axis.GetMaximum());
    const std::string at = chosen.axis >= 0 ? place_text(chosen.axis, chosen.position) : cost_text(chosen.position);
    const bool has_room = y - px(38) > y_of(costs.lo);
    write(x + px(is_right ? -14 : 14), y + px(has_room ? -34 : 12), "taken: " + at + ", " + cost_text(chosen.cost), ink,
          is_right);
  }

  vtkContext2D* painter_ = nullptr;
  float legend_ = 0;
};
vtkStandardNewMacro(DrawnCosts)

    /// Round numbers, some six of them.
    void set_ticks(vtkAxis& axis, double low, double high) {
  double step = std::pow(10, std::floor(std::log10((high - low) / 4)));
  for (const double more : {2.0, 2.5, 2.0}) {
    if ((high - low) / step > 8) step *= more;
  }
  auto places = New<vtkDoubleArray>::New();
  auto labels = New<vtkStringArray>::New();
  for (double at = std::ceil(low / step); at * step <= high; ++at) {
    places->InsertNextValue(at * step);
    labels->InsertNextValue(cost_text(at == 0 ? 0 : at * step));  // no -0
  }
  axis.SetCustomTickPositions(places, labels);
}

void style_axis(vtkAxis& axis, const std::string& title, double low, double high, double scale) {
  axis.SetTitle(title);
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetRange(low, high);
  set_ticks(axis, low, high);
  for (vtkTextProperty* text : {axis.GetTitleProperties(), axis.GetLabelProperties()}) {
    text->SetFontFamilyToArial();
    text->SetFontSize(static_cast<int>(19 * scale));
    text->SetBold(false);
    text->SetColor(ink[0], ink[1], ink[2]);
  }
  axis.GetPen()->SetWidth(static_cast<float>(1.2 * scale));
  axis.GetGridPen()->SetColorF(band[0] - 0.03, band[1] - 0.03, band[2] - 0.03);
  axis.GetGridPen()->SetWidth(static_cast<float>(scale));
}

/// What the chart's first axis spans.
std::pair<double, double> positions(const Decision& decision) {
  if (decision.chart == DecisionChart::ranked) {
    return {0.4, double(std::clamp<std::size_t>(decision.candidates.size(), 4, most_bars)) + 0.6};
  }
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  for (const BuildCandidate& c : decision.candidates) lo = std::min(lo, c.position), hi = std::max(hi, c.position);
  if (!(lo < hi)) return std::isfinite(lo) ? std::pair(lo - 1, lo + 1) : std::pair(0.0, 1.0);
  return {lo - 0.02 * (hi - lo), hi + 0.02 * (hi - lo)};
}

std::string first_title(const Decision& decision) {
  if (!decision.position_title.empty()) return decision.position_title;
  if (decision.chart == DecisionChart::ranked) return "candidates, the cheapest first";
  return "position of the plane, in the scene's units";
}

}  // namespace

CostRange cost_range(const Decision& decision) {
  CostRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
  const auto extend = [&](double cost) { range.lo = std::min(range.lo, cost), range.hi = std::max(range.hi, cost); };
  if (std::isfinite(decision.leaf_cost) && decision.leaf_cost > 0) extend(decision.leaf_cost);
  for (const BuildCandidate& candidate : decision.candidates) extend(candidate.cost);
  if (!(range.lo <= range.hi)) return {0, 1, 0};
  const bool is_ranked = decision.chart == DecisionChart::ranked;
  if (is_ranked) {
    range.lo = 0;
    const std::vector<std::size_t> order = ranked(decision);
    if (!order.empty()) {
      range.hi = decision.candidates[order[std::min(order.size(), most_bars) - 1]].cost;
      range.hi = std::max(range.hi, std::min(decision.leaf_cost, 2 * range.hi));
    }
  } else {
    double least = range.hi;
    for (const BuildCandidate& candidate : decision.candidates) least = std::min(least, candidate.cost);
    range.hi = std::min(range.hi, std::max(1.15 * decision.leaf_cost, 2.5 * least));
    range.lo = std::max(0.0, range.lo - 0.08 * (range.hi - range.lo));
  }
  if (!(range.hi > range.lo)) range.hi = range.lo + 1;
  range.hi += 0.06 * (range.hi - range.lo);
  for (const BuildCandidate& candidate : decision.candidates) range.beyond += candidate.cost > range.hi;
  return range;
}

vtkSmartPointer<vtkRenderer> chart_of(const Decision& decision, const std::string& title, double width, double height,
                                      double scale) {
  auto renderer = New<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  auto chart = New<vtkChartXY>::New();
  chart->SetAutoSize(false);
  const double above = (title.empty() ? 40 : 80) * scale;  // for what the curves are called
  chart->SetSize(vtkRectf(0, 0, static_cast<float>(width), static_cast<float>(height - above)));
  const CostRange costs = cost_range(decision);
  const auto [low, high] = positions(decision);
  style_axis(*chart->GetAxis(vtkAxis::BOTTOM), first_title(decision), low, high, scale);
  style_axis(*chart->GetAxis(vtkAxis::LEFT), "cost, in " + decision.cost_unit, costs.lo, costs.hi, scale);
  chart->AddPlot(vtkChart::LINE);  // axes show only with a plot
  auto drawn = New<DrawnCosts>::New();
  drawn->chart = chart;
  drawn->decision = &decision;
  drawn->costs = costs;
  drawn->title = title;
  drawn->scale = scale;
  auto actor = New<vtkContextActor>::New();
  actor->GetScene()->AddItem(chart);
  actor->GetScene()->AddItem(drawn);
  actor->GetScene()->SetRenderer(renderer);
  renderer->AddActor(actor);
  return renderer;
}

void write_chart_svg(const std::filesystem::path& path, const Decision& decision, const std::string& title) {
  write_svg(path, *chart_of(decision, title, svg_width, svg_height, 1), svg_width, svg_height);
}

}  // namespace sightline::viz
