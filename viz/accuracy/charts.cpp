#include "viz/accuracy/charts.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkPoints2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSVGExporter.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "viz/paper.h"
#include "viz/virtual_screen.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

/// Distinct in gray and to the color-blind. Wong, "Points of view: Color blindness", 2011.
constexpr Rgb blue{0.00, 0.45, 0.70}, orange{0.84, 0.37, 0.00}, green{0.00, 0.62, 0.45};
constexpr int chart_width = 960, chart_height = 600;

/// Marks with their names beside them.
class NamedPoints : public vtkPlotPoints {
 public:
  static NamedPoints* New();
  vtkTypeMacro(NamedPoints, vtkPlotPoints)

      std::vector<std::string> names;
  int font_size = 12;

  bool Paint(vtkContext2D* painter) override {
    if (!vtkPlotPoints::Paint(painter)) return false;
    if (!Points) return true;
    painter->GetTextProp()->SetFontSize(font_size);
    painter->GetTextProp()->SetColor(ink[0], ink[1], ink[2]);
    painter->GetTextProp()->SetJustificationToLeft();
    painter->GetTextProp()->SetVerticalJustificationToBottom();
    for (vtkIdType i = 0; i < Points->GetNumberOfPoints() && i < static_cast<vtkIdType>(names.size()); ++i) {
      double at[2];
      Points->GetPoint(i, at);
      painter->DrawString(static_cast<float>(at[0]), static_cast<float>(at[1]),
                          "  " + names[static_cast<std::size_t>(i)]);
    }
    return true;
  }
};
vtkStandardNewMacro(NamedPoints)

    struct Mark {
  double error, nanoseconds;
  std::string name;
};

New<vtkTable> table_of(const std::vector<Mark>& marks, const std::string& name) {
  auto table = New<vtkTable>::New();
  const auto column = [&](const std::string& its_name, double Mark::*member) {
    auto array = New<vtkDoubleArray>::New();
    array->SetName(its_name.c_str());
    for (const Mark& mark : marks) array->InsertNextValue(mark.*member);
    table->AddColumn(array);
  };
  column("error", &Mark::error);
  column(name, &Mark::nanoseconds);
  return table;
}

/// Marks and line over a chart, in pixels: VTK 9.1 writes what is scaled to an SVG file in the wrong place.
class DrawnMarks : public vtkContextItem {
 public:
  static DrawnMarks* New();
  vtkTypeMacro(DrawnMarks, vtkContextItem)

      struct Group {
    std::vector<Mark> marks;
    Rgb color;
    int style;
  };
  vtkChartXY* chart = nullptr;
  std::vector<Mark> line;
  std::vector<Group> groups;

  bool Paint(vtkContext2D* painter) override {
    std::vector<float> points;
    for (const Mark& mark : line) {
      points.push_back(pixel(vtkAxis::BOTTOM, mark.error));
      points.push_back(pixel(vtkAxis::LEFT, mark.nanoseconds));
    }
    painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    painter->GetPen()->SetWidth(1.5f);
    painter->GetPen()->SetColorF(blue[0], blue[1], blue[2]);
    if (line.size() > 1) painter->DrawPoly(points.data(), static_cast<int>(line.size()));
    painter->GetTextProp()->SetFontSize(12);
    painter->GetTextProp()->SetColor(ink[0], ink[1], ink[2]);
    painter->GetTextProp()->SetJustificationToLeft();
    painter->GetTextProp()->SetVerticalJustificationToBottom();
    for (const Group& group : groups) {
      painter->GetPen()->SetColorF(group.color[0], group.color[1], group.color[2]);
      painter->GetBrush()->SetColorF(group.color[0], group.color[1], group.color[2]);
      for (const Mark& mark : group.marks) draw(*painter, group.style, mark);
    }
    return true;
  }

 private:
  float pixel(int which, double value) const {
    vtkAxis& axis = *chart->GetAxis(which);
    const int along = which == vtkAxis::BOTTOM ? 0 : 1;
    const double low = std::log(axis.GetUnscaledMinimum()), high = std::log(axis.GetUnscaledMaximum());
    const double from = axis.GetPoint1()[along], to = axis.GetPoint2()[along];
    return static_cast<float>(from + (std::log(value) - low) / (high - low) * (to - from));
  }
  void draw(vtkContext2D& painter, int style, const Mark& mark) const {
    const float x = pixel(vtkAxis::BOTTOM, mark.error), y = pixel(vtkAxis::LEFT, mark.nanoseconds), r = 4.5f;
    if (style == vtkPlotPoints::CIRCLE) {
      painter.DrawEllipse(x, y, r, r);
    } else if (style == vtkPlotPoints::SQUARE) {
      painter.DrawRect(x - r, y - r, 2 * r, 2 * r);
    } else {
      painter.DrawQuad(x - r, y, x, y + r, x + r, y, x, y - r);
    }
    painter.DrawString(x + 8, y + 2, mark.name);
  }
};
vtkStandardNewMacro(DrawnMarks)

    class FrontChart {
 public:
  FrontChart(const bench::AxisReport& axis, const bench::PanelReport& panel, int scale)
      : panel_(panel), scale_(scale), least_(least_error(panel)) {
    chart_->SetTitle(axis.name + ": " + panel.name);
    chart_->GetTitleProperties()->SetFontSize(18 * scale);
    chart_->GetTitleProperties()->SetColor(ink[0], ink[1], ink[2]);
    chart_->SetShowLegend(true);
    chart_->GetLegend()->SetLabelSize(13 * scale);
    chart_->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
    chart_->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
    add_line();
    add_marks(bench::Place::on_front, "on the front", blue, vtkPlotPoints::CIRCLE);
    add_marks(bench::Place::not_resolved, "not resolved", green, vtkPlotPoints::DIAMOND);
    add_marks(bench::Place::dominated, "dominated", orange, vtkPlotPoints::SQUARE);
    set_axis(vtkAxis::BOTTOM,
             bench::kind_name(panel) +
                 (panel.kind == bench::ErrorKind::wrong ? " per million" : ' ' + panel.error_unit) +
                 (has_zero() ? " (0 at the left end)" : ""),
             true);
    set_axis(vtkAxis::LEFT, "ns per " + panel.unit, false);
  }

  /// With what SVG files need besides.
  New<vtkRenderer> renderer(bool is_for_svg = false) const {
    auto renderer = New<vtkRenderer>::New();
    renderer->SetBackground(1, 1, 1);
    auto actor = New<vtkContextActor>::New();
    actor->GetScene()->AddItem(chart_);
    drawn_->chart = chart_;
    if (is_for_svg) actor->GetScene()->AddItem(drawn_);
    actor->GetScene()->SetRenderer(renderer);
    renderer->AddActor(actor);
    return renderer;
  }

 private:
  /// Where 0 is drawn on a scale of logarithms: a decade below all else.
  static double least_error(const bench::PanelReport& panel) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& choice : panel.choices) {
      const double error = bench::error_of(choice.errors, panel.kind);
      if (error > 0) least = std::min(least, error);
    }
    return std::isfinite(least) ? least / 10 : 1;
  }
  bool has_zero() const {
    return std::ranges::any_of(panel_.choices,
                               [&](const auto& c) { return bench::error_of(c.errors, panel_.kind) == 0; });
  }

  Mark mark_of(const bench::ChoiceReport& choice) const {
    const double error = bench::error_of(choice.errors, panel_.kind);
    return {error == 0 ? least_ : error, 1e9 * choice.seconds.median, choice.name};
  }

  void add_line() {
    std::vector<Mark> marks;
    for (const auto& choice : panel_.choices) {
      const bench::Place place = choice.standing.place;
      if (place == bench::Place::on_front || place == bench::Place::not_resolved) marks.push_back(mark_of(choice));
    }
    std::ranges::sort(marks, [](const Mark& a, const Mark& b) {
      return a.error != b.error ? a.error < b.error : a.nanoseconds > b.nanoseconds;
    });
    drawn_->line = marks;
    if (marks.size() < 2) return;  // VTK draws no line of one point, and says so
    vtkPlot* plot = chart_->AddPlot(vtkChart::LINE);
    plot->SetInputData(table_of(marks, "front"), 0, 1);
    plot->GetPen()->SetColorF(blue[0], blue[1], blue[2]);
    plot->SetWidth(static_cast<float>(1.5 * scale_));
  }

  void add_marks(bench::Place place, const std::string& name, const Rgb& color, int style) {
    std::vector<Mark> marks;
    for (const auto& choice : panel_.choices) {
      if (choice.standing.place == place) marks.push_back(mark_of(choice));
    }
    if (marks.empty()) return;
    auto plot = New<NamedPoints>::New();
    for (const Mark& mark : marks) plot->names.push_back(mark.name);
    plot->font_size = 12 * scale_;
    plot->SetInputData(table_of(marks, name), 0, 1);
    plot->SetMarkerStyle(style);
    plot->SetMarkerSize(static_cast<float>(9 * scale_));
    plot->GetPen()->SetColorF(color[0], color[1], color[2]);
    chart_->AddPlot(plot);
    drawn_->groups.push_back({std::move(marks), color, style});
  }

  void set_axis(int which, const std::string& title, bool is_error) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const auto& choice : panel_.choices) {
      const Mark mark = mark_of(choice);
      const double value = is_error ? mark.error : mark.nanoseconds;
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    }
    const double pad = std::pow(high / low, 0.06) * 1.1;
    vtkAxis& axis = *chart_->GetAxis(which);
    axis.SetTitle(title);
    axis.SetLogScale(true);
    axis.SetBehavior(vtkAxis::FIXED);
    axis.SetUnscaledRange(low / pad, high * (is_error ? std::pow(high / low, 0.2) : 1) * pad);  // room for names
    for (vtkTextProperty* text : {axis.GetTitleProperties(), axis.GetLabelProperties()}) {
      text->SetFontSize(13 * scale_);
      text->SetBold(false);
      text->SetColor(soft_ink[0], soft_ink[1], soft_ink[2]);
    }
    axis.GetGridPen()->SetColorF(band[0], band[1], band[2]);
  }

  const bench::PanelReport& panel_;
  int scale_;
  double least_;
  New<vtkChartXY> chart_ = New<vtkChartXY>::New();
  New<DrawnMarks> drawn_ = New<DrawnMarks>::New();
};

void write_svg(const bench::AxisReport& axis, const bench::PanelReport& panel, const std::filesystem::path& path) {
  auto window = New<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(chart_width, chart_height);
  const FrontChart chart(axis, panel, 1);
  window->AddRenderer(chart.renderer(true));
  window->Render();
  auto exporter = New<vtkSVGExporter>::New();
  exporter->SetRenderWindow(window);
  exporter->SetFileName(path.c_str());
  exporter->Write();
  if (!std::filesystem::exists(path)) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace

void draw_accuracy_charts(const bench::AccuracyReport& report, const std::string& folder) {
  std::filesystem::create_directories(folder);
  const PictureScreen screen;
  for (const bench::AxisReport& axis : report.axes) {
    for (std::size_t i = 0; i < axis.panels.size(); ++i) {
      const bench::PanelReport& panel = axis.panels[i];
      const std::filesystem::path stem = std::filesystem::path(folder) / (axis.name + '-' + std::to_string(i + 1));
      write_picture(stem.string() + ".png", chart_width, chart_height, [&](vtkRenderWindow& window, int scale) {
        const FrontChart chart(axis, panel, scale);
        window.AddRenderer(chart.renderer());
      });
      write_svg(axis, panel, stem.string() + ".svg");
    }
  }
}

}  // namespace sightline::viz
