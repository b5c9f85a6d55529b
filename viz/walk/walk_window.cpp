#include "viz/walk/walk_window.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "viz/walk/coarse_mesh.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr unsigned long tick_length = 250;  // milliseconds

}  // namespace

WalkWindow::WalkWindow(const WalkModel& model, std::size_t step, const WalkLook& look, std::ostream& commands)
    : InteractiveWindow("walk " + model.structure + " on " + model.scene, look.width, look.height, 0),
      model_(model),
      first_model_(model),
      step_(step),
      first_step_(step),
      look_(look),
      first_look_(look),
      commands_(commands),
      view_(window(), coarse_mesh(model.tracer->mesh(), most_triangles), model.tracer->mesh().size(), 1) {
  show();
}

void WalkWindow::answer_key(const std::string& key) {
  const Walk& walk = model_.walk;
  if (key == "Right") {
    go_to(std::min(step_ + 1, model_.last_step()));
  } else if (key == "Left") {
    go_to(step_ > 0 ? step_ - 1 : 0);
  } else if (key == "Home") {
    go_to(0);
  } else if (key == "End") {
    go_to(model_.last_step());
  } else if (key == "Next" || key == "Page_Down") {
    go_to(leaf_beside(walk, step_, 1));
  } else if (key == "Prior" || key == "Page_Up") {
    go_to(leaf_beside(walk, step_, -1));
  } else if (key == "space") {
    is_playing_ = !is_playing_;
    if (is_playing_ && step_ == model_.last_step()) go_to(0);
    start_clock(tick_length);
  } else if (key == "plus" || key == "KP_Add") {
    zoom(1.15);
  } else if (key == "minus" || key == "KP_Subtract") {
    zoom(1 / 1.15);
  } else if (key == "h" || key == "H") {
    has_help_ = !has_help_;
    show();
  } else if (key == "s" || key == "S") {
    commands_ << command_of(model_, step_, look_) << std::endl;
  } else if (key == "r" || key == "R") {
    model_ = first_model_, step_ = first_step_;
    const int width = look_.width, height = look_.height;
    look_ = first_look_;
    look_.width = width, look_.height = height;
    show();
  }
}

void WalkWindow::tick() {
  if (!is_playing_) return;
  if (step_ == model_.last_step()) {
    is_playing_ = false;
  } else {
    go_to(step_ + 1);
  }
}

void WalkWindow::go_to(std::size_t step) {
  if (step == step_) return;
  step_ = step;
  show();
}

// ---- The hand

/// The window's rows count from below, where the picture's last one is.
Canvas::Point WalkWindow::hand_at() const {
  const double unit = look_.layout().unit();
  const int* at = interactor().GetEventPosition();
  return {(at[0] + 0.5) / unit, (look_.height - 0.5 - at[1]) / unit};
}

void WalkWindow::press() {
  from_ = hand_at();
  const WalkLayout layout = look_.layout();
  const Walk& walk = model_.walk;
  if (layout.space.contains(from_.x, from_.y)) {
    hand_ = Hand::holding;
    return;
  }
  if (walk.steps.empty()) return;
  if (from_.y >= layout.timeline.y && from_.y < layout.reach.y + layout.reach.height) {
    if (const auto step = step_at(lay_out_timeline(walk, layout.timeline), from_.x)) go_to(*step);
    return;
  }
  const auto states = states_at(walk, step_);
  auto cell = lay_out_tree(walk, states, current_cell(walk, step_), layout.tree).cell_at(from_.x, from_.y);
  if (!cell && layout.treemap.contains(from_.x, from_.y)) {
    cell = cell_at(lay_out_treemap(walk, model_.candidates, layout.treemap), walk, from_.x, from_.y);
  }
  if (cell && walk.cells[*cell].opened) go_to(*walk.cells[*cell].opened);
}

void WalkWindow::move() {
  if (hand_ == Hand::idle) return;
  const Canvas::Point at = hand_at();
  const double right = at.x - from_.x, up = from_.y - at.y;
  constexpr double still = 4;  // units that a click may slip
  if (hand_ == Hand::holding && std::hypot(right, up) < still) return;
  hand_ = Hand::turning;
  from_ = at;
  constexpr double degrees = 0.4;  // for one unit
  look_.azimuth = std::fmod(look_.azimuth - degrees * right, 360);
  look_.elevation = std::clamp(look_.elevation - degrees * up, -90.0, 90.0);
  view_.turn(model_, step_, look_);
  window().Render();
}

void WalkWindow::release() {
  const Hand hand = hand_;
  hand_ = Hand::idle;
  if (hand == Hand::turning) return show();
  if (hand != Hand::holding) return;
  const int* at = interactor().GetEventPosition();
  if (const auto ray = ray_through_pixel(model_, look_, at[0], look_.height - 1 - at[1])) choose(*ray);
}

void WalkWindow::choose(const Ray<float>& ray) {
  model_ = walk_again(model_, ray);
  step_ = model_.tracer->is_lazy() ? 0 : model_.last_step();  // what grows is to be watched
  look_.azimuth = std::fmod(look_.azimuth + aside, 360);
  is_playing_ = false;
  show();
}

// ---- The view

void WalkWindow::zoom(double factor) {
  look_.zoom = std::clamp(look_.zoom * factor, 0.1, 100.0);
  show();
}

/// The picture grows and shrinks with the window.
void WalkWindow::fit() {
  const int width = std::max(window().GetSize()[0], WalkLayout::lowest_width);
  const int height = std::max(window().GetSize()[1], WalkLayout::lowest_height);
  if (width == look_.width && height == look_.height) return;
  look_.width = width, look_.height = height;
  show();
}

void WalkWindow::show() {
  view_.show(model_, step_, look_, has_help_);
  window().Render();
}

}  // namespace sightline::viz
