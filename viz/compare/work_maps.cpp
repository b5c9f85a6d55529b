#include "viz/compare/work_maps.h"

#include <algorithm>
#include <cmath>

#include "viz/compare/work_statistics.h"
#include "viz/heat_map.h"
#include "viz/paper.h"

namespace sightline::viz {
namespace {

constexpr double bar_height = 18;
constexpr int stripes = 256;

template <class T, class Color>
ColorGrid map_of(std::span<const T> numbers, int width, int height, const Color& color) {
  ColorGrid grid{width, height, {}};
  grid.bytes.reserve(3 * numbers.size());
  for (const T number : numbers) {
    for (const double component : color(double(number))) {
      grid.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(component, 0.0, 1.0))));
    }
  }
  return grid;
}

/// `color` of each share from 0 to 1.
template <class Color>
void draw_bar(Canvas& canvas, const LegendBar& bar, const Color& color) {
  for (int i = 0; i < stripes; ++i) {
    canvas.rectangle({bar.x + bar.width * i / stripes, bar.y}, bar.width / stripes + 0.5, bar_height,
                     color((i + 0.5) / stripes));
  }
}

void draw_tick(Canvas& canvas, const LegendBar& bar, double share, const std::string& text) {
  const double x = bar.x + share * bar.width;
  canvas.line({x, bar.y + bar_height}, {x, bar.y + bar_height + 5}, 1.2, ink);
  canvas.text({x, bar.y + bar_height + 17}, text, {18, ink, Canvas::Align::center});
}

}  // namespace

ColorGrid work_map(std::span<const std::uint32_t> work, int width, int height, double highest) {
  return map_of(work, width, height, [&](double steps) { return heat_color(steps, highest); });
}

ColorGrid difference_map(std::span<const std::int64_t> differences, int width, int height, double scale) {
  return map_of(differences, width, height, [&](double steps) { return diverging(difference_share(steps, scale)); });
}

void draw_work_legend(Canvas& canvas, const LegendBar& bar, double highest) {
  draw_bar(canvas, bar, [&](double share) { return heat_color(std::pow(highest, share), highest); });
  for (double decade = 1; decade <= highest; decade *= 10) {
    for (const int step : {1, 3}) {
      const double work = decade * step;
      if (work <= highest) draw_tick(canvas, bar, heat_share(work, highest), std::to_string(std::lround(work)));
    }
  }
}

void draw_difference_legend(Canvas& canvas, const LegendBar& bar, double scale) {
  const auto color_at = [&](double share) { return diverging(2 * share - 1); };
  draw_bar(canvas, bar, color_at);
  draw_tick(canvas, bar, 0.5, "0");
  double last = 0;
  for (double decade = 1; decade <= scale; decade *= 10) {
    for (const int step : {1, 3}) {
      const double share = difference_share(decade * step, scale);
      const bool is_apart = (share - last) * bar.width / 2 > 40;  // units, so that numbers stay apart
      if (decade * step > scale || !is_apart) continue;
      last = share;
      const std::string number = std::to_string(std::lround(decade * step));
      draw_tick(canvas, bar, 0.5 + share / 2, "+" + number);
      draw_tick(canvas, bar, 0.5 - share / 2, "-" + number);
    }
  }
}

}  // namespace sightline::viz
