#include "viz/interactive_window.h"

#include <iostream>

namespace sightline::viz {
namespace {

/// "walk-1.png", or the next number that is free.
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& name) {
  int number = 1;
  std::filesystem::path path;
  do {
    path = folder / (name + '-' + std::to_string(number++) + ".png");
  } while (std::filesystem::exists(path));
  return path;
}

}  // namespace

InteractiveWindow::InteractiveWindow(const Place& place, WindowFrame* frame, std::ostream& out)
    : own_(frame ? nullptr
                 : std::make_unique<WindowFrame>(place.title, place.width,
                                                 place.height + (place.tells_command ? 0 : WindowFrame::foot_height),
                                                 place.samples)),
      frame_(frame ? *frame : *own_),
      out_(out),
      name_(place.name),
      tells_command_(place.tells_command) {
  frame_.enter(*this);
  if (frame) window().SetWindowName(place.title.c_str());
}

InteractiveWindow::~InteractiveWindow() { frame_.leave(*this); }

std::array<int, 2> InteractiveWindow::area() const {
  const int* size = window().GetSize();
  return {size[0], size[1] - foot() - (frame_.has_bar() ? WindowBar::height : 0)};
}

std::array<int, 2> InteractiveWindow::hand() const {
  const int* at = interactor().GetEventPosition();
  return {at[0], at[1] - foot()};
}

void InteractiveWindow::answer_common_key(const std::string& key) {
  if (key == "h" || key == "H") {
    has_help_ = !has_help_;
    show();
  } else if (key == "s" || key == "S") {
    save();
  } else {
    answer_key(key);
  }
}

/// Goes on where the picture cannot be written.
void InteractiveWindow::save() try {
  const std::filesystem::path path = free_name(folder_, name_);
  write_png(path);
  out_ << command() << " --out " << path.string() << std::endl;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
}

}  // namespace sightline::viz
