#include "viz/canvas.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkImageMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr int window_dpi = 72;  // VTK's, whatever the screen
constexpr int image_layer = 0, shape_layer = 1, text_layer = 2;

std::uint8_t byte_of(double share) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

void apply(vtkTextProperty& property, const Canvas::TextStyle& style, double scale) {
  property.SetFontFamilyToArial();
  property.SetFontSize(std::max(1, static_cast<int>(std::lround(style.size * scale))));
  property.SetBold(style.is_bold);
  property.SetColor(style.color[0], style.color[1], style.color[2]);
  property.SetVerticalJustificationToCentered();
}

}  // namespace

void Canvas::polygon(std::span<const Point> corners, std::span<const Rgb> colors, double opacity) {
  Shape shape{{corners.begin(), corners.end()}, {}};
  for (const Rgb& color : colors) {
    for (const double component : color) shape.colors.push_back(byte_of(component));
    shape.colors.push_back(byte_of(opacity));
  }
  shapes_.push_back(std::move(shape));
}

void Canvas::polygon(std::span<const Point> corners, const Rgb& color, double opacity) {
  polygon(corners, std::vector<Rgb>(corners.size(), color), opacity);
}

void Canvas::rectangle(Point at, double width, double height, const Rgb& color, double opacity) {
  const Point corners[] = {at, {at.x + width, at.y}, {at.x + width, at.y + height}, {at.x, at.y + height}};
  polygon(corners, color, opacity);
}

void Canvas::gradient(Point at, double width, double height, const Rgb& left, const Rgb& right) {
  const Point corners[] = {at, {at.x + width, at.y}, {at.x + width, at.y + height}, {at.x, at.y + height}};
  const Rgb colors[] = {left, right, right, left};
  polygon(corners, colors);
}

void Canvas::line(Point from, Point to, double width, const Rgb& color, double opacity) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (!(length > 0)) return;
  const double x = -dy / length * width / 2, y = dx / length * width / 2;
  const Point corners[] = {
      {from.x + x, from.y + y}, {to.x + x, to.y + y}, {to.x - x, to.y - y}, {from.x - x, from.y - y}};
  polygon(corners, color, opacity);
}

void Canvas::dashes(Point from, Point to, double width, double dash, double gap, const Rgb& color, double opacity) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const auto at = [&](double along) -> Point {
    return {from.x + (to.x - from.x) * along / length, from.y + (to.y - from.y) * along / length};
  };
  for (double begin = 0; begin < length; begin += dash + gap) {
    line(at(begin), at(std::min(begin + dash, length)), width, color, opacity);
  }
}

void Canvas::disc(Point center, double radius, const Rgb& color, double opacity) {
  std::vector<Point> corners;
  constexpr int count = 32;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    corners.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
  }
  polygon(corners, color, opacity);
}

void Canvas::ring(Point center, double radius, double width, const Rgb& color, double opacity) {
  constexpr int count = 40;
  const auto at = [&](int i, double r) -> Point {
    const double angle = 2 * std::numbers::pi * i / count;
    return {center.x + r * std::cos(angle), center.y + r * std::sin(angle)};
  };
  for (int i = 0; i < count; ++i) {
    const Point corners[] = {at(i, radius - width / 2), at(i, radius + width / 2), at(i + 1, radius + width / 2),
                             at(i + 1, radius - width / 2)};
    polygon(corners, color, opacity);
  }
}

void Canvas::arrow_head(Point tip, double angle, double length, const Rgb& color) {
  const auto back = [&](double turn) -> Point {
    return {tip.x - length * std::cos(angle + turn), tip.y - length * std::sin(angle + turn)};
  };
  const Point corners[] = {tip, back(0.42), back(-0.42)};
  polygon(corners, color);
}

void Canvas::text(Point at, const std::string& text, const TextStyle& style) { texts_.push_back({at, text, style}); }

double Canvas::text_width(const std::string& text, const TextStyle& style) const {
  auto property = New<vtkTextProperty>::New();
  apply(*property, style, scale_);
  int box[4] = {};
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, text, box, window_dpi);
  return (box[1] - box[0] + 1) / scale_;
}

std::string Canvas::shortened(const std::string& text, const TextStyle& style, double width) const {
  if (text_width(text, style) <= width) return text;
  std::size_t length = text.size();
  while (length > 1 && text_width(text.substr(0, length) + "...", style) > width) --length;
  while (length > 1 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;  // whole letters of UTF-8
  return text.substr(0, length) + "...";
}

void Canvas::image(Point top_left, const ColorGrid& image, double pixel_size) {
  pictures_.push_back({top_left, image, std::max(1, static_cast<int>(std::lround(pixel_size * scale_)))});
}

void Canvas::add_to(vtkRenderer& renderer) const {
  for (const Picture& picture : pictures_) {
    const int repeat = picture.repeat, width = picture.image.width * repeat, height = picture.image.height * repeat;
    auto data = New<vtkImageData>::New();
    data->SetDimensions(width, height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* to = static_cast<std::uint8_t*>(data->GetScalarPointer());
    for (int y = 0; y < height; ++y) {
      const int row = picture.image.height - 1 - y / repeat;  // VTK counts rows from below
      for (int x = 0; x < width; ++x, to += 3) {
        std::copy_n(&picture.image.bytes[(static_cast<std::size_t>(row) * picture.image.width + x / repeat) * 3], 3,
                    to);
      }
    }
    auto mapper = New<vtkImageMapper>::New();
    mapper->SetInputData(data);
    mapper->SetColorWindow(255);
    mapper->SetColorLevel(127.5);
    auto actor = New<vtkActor2D>::New();
    actor->SetMapper(mapper);
    actor->SetPosition(std::lround(picture.top_left.x * scale_),
                       std::lround((height_ - picture.top_left.y) * scale_) - height);
    actor->SetLayerNumber(image_layer);
    renderer.AddActor2D(actor);
  }

  auto points = New<vtkPoints>::New();
  auto colors = New<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(4);
  auto polygons = New<vtkCellArray>::New();
  for (const Shape& shape : shapes_) {
    std::vector<vtkIdType> corners;
    for (std::size_t i = 0; i < shape.corners.size(); ++i) {
      const Point& p = shape.corners[i];
      corners.push_back(points->InsertNextPoint(p.x * scale_, (height_ - p.y) * scale_, 0));
      colors->InsertNextTypedTuple(&shape.colors[4 * i]);
    }
    polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  auto shapes = New<vtkPolyData>::New();
  shapes->SetPoints(points);
  shapes->SetPolys(polygons);
  shapes->GetPointData()->SetScalars(colors);
  auto mapper = New<vtkPolyDataMapper2D>::New();
  mapper->SetInputData(shapes);
  mapper->SetScalarModeToUsePointData();
  auto actor = New<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->SetLayerNumber(shape_layer);
  renderer.AddActor2D(actor);

  for (const Text& text : texts_) {
    auto line = New<vtkTextActor>::New();
    line->SetInput(text.text.c_str());
    line->SetPosition(text.at.x * scale_, (height_ - text.at.y) * scale_);
    apply(*line->GetTextProperty(), text.style, scale_);
    if (text.style.align == Align::center) line->GetTextProperty()->SetJustificationToCentered();
    if (text.style.align == Align::right) line->GetTextProperty()->SetJustificationToRight();
    line->SetLayerNumber(text_layer);
    renderer.AddActor2D(line);
  }
}

}  // namespace sightline::viz
