#include "viz/compare/compare_window.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ostream>

#include "sightline/io/progress.h"
#include "viz/compare/compare_data.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr int slack = 4;  // pixels that a click may move
constexpr int turning_coarseness = 4;
constexpr double lowest_zoom = 0.1, highest_zoom = 100;

/// Numbers that a command line tells in few digits.
double rounded(double number, double parts) { return std::round(number * parts) / parts; }

}  // namespace

CompareWindow::CompareWindow(CompareSession& session, const CompareLook& look, int width, int height, std::ostream& out)
    : InteractiveWindow("compare " + session.source().scene, width, height),
      session_(session),
      look_(look),
      first_(look),
      width_(width),
      height_(height),
      out_(out) {
  show();
}

void CompareWindow::zoom(double factor) {
  look_.zoom = std::clamp(rounded(look_.zoom * factor, 1000), lowest_zoom, highest_zoom);
  show();
}

void CompareWindow::press() {
  is_held_ = true, has_turned_ = false;
  std::copy_n(interactor().GetEventPosition(), 2, from_);
}

void CompareWindow::move() {
  if (!is_held_) return;
  const int* at = interactor().GetEventPosition();
  const int right = at[0] - from_[0], up = at[1] - from_[1];
  if (!has_turned_ && std::max(std::abs(right), std::abs(up)) <= slack) return;
  has_turned_ = true;
  std::copy_n(at, 2, from_);
  constexpr double degrees = 0.3;  // for one pixel
  look_.azimuth = rounded(std::fmod(look_.azimuth - degrees * right, 360), 10);
  look_.elevation = std::clamp(rounded(look_.elevation - degrees * up, 10), -90.0, 90.0);
  show(true);
}

void CompareWindow::release() {
  if (!is_held_) return;
  is_held_ = false;
  if (has_turned_) return show();
  // The window's rows count from below, where the picture's last one is.
  const auto ray =
      ray_through_pixel(session_.compared().front().tracer->mesh(), look_,
                        session_.picture(look_, width_, height_).layout(), from_[0], height_ - 1 - from_[1]);
  if (!ray || look_.kind == CompareKind::histogram) return;
  look_.ray = *ray;
  show();
  out_ << '\n' << comparison_table(session_.compared(), findings()) << command() << '\n' << std::flush;
}

void CompareWindow::answer_key(const std::string& key) {
  const auto next = [](auto value, std::size_t count) {
    return static_cast<decltype(value)>((static_cast<std::size_t>(value) + 1) % count);
  };
  const auto is = [&](char letter) {
    return key.size() == 1 && std::tolower(static_cast<unsigned char>(key[0])) == letter;
  };
  if (is('s')) {
    out_ << command() << '\n' << std::flush;
    return;
  }
  if (is('h')) {
    has_help_ = !has_help_;
  } else if (is('m')) {
    look_.kind = next(look_.kind, compare_kinds.size());
  } else if (is('c')) {
    look_.work = next(look_.work, std::size(work_kinds));
  } else if (is('a')) {
    look_.against = next(look_.against, session_.compared().size());
  } else if (is('r')) {
    look_ = first_;
  } else if (is('0')) {
    look_.alone.reset();
  } else if (key.size() == 1 && key[0] >= '1' && key[0] <= '9') {
    const auto which = static_cast<std::size_t>(key[0] - '1');
    if (which >= session_.compared().size()) return;
    look_.alone = look_.alone == which ? std::nullopt : std::optional(which);
  } else {
    return;
  }
  show();
}

/// The picture grows and shrinks with the window.
void CompareWindow::fit() {
  const int width = std::max(window().GetSize()[0], CompareLayout::lowest_width);
  const int height = std::max(window().GetSize()[1], CompareLayout::lowest_height);
  if (width == width_ && height == height_) return;
  width_ = width, height_ = height;
  show();
}

void CompareWindow::show(bool is_turning) {
  Progress progress;
  session_.find(look_, width_, height_, look_.kind != CompareKind::walk, is_turning ? turning_coarseness : 1,
                [&](const std::string& label) { progress.say("tracing the picture's rays", label); });
  progress.clear();
  session_.picture(look_, width_, height_, has_help_).show_in(window(), 1);
  window().Render();
}

}  // namespace sightline::viz
