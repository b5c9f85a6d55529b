#include "viz/csg_window.h"

#include <algorithm>
#include <ostream>

#include "viz/csg_table.h"

namespace sightline::viz {
CsgWindow::CsgWindow(const CsgPicture& first, std::ostream& tables)
    : InteractiveWindow("csg " + first.name, first.width, first.height),
      picture_(first),
      first_(first.ladder.ray),
      tables_(tables) {
  show();
}

void CsgWindow::press() {
  // The window's rows count from below, where the picture's last one is.
  const int x = interactor().GetEventPosition()[0], y = picture_.height - 1 - interactor().GetEventPosition()[1];
  if (const auto ray = ray_through_pixel(picture_.solid, picture_.width, picture_.height, x, y)) choose(*ray);
}

void CsgWindow::answer_key(const std::string& key) {
  if (key == "r" || key == "R") choose(first_);
}

void CsgWindow::choose(const Ray<double>& ray) {
  picture_.ladder = picture_.solid.climb(ray, picture_.ladder.level);
  tables_ << '\n' << ladder_table(picture_.ladder, picture_.solid, picture_.name) << std::flush;
  show();
}

/// The picture grows and shrinks with the window.
void CsgWindow::fit() {
  const int width = std::max(window().GetSize()[0], CsgLayout::lowest_width);
  const int height = std::max(window().GetSize()[1], CsgLayout::lowest_height);
  if (width == picture_.width && height == picture_.height) return;
  picture_.width = width, picture_.height = height;
  show();
}

void CsgWindow::show() {
  picture_.show_in(window(), 1);
  window().Render();
}

}  // namespace sightline::viz
