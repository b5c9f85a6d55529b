#pragma once

#include <string>

#include "viz/compare/walk_space.h"

namespace sightline::viz {

/// From left to right.
class CompareLegend {
 public:
  static constexpr double text_size = 18;

  CompareLegend(Canvas& canvas, double x, double y) : canvas_(canvas), x_(x), y_(y) {}

  double x() const { return x_; }
  void text(const std::string& text, bool is_bold = false) {
    const Canvas::TextStyle style{text_size, ink, Canvas::Align::left, is_bold};
    canvas_.text({x_, y_}, text, style);
    x_ += canvas_.text_width(text, style) + 22;
  }
  void line(const Rgb& color, double width, double dash, const std::string& meaning) {
    if (dash > 0) {
      canvas_.dashes({x_, y_}, {x_ + 40, y_}, width, dash, dash, color);
    } else {
      canvas_.line({x_, y_}, {x_ + 40, y_}, width, color);
    }
    x_ += 48;
    text(meaning);
  }
  void box(const Rgb& color, const std::string& meaning) {
    canvas_.rectangle({x_, y_ - 9}, 18, 18, color);
    x_ += 26;
    text(meaning);
  }
  void turns(std::size_t most) {
    text("cells in the order of opening: 1", true);
    x_ -= 12;
    constexpr int stripes = 120;
    constexpr double length = 240;
    for (int i = 0; i < stripes; ++i) {
      const Rgb color = opening_color(static_cast<std::size_t>(i), stripes);
      canvas_.rectangle({x_ + length * i / stripes, y_ - 9}, length / stripes + 0.5, 18, color);
    }
    x_ += length + 10;
    text(std::to_string(most), true);
  }

 private:
  Canvas& canvas_;
  double x_, y_;
};

}  // namespace sightline::viz
