#include "viz/compare/compare_window.h"

#include <vtkCommand.h>
#include <vtkInteractorStyleUser.h>

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

class CompareWindow::Events : public vtkCommand {
 public:
  static Events* New() { return new Events; }
  void tell(CompareWindow& window) { window_ = &window; }
  void Execute(vtkObject*, unsigned long event, void*) override { window_->answer(event); }

 private:
  CompareWindow* window_ = nullptr;
};

CompareWindow::CompareWindow(CompareSession& session, const CompareLook& look, int width, int height, std::ostream& out)
    : session_(session),
      look_(look),
      first_(look),
      width_(width),
      height_(height),
      out_(out),
      window_(New<vtkRenderWindow>::New()),
      interactor_(New<vtkRenderWindowInteractor>::New()) {
  window_->SetWindowName(("compare " + session.source().scene).c_str());
  window_->SetSize(width, height);
  window_->SetMultiSamples(8);
  interactor_->SetRenderWindow(window_);
  auto style = New<vtkInteractorStyleUser>::New();
  interactor_->SetInteractorStyle(style);
  auto events = New<Events>::New();
  events->tell(*this);
  for (const auto event :
       {vtkCommand::LeftButtonPressEvent, vtkCommand::MouseMoveEvent, vtkCommand::LeftButtonReleaseEvent,
        vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent, vtkCommand::KeyPressEvent,
        vtkCommand::ConfigureEvent}) {
    interactor_->AddObserver(event, events);
  }
  style->AddObserver(vtkCommand::CharEvent, events);  // keys have no other meaning than here
  show();
}

void CompareWindow::run() { interactor_->Start(); }

void CompareWindow::answer(unsigned long event) {
  const auto zoom = [this](double factor) {
    look_.zoom = std::clamp(rounded(look_.zoom * factor, 1000), lowest_zoom, highest_zoom);
    show();
  };
  switch (event) {
    case vtkCommand::LeftButtonPressEvent:
      return press();
    case vtkCommand::MouseMoveEvent:
      return move();
    case vtkCommand::LeftButtonReleaseEvent:
      return release();
    case vtkCommand::MouseWheelForwardEvent:
      return zoom(1.15);
    case vtkCommand::MouseWheelBackwardEvent:
      return zoom(1 / 1.15);
    case vtkCommand::ConfigureEvent:
      return fit();
    case vtkCommand::KeyPressEvent:
      return answer_key(interactor_->GetKeySym() ? interactor_->GetKeySym() : "");
    default:
      return;
  }
}

void CompareWindow::press() {
  is_held_ = true, has_turned_ = false;
  std::copy_n(interactor_->GetEventPosition(), 2, from_);
}

void CompareWindow::move() {
  if (!is_held_) return;
  const int* at = interactor_->GetEventPosition();
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
  if (is('q')) return interactor_->ExitCallback();
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
  const int width = std::max(window_->GetSize()[0], CompareLayout::lowest_width);
  const int height = std::max(window_->GetSize()[1], CompareLayout::lowest_height);
  if (width == width_ && height == height_) return;
  width_ = width, height_ = height;
  show();
}

void CompareWindow::show(bool is_turning) {
  Progress progress;
  session_.find(look_, width_, height_, look_.kind != CompareKind::walk, is_turning ? turning_coarseness : 1,
                [&](const std::string& label) { progress.say("tracing the picture's rays", label); });
  progress.clear();
  session_.picture(look_, width_, height_, has_help_).show_in(*window_, 1);
  window_->Render();
}

}  // namespace sightline::viz
