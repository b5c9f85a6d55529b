#include "viz/csg_window.h"

#include <algorithm>
#include <ostream>

#include "viz/command_text.h"
#include "viz/csg_table.h"

namespace sightline::viz {

CsgWindow::CsgWindow(const CsgPicture& first, std::string command, std::ostream& tables, WindowFrame* frame)
    : InteractiveWindow({.name = "csg",
                         .title = "csg " + first.name,
                         .width = first.width,
                         .height = first.height,
                         .tells_command = false},
                        frame, tables),
      picture_(first),
      command_(std::move(command)),
      first_(first.ladder.ray) {
  show();
}

std::string CsgWindow::command() const {
  return command_ + " --ray=" + text_of(picture_.ladder.ray) + " --size " + std::to_string(picture_.width) + 'x' +
         std::to_string(picture_.height);
}

std::vector<WindowKey> CsgWindow::keys() const {
  return {{"click on the solid", "the ray through that pixel; its table is printed"}, {"R", "the first ray"}};
}

void CsgWindow::press() {
  // The window's rows count from below, where the picture's last one is.
  const int x = hand()[0], y = picture_.height - 1 - hand()[1];
  if (const auto ray = ray_through_pixel(picture_.solid, picture_.width, picture_.height, x, y)) choose(*ray);
}

void CsgWindow::answer_key(const std::string& key) {
  if (key == "r" || key == "R") choose(first_);
}

void CsgWindow::choose(const Ray<double>& ray) {
  picture_.ladder = picture_.solid.climb(ray, picture_.ladder.level);
  out() << '\n' << ladder_table(picture_.ladder, picture_.solid, picture_.name) << std::flush;
  show();
}

/// The picture grows and shrinks with the window.
void CsgWindow::fit() {
  const auto [width, height] = area_for<CsgLayout>();
  if (width == picture_.width && height == picture_.height) return;
  picture_.width = width, picture_.height = height;
  show();
}

void CsgWindow::show() {
  picture_.show_in(window(), 1);
  render();
}

}  // namespace sightline::viz
