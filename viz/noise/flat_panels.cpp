#include "viz/noise/flat_panels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/geometric.hpp>

namespace sightline::viz {
namespace {

using Point = Canvas::Point;
using Align = Canvas::Align;

std::string text_of(const char* format, double a) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, a);
  return text.data();
}

/// Square pictures have y up.
struct Plot {
  PanelFrame frame;
  double x_min, y_min, extent;

  double unit() const { return frame.width / extent; }
  Point at(const glm::dvec2& p) const {
    return {frame.x + (p.x - x_min) * unit(), frame.y + frame.height - (p.y - y_min) * unit()};
  }
};

void put_image(Canvas& canvas, const PanelFrame& frame, double unit, const std::function<Rgb(int, int, int)>& color) {
  ColorGrid grid;
  grid.width = grid.height = static_cast<int>(std::lround(frame.width * unit));
  for (int y = grid.height - 1; y >= 0; --y) {
    for (int x = 0; x < grid.width; ++x) {
      for (const double share : color(x, y, grid.width)) {
        grid.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0))));
      }
    }
  }
  canvas.image({frame.x, frame.y}, grid, 1 / unit);
}

/// Of a field, paler where there is more to come on top. The size of its largest value.
double put_slice(Canvas& canvas, const Plot& plot, const NoiseLook& look, double strength) {
  const int size = static_cast<int>(std::lround(plot.frame.width * look.unit));
  const FieldSlice slice = slice_of(look.field, size, plot.x_min, plot.y_min, plot.extent, look.slice);
  const double largest = largest_size(slice.values);
  put_image(canvas, plot.frame, look.unit, [&](int x, int y, int) {
    Rgb color = diverging(slice.at(x, y) / largest);
    for (double& component : color) component = 1 - strength * (1 - component);
    return color;
  });
  return largest;
}

void outline(Canvas& canvas, const PanelFrame& f) {
  const Point a{f.x, f.y}, b{f.x + f.width, f.y}, c{f.x + f.width, f.y + f.height}, d{f.x, f.y + f.height};
  canvas.line(a, b, 1, faint_ink), canvas.line(b, c, 1, faint_ink);
  canvas.line(c, d, 1, faint_ink), canvas.line(d, a, 1, faint_ink);
}

void arrow(Canvas& canvas, Point from, Point to, double width, const Rgb& color, double opacity = 1) {
  const double angle = std::atan2(to.y - from.y, to.x - from.x), head = 5 * width;
  if (std::hypot(to.x - from.x, to.y - from.y) < 2) return;
  canvas.line(from, {to.x - 0.7 * head * std::cos(angle), to.y - 0.7 * head * std::sin(angle)}, width, color, opacity);
  canvas.arrow_head(to, angle, head, color);
}

/// With a white casing, so that it reads on anything.
void label(Canvas& canvas, Point at, const std::string& text, const Canvas::TextStyle& style) {
  const double width = canvas.text_width(text, style) + 8, height = style.size + 5;
  const double left = style.align == Align::left    ? at.x - 4
                      : style.align == Align::right ? at.x - width + 4
                                                    : at.x - width / 2;
  canvas.rectangle({left, at.y - height / 2}, width, height, {1, 1, 1}, 0.86);
  canvas.text(at, text, style);
}

Plot plot_of(const PanelFrame& frame, const NoiseLook& look) { return {square_of(frame), look.x, look.y, look.extent}; }

/// Colors and the values they stand for, below a picture.
void draw_scale(Canvas& canvas, const PanelFrame& picture, double largest) {
  const double top = picture.y + picture.height + 8;
  constexpr int steps = 64;
  for (int i = 0; i < steps; ++i) {
    canvas.rectangle({picture.x + picture.width * i / steps, top}, picture.width / steps + 0.5, 10,
                     diverging(2 * (i + 0.5) / steps - 1));
  }
  const double y = top + 21;
  canvas.text({picture.x, y}, text_of("%.2f", -largest), {12.5, soft_ink, Align::left});
  canvas.text({picture.x + picture.width / 2, y}, "0", {12.5, soft_ink, Align::center});
  canvas.text({picture.x + picture.width, y}, text_of("%.2f", largest), {12.5, soft_ink, Align::right});
}

PanelFrame above_scale(const PanelFrame& frame) { return {frame.x, frame.y, frame.width, frame.height - 30}; }

}  // namespace

void draw_slice(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look) {
  const PanelFrame frame =
      framed(canvas, panel, "Slice",
             {text_of("values at z = %.3g,", look.slice) +
              text_of(" %.3g cells along each side", look.extent * look.field.options().frequency)});
  const Plot plot = plot_of(above_scale(frame), look);
  const double largest = put_slice(canvas, plot, look, 1);
  outline(canvas, plot.frame);
  draw_scale(canvas, plot.frame, largest);
}

void draw_gradients(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look) {
  const bool is_white = look.field.options().noise.kind == NoiseKind::white;
  const PanelFrame frame = framed(canvas, panel, "Gradient",
                                  {is_white ? "white noise has none" : "the analytic derivative: arrows point uphill"});
  const Plot plot = plot_of(above_scale(frame), look);
  put_slice(canvas, plot, look, 0.45);
  outline(canvas, plot.frame);
  if (is_white) return;
  constexpr int count = 15;
  std::vector<glm::dvec2> gradients;
  double steepest = 0;
  for (int i = 0; i < count * count; ++i) {
    const glm::dvec3 p(look.x + (i % count + 0.5) * look.extent / count,
                       look.y + (double(i / count) + 0.5) * look.extent / count, look.slice);
    gradients.emplace_back(look.field.sample(p).gradient);
    steepest = std::max(steepest, glm::length(gradients.back()));
  }
  const double reach = plot.frame.width / count * 1.15 / (steepest > 0 ? steepest : 1);
  for (int i = 0; i < count * count; ++i) {
    const glm::dvec2 p(look.x + (i % count + 0.5) * look.extent / count,
                       look.y + (double(i / count) + 0.5) * look.extent / count);
    const glm::dvec2 g = gradients[static_cast<std::size_t>(i)] * reach;
    const Point middle = plot.at(p);
    arrow(canvas, {middle.x - g.x / 2, middle.y + g.y / 2}, {middle.x + g.x / 2, middle.y - g.y / 2}, 1.5, ink);
  }
  canvas.text({plot.frame.x, plot.frame.y + plot.frame.height + 17},
              text_of("the longest arrow: a slope of %.3g in x and y", steepest), {12.5, soft_ink});
}

void draw_lattice(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look) {
  const Noise& noise = look.field.noise();
  if (noise.options().kind == NoiseKind::white) {
    framed(canvas, panel, "Lattice", {"white noise has none"});
    return;
  }
  const bool is_value = noise.options().kind == NoiseKind::value;
  const LatticeCell cell = lattice_cell(noise, look.point);
  const PanelFrame frame =
      framed(canvas, panel, "Lattice",
             {is_value ? "each corner gives its value" : "each corner gives its gradient times the way to P (2D)"});
  const PanelFrame square = square_of({frame.x, frame.y, frame.width, frame.height - 92});
  const glm::dvec2 base = cell.corners[0].position;
  const Plot plot{square, base.x - 0.55, base.y - 0.55, 2.1};

  put_image(canvas, square, look.unit, [&](int x, int y, int size) {
    const double share_x = (x + 0.5) / size, share_y = (y + 0.5) / size;
    const double value = noise(glm::dvec2(plot.x_min + share_x * plot.extent, plot.y_min + share_y * plot.extent));
    Rgb color = diverging(value / (is_value ? 1 : 0.75));
    for (double& component : color) component = 1 - 0.4 * (1 - component);
    return color;
  });
  for (int i = 0; i < 2; ++i) {
    canvas.line(plot.at({base.x + i, plot.y_min}), plot.at({base.x + i, plot.y_min + plot.extent}), 1.4, soft_ink, 0.8);
    canvas.line(plot.at({plot.x_min, base.y + i}), plot.at({plot.x_min + plot.extent, base.y + i}), 1.4, soft_ink, 0.8);
  }
  outline(canvas, square);
  const Point p = plot.at(look.point);
  for (const CellCorner& corner : cell.corners) {
    const Point at = plot.at(corner.position);
    canvas.dashes(at, p, 1.6, 6, 4, soft_ink);
    if (!is_value) arrow(canvas, at, plot.at(corner.position + 0.42 * corner.gradient), 2.6, accent);
    canvas.disc(at, 4.5, ink);
  }
  canvas.disc(p, 6.5, {1, 1, 1});
  canvas.disc(p, 4.5, ink);
  label(canvas, {p.x + 10, p.y - 13}, "P", {15, ink, Align::left, true});
  for (std::size_t i = 0; i < 4; ++i) {
    const CellCorner& corner = cell.corners[i];
    const Point at = plot.at(corner.position);
    const bool is_left = i % 2 == 0, is_lower = i / 2 == 0;
    label(canvas, {at.x + (is_left ? -9 : 9), at.y + (is_lower ? 17 : -17)},
          std::string(corner.name) + text_of(" = %.3f", corner.contribution),
          {13, ink,
           is_left && square.x < at.x - 80 ? Align::right
           : is_left                       ? Align::center
                                           : Align::left,
           true});
  }

  const double y = square.y + square.height + 16;
  const auto line = [&](int row, const std::string& text, bool is_bold = false) {
    canvas.text({frame.x, y + 18 * row}, text, {13, is_bold ? accent : ink, Align::left, is_bold});
  };
  const CellCorner& ll = cell.corners[0];
  line(0, text_of("P is %.2f", ll.way.x) + text_of(" and %.2f into its cell;", ll.way.y) +
              text_of(" eased %.3f", cell.s) + text_of(" and %.3f", cell.t));
  line(1, text_of("along x: LL to LR gives %.3f,", cell.lower) + text_of(" UL to UR gives %.3f", cell.upper));
  line(2, text_of("along y between these: noise(P) = %.4f", cell.value), true);
}

void draw_coherence(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look) {
  FieldOptions options = look.field.options();
  options.noise.kind = NoiseKind::white;
  options.fractal = FractalKind::none;
  options.warp = 0;
  const NoiseField white(options);
  const PanelFrame frame = framed(canvas, panel, "Coherence", {"next to a point lies any value, or nearly the same"});
  const PanelFrame square = square_of(above_scale(frame));
  const Plot plot = plot_of(square, look);
  const int size = static_cast<int>(std::lround(square.width * look.unit));
  const FieldSlice left = slice_of(white, size, plot.x_min, plot.y_min, plot.extent, look.slice);
  const FieldSlice right = slice_of(look.field, size, plot.x_min, plot.y_min, plot.extent, look.slice);
  const double largest = largest_size(right.values);
  put_image(canvas, square, look.unit, [&](int x, int y, int width) {
    return diverging(2 * x < width ? left.at(x, y) : right.at(x, y) / largest);
  });
  outline(canvas, square);
  const double middle = square.x + square.width / 2, below = square.y + square.height + 17;
  canvas.line({middle, square.y}, {middle, square.y + square.height}, 3, {1, 1, 1});
  const std::string name(noise_infos[static_cast<std::size_t>(look.field.options().noise.kind)].name);
  canvas.text({middle - square.width / 4, below}, "white", {13, ink, Align::center});
  canvas.text({middle + square.width / 4, below}, name, {13, ink, Align::center});
}

}  // namespace sightline::viz
