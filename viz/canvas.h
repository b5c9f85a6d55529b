#pragma once
/// Flat drawings on a VTK renderer: images, over them shapes in the order in which they are drawn, over these text.

#include <vtkRenderer.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "viz/color_ramp.h"

namespace sightline::viz {

/// Bytes of red, green and blue as screens take them, row by row from the top.
struct ColorGrid {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

/// Coordinates count from the top left corner, x to the right, y down, in units of `scale` pixels of the window.
class Canvas {
 public:
  struct Point {
    double x, y;
  };
  enum class Align { left, center, right };
  struct TextStyle {
    double size = 14;
    Rgb color{0.12, 0.14, 0.19};
    Align align = Align::left;
    bool is_bold = false;
  };

  /// `height` is the window's, in units.
  Canvas(double height, double scale) : height_(height), scale_(scale) {}

  /// A convex polygon, with a color at each corner.
  void polygon(std::span<const Point> corners, std::span<const Rgb> colors, double opacity = 1);
  void polygon(std::span<const Point> corners, const Rgb& color, double opacity = 1);
  void rectangle(Point top_left, double width, double height, const Rgb& color, double opacity = 1);
  void gradient(Point top_left, double width, double height, const Rgb& left, const Rgb& right);
  void line(Point from, Point to, double width, const Rgb& color, double opacity = 1);
  void dashes(Point from, Point to, double width, double dash, double gap, const Rgb& color, double opacity = 1);
  void disc(Point center, double radius, const Rgb& color, double opacity = 1);
  void ring(Point center, double radius, double width, const Rgb& color, double opacity = 1);
  /// A point of the arrow is at `tip`; `angle` 0 is to the right, pi/2 down.
  void arrow_head(Point tip, double angle, double length, const Rgb& color);
  /// Its middle line is at `at`'s y.
  void text(Point at, const std::string& text, const TextStyle& style);
  double text_width(const std::string& text, const TextStyle& style) const;
  /// As much of a text as is no wider, "..." at its end where that is not all.
  std::string shortened(const std::string& text, const TextStyle& style, double width) const;
  /// Each pixel of the image becomes `pixel_size` units wide, which are a whole number of the window's pixels.
  void image(Point top_left, const ColorGrid& image, double pixel_size);

  void add_to(vtkRenderer& renderer) const;

 private:
  struct Shape {
    std::vector<Point> corners;
    std::vector<std::uint8_t> colors;  ///< Red, green, blue, opacity of each corner.
  };
  struct Text {
    Point at;
    std::string text;
    TextStyle style;
  };
  struct Picture {
    Point top_left;
    ColorGrid image;
    int repeat;
  };

  double height_, scale_;
  std::vector<Shape> shapes_;
  std::vector<Text> texts_;
  std::vector<Picture> pictures_;
};

}  // namespace sightline::viz
