#include "viz/drawing/drawing_picture.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "viz/drawing/space_drawing.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

constexpr double margin = 28, head = 70, foot = 64, gap = 24;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

/// The values of an axis, from one end of a frame to the other.
struct Scale {
  double lo = 0, hi = 1;
  bool is_log = false;

  double share(double x) const { return is_log ? std::log(x / lo) / std::log(hi / lo) : (x - lo) / (hi - lo); }
  double value(double share) const { return is_log ? lo * std::pow(hi / lo, share) : lo + share * (hi - lo); }
  bool has(double x) const { return std::isfinite(x) && (!is_log || x > 0); }
};

template <class Values>
Scale scale_of(const Values& values, bool is_log) {
  Scale scale{0, 0, is_log};
  bool is_first = true;
  for (const double x : values) {
    if (!scale.has(x)) continue;
    scale.lo = is_first ? x : std::min(scale.lo, x);
    scale.hi = is_first ? x : std::max(scale.hi, x);
    is_first = false;
  }
  if (!(scale.hi > scale.lo)) {
    scale.hi = is_log ? 2 * std::max(scale.lo, 1e-300) : scale.lo + 1;
    scale.lo = is_log ? std::max(scale.lo, 1e-300) / 2 : scale.lo - 1;
  }
  return scale;
}

/// Within a frame: room for numbers at the left and below.
PanelFrame plot_frame(const PanelFrame& frame) {
  return {frame.x + 84, frame.y + 12, frame.width - 100, frame.height - 76};
}

void draw_axes(Canvas& canvas, const PanelFrame& plot, const Scale& x, const Scale& y, const ChartPanel& chart) {
  for (int i = 0; i <= 5; ++i) {
    const double share = i / 5.0, at_x = plot.x + share * plot.width, at_y = plot.y + (1 - share) * plot.height;
    canvas.line({at_x, plot.y}, {at_x, plot.y + plot.height}, 1, band);
    canvas.line({plot.x, at_y}, {plot.x + plot.width, at_y}, 1, band);
    canvas.text({at_x, plot.y + plot.height + 18}, number(x.value(share)), {17, soft_ink, Canvas::Align::center});
    canvas.text({plot.x - 10, at_y}, number(y.value(share)), {17, soft_ink, Canvas::Align::right});
  }
  canvas.text({plot.x + plot.width / 2, plot.y + plot.height + 46}, chart.x_label, {19, ink, Canvas::Align::center});
  canvas.text({plot.x, plot.y - 4}, chart.y_label, {19, ink});
}

bool draw_chart(Canvas& canvas, const PanelFrame& frame, const ChartPanel& chart) {
  std::vector<double> xs, ys;
  for (const auto& curve : chart.curves) {
    for (const auto& [x, y] : curve.points) xs.push_back(x), ys.push_back(y);
  }
  const Scale x = scale_of(xs, chart.is_log_x), y = scale_of(ys, chart.is_log_y);
  const PanelFrame plot = plot_frame(frame);
  draw_axes(canvas, plot, x, y, chart);
  bool is_whole = true;
  double legend = plot.y + 16;
  for (const auto& curve : chart.curves) {
    const Rgb color = color_of(curve.role);
    const Canvas::Point* before = nullptr;
    std::vector<Canvas::Point> places;
    places.reserve(curve.points.size());
    for (const auto& [px, py] : curve.points) {
      if (!x.has(px) || !y.has(py)) {
        is_whole = false;
        before = nullptr;
        continue;
      }
      places.push_back({plot.x + x.share(px) * plot.width, plot.y + (1 - y.share(py)) * plot.height});
      if (curve.is_dots) canvas.disc(places.back(), 5, color);
      if (!curve.is_dots && before != nullptr)
        canvas.line(*before, places.back(), curve.role == Role::right ? 2 : 3, color);
      before = &places.back();
    }
    canvas.line({plot.x + plot.width - 190, legend}, {plot.x + plot.width - 160, legend}, 4, color);
    canvas.text({plot.x + plot.width - 152, legend}, curve.name, {18, color});
    legend += 26;
  }
  return is_whole;
}

bool draw_ladder(Canvas& canvas, const PanelFrame& frame, const LadderPanel& ladder) {
  std::vector<double> ends;
  for (const auto& row : ladder.rows) {
    for (const auto& [lo, hi] : row.intervals) ends.push_back(lo), ends.push_back(hi);
  }
  Scale t = scale_of(ends, false);
  const double pad = 0.06 * (t.hi - t.lo);
  t.lo -= pad, t.hi += pad;
  const double names = 190, left = frame.x + names, width = frame.width - names - 16;
  const double step = std::min(64.0, (frame.height - 60) / std::max<double>(1, double(ladder.rows.size())));
  for (int i = 0; i <= 5; ++i) {
    const double at = left + i / 5.0 * width;
    canvas.line({at, frame.y}, {at, frame.y + step * double(ladder.rows.size()) + 8}, 1, band);
    canvas.text({at, frame.y + step * double(ladder.rows.size()) + 26}, number(t.value(i / 5.0)),
                {17, soft_ink, Canvas::Align::center});
  }
  bool is_whole = true;
  double y = frame.y + step / 2;
  for (const auto& row : ladder.rows) {
    const Rgb color = color_of(row.role);
    canvas.text({frame.x, y}, canvas.shortened(row.name, {18, color}, names - 12), {18, color});
    canvas.line({left, y}, {left + width, y}, 1, faint_ink);
    for (const auto& [lo, hi] : row.intervals) {
      const auto place = [&](double x) { return left + std::clamp(std::isnan(x) ? 0 : t.share(x), 0.0, 1.0) * width; };
      is_whole &= !std::isnan(lo) && !std::isnan(hi);
      canvas.rectangle({place(lo), y - step * 0.26}, std::max(2.0, place(hi) - place(lo)), step * 0.52, color, 0.55);
      for (const double end : {lo, hi}) {  // ends of intervals that meet stay visible
        if (std::isfinite(end)) canvas.line({place(end), y - step * 0.36}, {place(end), y + step * 0.36}, 2.5, color);
      }
    }
    y += step;
  }
  return is_whole;
}

bool draw_image(Canvas& canvas, const PanelFrame& frame, const ImagePanel& image) {
  const double fit = std::min(frame.width / image.width, frame.height / image.height);
  const double pixel = fit >= 1 ? std::floor(fit) : fit;
  ColorGrid grid{image.width, image.height, image.bytes};
  if (pixel < 1) {  // fewer pixels than there are: every so-manieth
    const int every = static_cast<int>(std::ceil(1 / fit));
    ColorGrid small{(image.width + every - 1) / every, (image.height + every - 1) / every, {}};
    for (int y = 0; y < image.height; y += every) {
      for (int x = 0; x < image.width; x += every) {
        const auto at = 3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
        small.bytes.insert(small.bytes.end(), image.bytes.begin() + std::ptrdiff_t(at),
                           image.bytes.begin() + std::ptrdiff_t(at + 3));
      }
    }
    grid = std::move(small);
  }
  const double shown = std::max(1.0, pixel);
  canvas.image({std::round(frame.x + (frame.width - shown * grid.width) / 2), std::round(frame.y)}, grid, shown);
  return true;
}

/// Roles that the panels show, in a row at the bottom right.
void draw_legend(Canvas& canvas, const Drawing& drawing, double width, double y) {
  std::array<bool, 7> has{};
  for (const Panel& panel : drawing.panels) {
    const auto* space = std::get_if<SpacePanel>(&panel.content);
    if (space == nullptr) continue;
    const auto note = [&](Role role) { has[static_cast<std::size_t>(role)] = true; };
    for (const auto& triangle : space->triangles) note(triangle.role);
    if (!space->boxes.empty() || std::ranges::any_of(space->balls, [](const auto& b) { return b.role == Role::cell; }))
      note(Role::cell);
    for (const auto& line : space->lines) note(line.role);
    for (const auto& dot : space->dots) note(dot.role);
  }
  double x = width - margin;
  for (const Role role : {Role::missed, Role::wrong, Role::right, Role::ray, Role::cell}) {
    if (!has[static_cast<std::size_t>(role)]) continue;
    const Canvas::TextStyle style{18, ink};
    x -= canvas.text_width(name_of(role), style);
    canvas.text({x, y}, name_of(role), style);
    x -= 22;
    canvas.rectangle({x, y - 7}, 15, 15, color_of(role));
    x -= 26;
  }
}

}  // namespace

void write_drawing_png(const std::filesystem::path& path, const Drawing& drawing, const DrawingSize& size) {
  write_picture(path, size.width, size.height, [&](vtkRenderWindow& window, int scale) {
    const double unit = std::min(size.width / 1200.0, size.height / 900.0);
    const double width = size.width / unit, height = size.height / unit;
    Canvas canvas(height, unit * scale);
    canvas.text({margin, 36}, canvas.shortened(drawing.title, {28, ink}, width - 2 * margin),
                {28, ink, Canvas::Align::left, true});
    const auto count = std::max<std::size_t>(1, drawing.panels.size());
    const double each = (width - 2 * margin - gap * double(count - 1)) / double(count);
    bool is_whole = true;
    double x = margin;
    for (const Panel& panel : drawing.panels) {
      PanelFrame frame{x, head, each, height - head - foot};
      if (!panel.title.empty()) frame = framed(canvas, frame, panel.title, {});
      is_whole &= std::visit(
          [&](const auto& content) {
            using C = std::remove_cvref_t<decltype(content)>;
            if constexpr (std::is_same_v<C, SpacePanel>) return draw_space(canvas, frame, content);
            if constexpr (std::is_same_v<C, ChartPanel>) return draw_chart(canvas, frame, content);
            if constexpr (std::is_same_v<C, LadderPanel>) return draw_ladder(canvas, frame, content);
            if constexpr (std::is_same_v<C, ImagePanel>) return draw_image(canvas, frame, content);
          },
          panel.content);
      x += each + gap;
    }
    const std::string caption = drawing.caption + (is_whole ? "" : " What is not finite is not drawn.");
    canvas.text({margin, height - 22}, canvas.shortened(caption, {18, soft_ink}, width - 2 * margin), {18, soft_ink});
    draw_legend(canvas, drawing, width, height - 50);
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetBackground(1, 1, 1);
    canvas.add_to(*renderer);
    window.AddRenderer(renderer);
  });
}

}  // namespace sightline::viz
