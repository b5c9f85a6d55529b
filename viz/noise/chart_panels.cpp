#include "viz/noise/chart_panels.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>

#include "viz/noise/spectrum.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

/// Distinct in gray and to the color-blind. Wong, "Points of view: Color blindness", 2011.
constexpr Rgb blue{0.00, 0.45, 0.70}, orange{0.84, 0.37, 0.00}, green{0.00, 0.62, 0.45}, gray{0.55, 0.58, 0.64};

/// A chart in a renderer of its own.
class Chart {
 public:
  Chart(const PartPlace& place, const PanelFrame& frame) : scale_(place.scale), renderer_(place.renderer(frame)) {
    chart_->SetShowLegend(true);
    chart_->GetLegend()->SetInline(false);
    chart_->GetLegend()->SetLabelSize(pixels(12.5));
    chart_->GetLegend()->GetPen()->SetOpacity(0);
    chart_->GetLegend()->GetBrush()->SetColorF(1, 1, 1, 0.8);
    chart_->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
    chart_->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
    auto actor = New<vtkContextActor>::New();
    actor->GetScene()->AddItem(chart_);
    actor->GetScene()->SetRenderer(renderer_);
    renderer_->AddActor(actor);
  }

  void axis(int which, const char* title, double low, double high, bool is_logarithmic = false) {
    vtkAxis& axis = *chart_->GetAxis(which);
    axis.SetTitle(title);
    axis.SetLogScale(is_logarithmic);
    axis.SetBehavior(vtkAxis::FIXED);
    axis.SetUnscaledRange(low, high);
    for (vtkTextProperty* text : {axis.GetTitleProperties(), axis.GetLabelProperties()}) {
      text->SetFontSize(pixels(12.5));
      text->SetBold(false);
      text->SetColor(soft_ink[0], soft_ink[1], soft_ink[2]);
    }
    axis.GetPen()->SetColorF(faint_ink[0], faint_ink[1], faint_ink[2]);
    axis.GetPen()->SetWidth(static_cast<float>(scale_));
    axis.GetGridPen()->SetColorF(band[0], band[1], band[2]);
    axis.GetGridPen()->SetWidth(static_cast<float>(scale_));
  }

  void curve(const std::string& name, std::span<const double> x, std::span<const double> y, const Rgb& color,
             double width, int pen = vtkPen::SOLID_LINE) {
    auto table = New<vtkTable>::New();
    const auto column = [&](const char* its_name, std::span<const double> numbers) {
      auto array = New<vtkDoubleArray>::New();
      array->SetName(its_name);
      for (const double number : numbers) array->InsertNextValue(number);
      table->AddColumn(array);
    };
    column("x", x);
    column(name.c_str(), y);
    vtkPlot* plot = chart_->AddPlot(vtkChart::LINE);
    plot->SetInputData(table, 0, 1);
    plot->GetPen()->SetColorF(color[0], color[1], color[2]);
    plot->GetPen()->SetLineType(pen);
    plot->SetWidth(static_cast<float>(width * scale_));
  }

  const New<vtkRenderer>& renderer() const { return renderer_; }

 private:
  int pixels(double units) const { return std::max(1, static_cast<int>(std::lround(units * scale_))); }

  double scale_;
  New<vtkRenderer> renderer_;
  New<vtkChartXY> chart_ = New<vtkChartXY>::New();
};

std::string percent(double share) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), share < 0.001 ? "%.3f %%" : "%.1f %%", 100 * share);
  return text.data();
}

}  // namespace

vtkSmartPointer<vtkRenderer> PartPlace::renderer(const PanelFrame& f) const {
  auto renderer = New<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  renderer->SetViewport(f.x / width, 1 - (f.y + f.height) / height, (f.x + f.width) / width, 1 - f.y / height);
  return renderer;
}

vtkSmartPointer<vtkRenderer> ease_chart(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                        const PartPlace& place) {
  if (look.field.options().noise.kind == NoiseKind::white) {
    framed(canvas, panel, "Ease", {"white noise has none"});
    return nullptr;
  }
  const Ease own = ease_of(look.field.noise());
  const Ease other = own == Ease::cubic ? Ease::quintic : Ease::cubic;
  const std::string_view own_name = ease_infos[static_cast<std::size_t>(own)].name;
  const std::string_view other_name = ease_infos[static_cast<std::size_t>(other)].name;
  const PanelFrame frame =
      framed(canvas, panel, "Ease",
             {std::string(own_name) + ", thin the " + std::string(other_name) + " one: curvature (over 10)",
              own == Ease::cubic ? "jumps at lattice points from -6 to 6" : "is 0 at lattice points"});
  Chart chart(place, frame);
  chart.axis(vtkAxis::BOTTOM, "t, from a lattice point to the next", 0, 1);
  chart.axis(vtkAxis::LEFT, "", -1, 2);
  std::vector<double> t, curves[2][3];
  for (int i = 0; i <= 200; ++i) {
    t.push_back(i / 200.0);
    for (const int which : {0, 1}) {
      const Ease ease = which == 0 ? own : other;
      curves[which][0].push_back(eased(ease, t.back()));
      curves[which][1].push_back(slope_of_eased(ease, t.back()));
      curves[which][2].push_back(curvature_of_eased(ease, t.back()) / 10);
    }
  }
  chart.curve("S(t)", t, curves[0][0], blue, 3);
  chart.curve("S'(t)", t, curves[0][1], orange, 3);
  chart.curve("S''(t)/10", t, curves[0][2], green, 3);
  chart.curve(std::string(other_name), t, curves[1][0], blue, 1);
  chart.curve("", t, curves[1][1], orange, 1);
  chart.curve("", t, curves[1][2], green, 1);
  return chart.renderer();
}

vtkSmartPointer<vtkRenderer> spectrum_chart(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                            const PartPlace& place) {
  const Spectrum spectrum = spectrum_of(look.field);
  FieldOptions white_options = look.field.options();
  white_options.noise.kind = NoiseKind::white;
  white_options.fractal = FractalKind::none;
  const Spectrum white = spectrum_of(NoiseField(white_options));
  const PanelFrame frame = framed(
      canvas, panel, "Power spectrum",
      {percent(spectrum.below_quarter) + " below 1/4 cycle per cell, " + percent(spectrum.above_two) + " above 2",
       "power along axes over along diagonals (2D): " + std::to_string(spectrum.axis_over_diagonal).substr(0, 4)});
  Chart chart(place, frame);
  chart.axis(vtkAxis::BOTTOM, "cycles per cell", 1.0 / 32, 4, true);
  chart.axis(vtkAxis::LEFT, "density of the variance", 1e-6, 10, true);
  const auto floored = [](std::vector<double> densities) {
    for (double& density : densities) density = std::max(density, 1e-7);
    return densities;
  };
  chart.curve("this noise", spectrum.frequencies, floored(spectrum.densities), blue, 3);
  chart.curve("white noise", white.frequencies, floored(white.densities), gray, 1.5);
  for (const double mark : {0.25, 2.0}) {
    chart.curve("", std::array{mark, mark}, std::array{1e-6, 10.0}, orange, 1, vtkPen::DASH_LINE);
  }
  return chart.renderer();
}

}  // namespace sightline::viz
