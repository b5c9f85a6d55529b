#include "viz/compare/compare_layout.h"

#include <algorithm>
#include <cmath>

namespace sightline::viz {
namespace {

constexpr double usual_width = 1920, usual_height = 1080, smallest_unit = 0.62;
constexpr double top = 104, bottom = 118, gap = 24, text_height = 62;

/// Columns of a wide picture; of a tall one, rows.
std::size_t longer_side(std::size_t panels) { return panels <= 3 ? panels : (panels + 1) / 2; }

}  // namespace

CompareLayout::CompareLayout(int width, int height, std::size_t panels)
    : unit_(std::max(smallest_unit, std::min(width / usual_width, height / usual_height))),
      width_(width / unit_),
      height_(height / unit_) {
  const std::size_t longer = longer_side(panels), shorter = (panels + longer - 1) / longer;
  const std::size_t columns = width >= height ? longer : shorter, rows = width >= height ? shorter : longer;
  const double panel_width = (width_ - 2 * margin - gap * (double(columns) - 1)) / double(columns);
  const double panel_height = (height_ - top - bottom - gap * (double(rows) - 1)) / double(rows);
  const auto pixels = [this](double units) { return static_cast<int>(std::lround(units * unit_)); };
  for (std::size_t i = 0; i < panels; ++i) {
    const double x = margin + double(i % columns) * (panel_width + gap);
    const double y = top + double(i / columns) * (panel_height + gap);
    panels_.push_back({x, y, panel_width, panel_height});
    pictures_.push_back({pixels(x), pixels(y + text_height), pixels(panel_width), pixels(panel_height - text_height)});
  }
}

PanelFrame CompareLayout::units(const PixelFrame& f) const {
  return {f.x / unit_, f.y / unit_, f.width / unit_, f.height / unit_};
}

}  // namespace sightline::viz
