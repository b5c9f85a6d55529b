#include "viz/graph/graph_window.h"

#include <vtkCellPicker.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "viz/graph/graph_table.h"
#include "viz/graph/tree_panel.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr unsigned long tick_length = 40;  // milliseconds
constexpr int ticks_a_step = 8;

constexpr const char* help =
    "drag a thing: move its node  |  beside: turn  |  wheel: closer  |  Up, Down: parent, child  |  B: bounds  |  "
    "+ -: depths  |  T: things  |  Space: play  |  R: back";

}  // namespace

GraphWindow::GraphWindow(LiveScene& scene, const Controller* controller, double duration, const std::string& title,
                         const GraphLook& look, int width, int height, std::ostream& tables)
    : InteractiveWindow("graph " + title, width, height),
      scene_(scene),
      controller_(controller),
      duration_(duration),
      tables_(tables),
      drawn_(scene.scene()),
      picture_{drawn_, {still_frame(scene, look.kind)}, look, true, title, summary(drawn_, look), "", help, width,
               height},
      first_look_(look),
      camera_(picture_.camera()) {
  for (NodeId node = 0; node < drawn_.graph.size(); ++node) first_places_.push_back(drawn_.graph.local(node));
  show();
}

// ---- The hand

/// The window's rows count from below, where the picture's last one is.
Canvas::Point GraphWindow::hand_at() const {
  const double unit = picture_.layout().unit();
  const int* at = interactor().GetEventPosition();
  return {(at[0] + 0.5) / unit, (picture_.height - 0.5 - at[1]) / unit};
}

std::optional<std::pair<NodeId, Vec3d>> GraphWindow::thing_at_hand() const {
  auto picker = New<vtkCellPicker>::New();
  picker->SetTolerance(0);
  const int* at = interactor().GetEventPosition();
  if (!picker->Pick(at[0], at[1], 0, spaces_.front().renderer)) return std::nullopt;
  for (const auto& [actor, node] : spaces_.front().things) {
    if (actor != picker->GetActor()) continue;
    Vec3d p;
    picker->GetPickPosition(&p[0]);
    return std::pair(node, p);
  }
  return std::nullopt;
}

bool GraphWindow::is_chosen(NodeId node) const {
  while (node != no_node && node != picture_.look.selected) node = drawn_.graph.parent(node);
  return node != no_node && node != root_node;
}

void GraphWindow::press() {
  const GraphLayout layout = picture_.layout();
  const FramePlace& place = layout.frames().front();
  from_ = hand_at();
  steps_.clear();
  if (const auto row = TreePanel(drawn_, picture_.look.selected, place.tree).node_at(from_)) return choose(*row);
  const PanelFrame& space = place.space;
  const bool is_within =
      from_.x >= space.x && from_.x < space.x + space.width && from_.y >= space.y && from_.y < space.y + space.height;
  if (!is_within) return;
  const auto thing = thing_at_hand();
  if (!thing) {
    hand_ = Hand::turning;
    return;
  }
  if (!is_chosen(thing->first)) choose(thing->first);
  hand_ = Hand::moving;
  anchor_ = thing->second;
  change_.reset();
}

void GraphWindow::move() {
  if (hand_ == Hand::idle) return;
  const Canvas::Point at = hand_at();
  const double right = at.x - from_.x, up = from_.y - at.y;
  if (right == 0 && up == 0) return;
  from_ = at;
  if (hand_ == Hand::turning) return turn(right, up);
  const double unit = 2 * camera_.half_height_at(anchor_) / picture_.layout().frames().front().space.height;
  const Vec3d by = unit * (right * camera_.axes.x + up * camera_.axes.y);
  anchor_ += by;
  Change step = drag(scene_, picture_.look.selected, by, picture_.look.kind);
  if (change_) step.before = change_->before, step.by += change_->by;
  change_ = std::move(step);
  picture_.frames = {frames_of(*change_, drawn_.graph, 2).back()};
  picture_.verdict = verdict_of(*change_, drawn_.graph);
  show();
}

void GraphWindow::release() {
  const bool has_moved = hand_ == Hand::moving && change_;
  hand_ = Hand::idle;
  if (!has_moved) return;
  tables_ << '\n' << picture_.verdict << '\n' << change_table(drawn_.graph, drawn_.shape, *change_, true) << std::flush;
  steps_ = frames_of(*change_, drawn_.graph, static_cast<int>(std::min<std::size_t>(change_->way.size() + 2, 40)));
  steps_.erase(steps_.begin());
  std::reverse(steps_.begin(), steps_.end());
  ticks_ = 0;
  start_clock(tick_length);
}

// ---- Keys and time

void GraphWindow::answer_key(const std::string& key) {
  GraphLook& look = picture_.look;
  const SceneGraph& graph = drawn_.graph;
  if (key == "r" || key == "R") {
    go_back();
  } else if (key == "Up" && look.selected != root_node) {
    choose(graph.parent(look.selected));
  } else if (key == "Down" && graph.first_child(look.selected) != no_node) {
    choose(graph.first_child(look.selected));
  } else if (key == "b" || key == "B") {
    look.kind = bound_kinds[(static_cast<std::size_t>(look.kind) + 1) % bound_kinds.size()];
    let_rest();
  } else if ((key == "plus" || key == "KP_Add") && look.deepest < drawn_.shape.deepest) {
    ++look.deepest;
    let_rest();
  } else if ((key == "minus" || key == "KP_Subtract") && look.deepest > look.shallowest) {
    --look.deepest;
    let_rest();
  } else if (key == "t" || key == "T") {
    look.has_things = !look.has_things;
    show();
  } else if (key == "space" && controller_ != nullptr) {
    is_playing_ = !is_playing_;
    start_clock(tick_length);
  }
}

void GraphWindow::tick() {
  if (!steps_.empty()) {
    if (ticks_++ % ticks_a_step != 0) return;
    picture_.frames = {steps_.back()};
    steps_.pop_back();
    show();
  } else if (is_playing_ && hand_ == Hand::idle) {
    time_ = duration_ > 0 ? std::fmod(time_ + 0.001 * tick_length, duration_) : time_ + 0.001 * tick_length;
    picture_.frames = frames_of(scene_, *controller_, time_, time_, 1, picture_.look.kind);
    picture_.verdict = picture_.frames.front().title + ": events pass " +
                       counted(picture_.frames.front().told.size(), "node") + "; " + picture_.frames.front().text;
    picture_.frames.front().title = picture_.frames.front().text = "";
    show();
  }
}

void GraphWindow::choose(NodeId node) {
  picture_.look.selected = node;
  let_rest();
}

void GraphWindow::go_back() {
  for (NodeId node = 0; node < drawn_.graph.size(); ++node) {
    if (!(drawn_.graph.local(node) == first_places_[node])) scene_.set_local(node, first_places_[node]);
  }
  is_playing_ = false;
  time_ = 0;
  picture_.look = first_look_;
  let_rest();
  camera_ = picture_.camera();
  show();
}

// ---- The view

void GraphWindow::turn(double right, double up) {
  constexpr double degrees = 0.4;  // for one unit
  picture_.look.azimuth = std::fmod(picture_.look.azimuth - degrees * right, 360);
  picture_.look.elevation = std::clamp(picture_.look.elevation - degrees * up, -90.0, 90.0);
  const double distance = glm::length(camera_.eye - camera_.focus);
  camera_.axes = axes_toward(picture_.look.azimuth, picture_.look.elevation);
  camera_.eye = camera_.focus + distance * camera_.axes.z;
  show();
}

void GraphWindow::zoom(double factor) {
  camera_.eye = camera_.focus + (camera_.eye - camera_.focus) / factor;
  show();
}

/// The picture grows and shrinks with the window.
void GraphWindow::fit() {
  const int width = std::max(window().GetSize()[0], GraphLayout::lowest_width);
  const int height = std::max(window().GetSize()[1], GraphLayout::lowest_height);
  if (width == picture_.width && height == picture_.height) return;
  picture_.width = width, picture_.height = height;
  camera_.aspect = picture_.camera().aspect;
  show();
}

/// The scene as it stands, without a change.
void GraphWindow::let_rest() {
  steps_.clear();
  change_.reset();
  picture_.verdict.clear();
  picture_.frames = {still_frame(scene_, picture_.look.kind)};
  picture_.subtitle = summary(drawn_, picture_.look);
  show();
}

void GraphWindow::show() {
  spaces_ = picture_.show_in(window(), 1, camera_);
  window().Render();
}

}  // namespace sightline::viz
