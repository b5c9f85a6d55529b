#include "viz/overlay.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

void add_text(vtkRenderer& renderer, const Overlay::Line& line, double x, double y, double scale) {
  auto text = New<vtkTextActor>::New();
  text->SetInput(line.text.c_str());
  text->SetPosition(x * scale, y * scale);
  vtkTextProperty* property = text->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(static_cast<int>(line.size * scale));
  property->SetBold(line.is_bold);
  property->SetColor(line.gray, line.gray, line.gray);
  property->SetVerticalJustificationToCentered();
  renderer.AddActor2D(text);
}

void add_bar(vtkRenderer& renderer, const Rgb& color, double x, double y, double width, double height, double scale) {
  auto points = New<vtkPoints>::New();
  for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    points->InsertNextPoint((x + right * width) * scale, (y + up * height) * scale, 0);
  }
  auto quad = New<vtkCellArray>::New();
  const vtkIdType corners[] = {0, 1, 2, 3};
  quad->InsertNextCell(4, corners);
  auto shape = New<vtkPolyData>::New();
  shape->SetPoints(points);
  shape->SetPolys(quad);
  auto mapper = New<vtkPolyDataMapper2D>::New();
  mapper->SetInputData(shape);
  auto bar = New<vtkActor2D>::New();
  bar->SetMapper(mapper);
  bar->GetProperty()->SetColor(color[0], color[1], color[2]);
  renderer.AddActor2D(bar);
}

}  // namespace

void Overlay::add_to(vtkRenderer& renderer) const {
  double y = height - 34;
  for (const Line& line : lines) {
    add_text(renderer, line, 28, y, scale);
    y -= line.size + 11;
  }

  // The lowest level on top, as trees are drawn; labels as close as they stay apart.
  const int levels = coloring.highest() - coloring.lowest() + 1;
  const double room = std::max(60, height - top - 90);
  const double step = std::min(26.0, room / levels);
  const int every = std::max(1, static_cast<int>(18 / step + 0.999));
  const double x = width - legend;
  y = height - top - 20;
  add_text(renderer, {coloring.title(), 15, true, 0.15}, x, y, scale);
  y -= 22;
  for (int level = coloring.lowest(); level <= coloring.highest(); ++level) {
    const std::size_t count = counts[static_cast<std::size_t>(level - coloring.lowest())];
    const double gap = step > 12 ? 2 : 0;
    add_bar(renderer, coloring.color(level), x, y - step + gap / 2, 24, step - gap, scale);
    if ((level - coloring.lowest()) % every == 0) {
      const double middle = y - step / 2;
      add_text(renderer, {coloring.label(level), 14, false, 0.15}, x + 32, middle, scale);
      if (every == 1) {
        const bool is_wide = coloring.label(level).size() > 3;
        add_text(renderer, {"x " + std::to_string(count), 12, false, 0.5}, x + (is_wide ? 104 : 62), middle, scale);
      }
    }
    y -= step;
  }
}

}  // namespace sightline::viz
