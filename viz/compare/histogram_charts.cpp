#include "viz/compare/histogram_charts.h"

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
#include <vtkPlot.h>
#include <vtkRenderWindow.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "viz/paper.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

/// Distinct in gray and to the color-blind. Wong, "Points of view: Color blindness", 2011.
constexpr Rgb bar_color{0.34, 0.63, 0.83}, idle_color{0.72, 0.74, 0.79}, tail_color{0.78, 0.32, 0.00};
constexpr double text_size = 18, idle_left = -1, idle_right = -0.2;

double percent(std::uint64_t rays, std::uint64_t of) { return of == 0 ? 0 : 100 * double(rays) / double(of); }

struct PlacedChart {
  HistogramPanel panel;
  New<vtkChartXY> chart;
};

/// Bars and marks over charts, in pixels: VTK 9.1 writes what is scaled to an SVG file in the wrong place.
class DrawnBars : public vtkContextItem {
 public:
  static DrawnBars* New();
  vtkTypeMacro(DrawnBars, vtkContextItem)  // NOLINT

      std::vector<PlacedChart> charts;
  double scale = 1, height = 0;
  std::string title;  ///< Empty: no titles.

  bool Paint(vtkContext2D* painter) override {
    if (!title.empty()) draw_text(*painter, 30 * scale, (height - 38) * scale, title, 28, ink, true);
    for (const PlacedChart& each : charts) draw(*painter, each);
    return true;
  }

 private:
  static double pixel(vtkChartXY& chart, int which, double value) {
    vtkAxis& axis = *chart.GetAxis(which);
    const int along = which == vtkAxis::BOTTOM ? 0 : 1;
    const double low = axis.GetUnscaledMinimum(), high = axis.GetUnscaledMaximum();
    const double from = axis.GetPoint1()[along], to = axis.GetPoint2()[along];
    return from + (std::clamp(value, low, high) - low) / (high - low) * (to - from);
  }

  void draw_text(vtkContext2D& painter, double x, double y, const std::string& text, double size, const Rgb& color,
                 bool is_bold) const {
    vtkTextProperty* look = painter.GetTextProp();
    look->SetFontFamilyToArial();
    look->SetFontSize(std::max(1, static_cast<int>(std::lround(size * scale))));
    look->SetBold(is_bold);
    look->SetColor(color[0], color[1], color[2]);
    look->SetJustificationToLeft();
    look->SetVerticalJustificationToCentered();
    painter.DrawString(static_cast<float>(x), static_cast<float>(y), text);
  }

  void draw(vtkContext2D& painter, const PlacedChart& each) const {
    const HistogramPanel& panel = each.panel;
    const auto x = [&](double position) { return pixel(*each.chart, vtkAxis::BOTTOM, position); };
    const auto y = [&](double share) { return pixel(*each.chart, vtkAxis::LEFT, share); };
    painter.GetPen()->SetLineType(vtkPen::NO_PEN);
    for (const HistogramBin& bin : panel.bins) {
      const bool is_idle = bin.high == 0;
      const double left = x(is_idle ? idle_left : HistogramSheet::position_of(bin.low));
      const double right = x(is_idle ? idle_right : HistogramSheet::position_of(double(bin.high) + 1));
      const double top = y(percent(bin.rays, panel.statistics.rays)), gap = right - left > 6 * scale ? scale : 0;
      const Rgb& color = is_idle ? idle_color : bar_color;
      painter.GetBrush()->SetColorF(color[0], color[1], color[2], 1);
      if (top > y(0)) {
        painter.DrawRect(static_cast<float>(left), static_cast<float>(y(0)), static_cast<float>(right - left - gap),
                         static_cast<float>(top - y(0)));
      }
    }
    const double top = each.chart->GetAxis(vtkAxis::LEFT)->GetPoint2()[1];
    mark(painter, x, y(0), top, panel.statistics.median, "median", ink, vtkPen::SOLID_LINE, 0);
    mark(painter, x, y(0), top, panel.statistics.percentile_99, "99 %", tail_color, vtkPen::DASH_LINE, 1);
    if (title.empty()) return;
    const double left = panel.frame.x * scale, above = (height - panel.frame.y) * scale;
    draw_text(painter, left, above + 46 * scale, panel.title, 21, ink, true);
    draw_text(painter, left, above + 20 * scale, panel.text, text_size, soft_ink, false);
  }

  template <class X>
  void mark(vtkContext2D& painter, const X& x, double bottom, double top, std::uint32_t work, const char* name,
            const Rgb& color, int line, int row) const {
    const double at = x(work == 0 ? 0.5 * (idle_left + idle_right) : HistogramSheet::position_of(work + 0.5));
    painter.GetPen()->SetLineType(line);
    painter.GetPen()->SetWidth(static_cast<float>(2.2 * scale));
    painter.GetPen()->SetColorF(color[0], color[1], color[2]);
    painter.DrawLine(static_cast<float>(at), static_cast<float>(bottom), static_cast<float>(at),
                     static_cast<float>(top));
    // The name stands beside its line, to the left where there is no room on the right.
    const double name_width = 96 * scale, end = x(1e9);
    draw_text(painter, at + name_width > end ? at - name_width : at + 6 * scale, top - (14 + 24 * row) * scale,
              std::string(name) + ": " + std::to_string(work), text_size, color, false);
  }
};
vtkStandardNewMacro(DrawnBars)

    /// Of all bars but those of rays without any work, whose height says little.
    double highest_share(const HistogramSheet& sheet) {
  double highest = 1;
  for (const HistogramPanel& panel : sheet.panels) {
    for (const HistogramBin& bin : panel.bins) {
      if (bin.low > 0) highest = std::max(highest, percent(bin.rays, panel.statistics.rays));
    }
  }
  return 1.3 * highest;  // room for the marks' names
}

void set_axis(vtkChartXY& chart, int which, const std::string& title, double low, double high, double scale) {
  vtkAxis& axis = *chart.GetAxis(which);
  axis.SetTitle(title);
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetUnscaledRange(low, high);
  for (vtkTextProperty* text : {axis.GetTitleProperties(), axis.GetLabelProperties()}) {
    text->SetFontFamilyToArial();
    text->SetFontSize(std::max(1, static_cast<int>(std::lround(text_size * scale))));
    text->SetBold(false);
    text->SetColor(ink[0], ink[1], ink[2]);
  }
  axis.GetPen()->SetColorF(faint_ink[0], faint_ink[1], faint_ink[2]);
  axis.GetPen()->SetWidth(static_cast<float>(scale));
  axis.GetGridPen()->SetColorF(band[0], band[1], band[2]);
  axis.GetGridPen()->SetWidth(static_cast<float>(scale));
}

class Ticks {
 public:
  void add(double place, const std::string& label) {
    places_->InsertNextValue(place);
    labels_->InsertNextValue(label);
  }
  void put_on(vtkAxis& axis) const { axis.SetCustomTickPositions(places_, labels_); }

 private:
  New<vtkDoubleArray> places_ = New<vtkDoubleArray>::New();
  New<vtkStringArray> labels_ = New<vtkStringArray>::New();
};

void set_work_ticks(vtkAxis& axis, double highest) {
  Ticks ticks;
  ticks.add(0.5 * (idle_left + idle_right), "0");
  for (double decade = 1; decade <= highest; decade *= 10) {
    for (const int step : {1, 3}) {
      const double work = decade * step;
      if (work <= highest) ticks.add(HistogramSheet::position_of(work), std::to_string(std::lround(work)));
    }
  }
  ticks.put_on(axis);
}

/// At most seven, at round numbers.
void set_percent_ticks(vtkAxis& axis, double highest) {
  int step = 1;
  for (const int larger : {2, 5, 10, 20}) {
    if (highest / step > 6) step = larger;
  }
  Ticks ticks;
  for (int at = 0; at <= highest; at += step) ticks.add(at, std::to_string(at));
  ticks.put_on(axis);
}

New<vtkChartXY> chart_of(const HistogramSheet& sheet, const HistogramPanel& panel, double highest_y, double height,
                         double scale) {
  auto chart = New<vtkChartXY>::New();
  const PanelFrame& f = panel.frame;
  chart->SetAutoSize(false);
  chart->SetSize(vtkRectf(static_cast<float>(f.x * scale), static_cast<float>((height - f.y - f.height) * scale),
                          static_cast<float>(f.width * scale), static_cast<float>(f.height * scale)));
  const double highest = double(panel.bins.back().high) + 1;
  set_axis(*chart, vtkAxis::BOTTOM, sheet.unit + " per ray", idle_left - 0.15, HistogramSheet::position_of(highest),
           scale);
  set_axis(*chart, vtkAxis::LEFT, "rays / %", 0, highest_y, scale);
  set_work_ticks(*chart->GetAxis(vtkAxis::BOTTOM), highest);
  set_percent_ticks(*chart->GetAxis(vtkAxis::LEFT), highest_y);
  // A chart without a plot draws no axes.
  auto table = New<vtkTable>::New();
  for (const char* name : {"x", "y"}) {
    auto column = New<vtkDoubleArray>::New();
    column->SetName(name);
    column->InsertNextValue(0), column->InsertNextValue(0);
    table->AddColumn(column);
  }
  vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
  plot->SetInputData(table, 0, 1);
  plot->GetPen()->SetLineType(vtkPen::NO_PEN);
  return chart;
}

vtkSmartPointer<vtkRenderer> renderer_of(const HistogramSheet& sheet, const PartPlace& place, bool has_titles) {
  auto actor = New<vtkContextActor>::New();
  auto bars = New<DrawnBars>::New();
  bars->scale = place.scale, bars->height = place.height;
  if (has_titles) bars->title = sheet.title;
  const double highest = highest_share(sheet);
  for (const HistogramPanel& panel : sheet.panels) {
    bars->charts.push_back({panel, chart_of(sheet, panel, highest, place.height, place.scale)});
    actor->GetScene()->AddItem(bars->charts.back().chart);
  }
  actor->GetScene()->AddItem(bars);
  auto renderer = New<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  renderer->InteractiveOff();
  actor->GetScene()->SetRenderer(renderer);
  renderer->AddActor(actor);
  return renderer;
}

}  // namespace

double HistogramSheet::position_of(double work) { return work < 1 ? idle_left : std::log2(work); }

vtkSmartPointer<vtkRenderer> HistogramSheet::renderer(const PartPlace& place) const {
  return renderer_of(*this, place, false);
}

void HistogramSheet::write_svg(const std::filesystem::path& path, int width, int height, double unit_pixels) const {
  const auto renderer = renderer_of(*this, {unit_pixels, width / unit_pixels, height / unit_pixels}, true);
  viz::write_svg(path, *renderer, width, height);
}

}  // namespace sightline::viz
