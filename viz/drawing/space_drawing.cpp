#include "viz/drawing/space_drawing.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "viz/space_camera.h"
#include "viz/walk/walk_colors.h"

namespace sightline::viz {
namespace {

Vec3d vector_of(const Point3& p) { return {p[0], p[1], p[2]}; }
bool is_finite(const Point3& p) {
  return std::ranges::all_of(p, [](double x) { return std::isfinite(x); });
}

/// A shape that waits for its turn.
struct Shape {
  double depth;  ///< Toward the eye.
  std::function<void()> draw;
};

class SpaceDrawing {
 public:
  SpaceDrawing(Canvas& canvas, const PanelFrame& frame, const SpacePanel& panel)
      : canvas_(canvas), frame_(frame), panel_(panel) {
    collect_points();
    // From above where all is flat, so that lengths and angles are what they are.
    const bool is_flat = std::ranges::all_of(points_, [&](const Vec3d& p) { return p.z == points_.front().z; });
    const Axes axes = axes_toward(is_flat ? 0 : 28, is_flat ? 0 : 22);
    camera_ = fit_camera(axes, points_, frame.width / frame.height, 0.9);
  }

  bool draw() {
    if (points_.empty()) return is_whole_;
    add_triangles();
    add_boxes();
    add_balls();
    std::ranges::stable_sort(shapes_, {}, &Shape::depth);
    for (const Shape& shape : shapes_) shape.draw();
    // What is asked and answered is seen through everything.
    for (const auto& line : panel_.lines) draw_line(line);
    for (const auto& dot : panel_.dots) draw_dot(dot);
    for (const auto& triangle : panel_.triangles) {
      if (triangle.role == Role::missed) label_triangle(triangle, "overlooked: " + triangle.label);
    }
    return is_whole_;
  }

 private:
  void keep(const Point3& p, double around = 0) {
    if (!is_finite(p) || !std::isfinite(around)) {
      is_whole_ = false;
      return;
    }
    for (const double side : {-around, around}) {
      points_.push_back(vector_of(p) + Vec3d(side, 0, 0));
      if (around == 0) return;
      points_.push_back(vector_of(p) + Vec3d(0, side, 0));
      points_.push_back(vector_of(p) + Vec3d(0, 0, side));
    }
  }
  void collect_points() {
    for (const auto& triangle : panel_.triangles) {
      for (const Point3& corner : triangle.corners) keep(corner);
    }
    for (const auto& box : panel_.boxes) {
      for (int i = 0; i < 8; ++i) {
        keep({i & 1 ? box.hi[0] : box.lo[0], i & 2 ? box.hi[1] : box.lo[1], i & 4 ? box.hi[2] : box.lo[2]});
      }
    }
    for (const auto& ball : panel_.balls) {
      // A ball that is huge beside all else, such as a floor, does not make all else small.
      if (ball.radius < 20) keep(ball.center, ball.radius);
    }
    for (const auto& line : panel_.lines) {
      for (const Point3& point : line.points) keep(point);
    }
    for (const auto& dot : panel_.dots) keep(dot.at);
    if (points_.empty()) return;
    // One point alone has no size that a camera could fit.
    const Vec3d first = points_.front();
    if (std::ranges::all_of(points_, [&](const Vec3d& p) { return p == first; })) {
      const double size = std::max(1e-3, 0.1 * glm::length(first));
      points_.push_back(first + Vec3d(size, size, 0));
      points_.push_back(first - Vec3d(size, size, 0));
    }
  }

  std::optional<Canvas::Point> place(const Vec3d& p) const {
    const auto at = camera_.project(p);
    if (!at || !std::isfinite(at->x) || !std::isfinite(at->y)) return std::nullopt;
    const Canvas::Point point{frame_.x + (at->x + 1) / 2 * frame_.width, frame_.y + (1 - at->y) / 2 * frame_.height};
    // Clamped, because what lies far beside the picture would overflow what draws it.
    return Canvas::Point{std::clamp(point.x, frame_.x - 4000, frame_.x + 8000),
                         std::clamp(point.y, frame_.y - 4000, frame_.y + 8000)};
  }
  double depth_of(const Vec3d& p) const { return glm::dot(p, camera_.axes.z); }

  void add(const Vec3d& middle, std::function<void()> draw) { shapes_.push_back({depth_of(middle), std::move(draw)}); }

  void polygon(std::initializer_list<Vec3d> corners, const Rgb& fill, double opacity, const Rgb& edge, double width) {
    std::vector<Canvas::Point> places;
    for (const Vec3d& corner : corners) {
      const auto at = place(corner);
      if (!at) return;
      places.push_back(*at);
    }
    if (opacity > 0) canvas_.polygon(places, fill, opacity);
    for (std::size_t i = 0; i < places.size(); ++i)
      canvas_.line(places[i], places[(i + 1) % places.size()], width, edge);
  }

  void add_triangles() {
    for (const auto& triangle : panel_.triangles) {
      if (!std::ranges::all_of(triangle.corners, is_finite)) continue;
      const Vec3d a = vector_of(triangle.corners[0]), b = vector_of(triangle.corners[1]),
                  c = vector_of(triangle.corners[2]);
      const Vec3d normal = glm::cross(b - a, c - a);
      const double length = glm::length(normal),
                   facing = length > 0 ? std::fabs(glm::dot(normal / length, camera_.axes.z)) : 1;
      const bool is_missed = triangle.role == Role::missed;
      Rgb fill = is_missed ? color_of(Role::missed) : Rgb{0.80, 0.83, 0.88};
      for (double& component : fill) component *= 0.72 + 0.28 * facing;
      add((a + b + c) / 3.0, [=, this] {
        polygon({a, b, c}, fill, 0.85, is_missed ? color_of(Role::missed) : faint_ink, is_missed ? 3 : 1);
      });
      if (!is_missed && !triangle.label.empty()) label_triangle(triangle, triangle.label);
    }
  }
  void label_triangle(const SpacePanel::Triangle& triangle, const std::string& label) {
    Vec3d middle(0);
    for (const Point3& corner : triangle.corners) {
      if (!is_finite(corner)) return;
      middle += vector_of(corner) / 3.0;
    }
    if (triangle.role == Role::missed) {
      if (const auto at = place(middle)) this->label(*at, label, color_of(Role::missed));
      return;
    }
    add(middle + 1e-3 * camera_.axes.z, [=, this] {
      if (const auto at = place(middle)) canvas_.text(*at, label, {17, soft_ink, Canvas::Align::center});
    });
  }

  int most_order() const {
    int most = 0;
    for (const auto& box : panel_.boxes) most = std::max(most, box.order);
    for (const auto& ball : panel_.balls) most = std::max(most, ball.order);
    return most;
  }
  Rgb order_color(int order) const { return ramp(static_cast<double>(order) / std::max(1, most_order())); }

  void add_boxes() {
    for (const auto& box : panel_.boxes) {
      if (!is_finite(box.lo) || !is_finite(box.hi)) continue;
      const Vec3d lo = vector_of(box.lo), hi = vector_of(box.hi);
      const auto corner = [=](int i) { return Vec3d(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z); };
      const bool is_visited = box.order >= 0;
      const Rgb color = is_visited ? order_color(box.order) : faint_ink;
      constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
      for (const auto& face : faces) {
        const Vec3d a = corner(face[0]), b = corner(face[1]), c = corner(face[2]), d = corner(face[3]);
        add((a + b + c + d) / 4.0, [=, this] {
          polygon({a, b, c, d}, color, is_visited ? 0.07 : 0, color, is_visited ? 2 : 0.8);
        });
      }
      if (!box.label.empty()) {
        // In front of its own faces, so that numbers are read.
        add(0.5 * (lo + hi) + 0.51 * glm::length(hi - lo) * camera_.axes.z, [=, this, label = box.label] {
          if (const auto at = place(0.5 * (lo + hi)))
            canvas_.text(*at, label, {18, color, Canvas::Align::center, true});
        });
      }
    }
  }

  void circle(const Vec3d& center, const Vec3d& x, const Vec3d& y, const Rgb& color, double width) {
    constexpr int steps = 72;
    std::optional<Canvas::Point> before;
    for (int i = 0; i <= steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps;
      const auto at = place(center + std::cos(angle) * x + std::sin(angle) * y);
      if (at && before) canvas_.line(*before, *at, width, color);
      before = at;
    }
  }

  void add_balls() {
    for (const auto& ball : panel_.balls) {
      if (!is_finite(ball.center) || !std::isfinite(ball.radius)) continue;
      const Vec3d center = vector_of(ball.center);
      const double radius = ball.radius;
      const bool is_cell = ball.role == Role::cell;
      const Rgb color = !is_cell ? soft_ink : ball.order >= 0 ? order_color(ball.order) : faint_ink;
      add(center, [=, this, label = ball.label] {
        const auto at = place(center), side = place(center + radius * camera_.axes.x);
        if (!is_cell && at && side)
          canvas_.disc(*at, std::hypot(side->x - at->x, side->y - at->y), {0.86, 0.88, 0.92}, 0.8);
        circle(center, radius * camera_.axes.x, radius * camera_.axes.y, color, 2);
        circle(center, Vec3d(radius, 0, 0), Vec3d(0, 0, radius), color, 0.8);
        circle(center, Vec3d(0, radius, 0), Vec3d(0, 0, radius), color, 0.8);
        if (at && !label.empty()) canvas_.text(*at, label, {18, color, Canvas::Align::center, true});
      });
    }
  }

  void draw_line(const SpacePanel::Line& line) {
    const bool is_main = line.role != Role::cell && line.role != Role::note;
    const Rgb color = color_of(line.role);
    std::optional<Canvas::Point> before, last;
    double angle = 0;
    for (const Point3& point : line.points) {
      const auto at = is_finite(point) ? place(vector_of(point)) : std::nullopt;
      if (at && before) {
        canvas_.line(*before, *at, is_main ? 3 : 1.2, color);
        angle = std::atan2(at->y - before->y, at->x - before->x);
        last = at;
      }
      before = at;
    }
    if (line.is_arrow && last) canvas_.arrow_head(*last, angle, 18, color);
    if (!line.label.empty() && !line.points.empty() && is_finite(line.points.front())) {
      if (const auto at = place(vector_of(line.points.front()))) label(*at, line.label, color);
    }
  }
  void draw_dot(const SpacePanel::Dot& dot) {
    if (!is_finite(dot.at)) return;
    const auto at = place(vector_of(dot.at));
    if (!at) return;
    if (dot.role == Role::wrong) {
      canvas_.ring(*at, 11, 4, color_of(dot.role));  // told from a right one by its shape as well
    } else {
      canvas_.disc(*at, 8, color_of(dot.role));
    }
    if (!dot.label.empty()) label(*at, dot.label, color_of(dot.role));
  }
  /// Beside a place, below the labels that are there already.
  void label(Canvas::Point at, const std::string& text, const Rgb& color) {
    at.x += 16, at.y -= 16;
    const auto is_near = [&](const Canvas::Point& other) {
      return std::fabs(other.x - at.x) < 130 && std::fabs(other.y - at.y) < 24;
    };
    while (std::ranges::any_of(labels_, is_near)) at.y += 26;
    at.x = std::clamp(at.x, frame_.x + 4, frame_.x + frame_.width - 110);
    at.y = std::clamp(at.y, frame_.y + 12, frame_.y + frame_.height - 12);
    labels_.push_back(at);
    const Canvas::TextStyle style{20, color, Canvas::Align::left, true};
    canvas_.rectangle({at.x - 4, at.y - 13}, canvas_.text_width(text, style) + 8, 26, {1, 1, 1}, 0.85);
    canvas_.text(at, text, style);
  }

  Canvas& canvas_;
  const PanelFrame& frame_;
  const SpacePanel& panel_;
  SpaceCamera camera_;
  std::vector<Vec3d> points_;
  std::vector<Shape> shapes_;
  std::vector<Canvas::Point> labels_;
  bool is_whole_ = true;
};

}  // namespace

Rgb color_of(Role role) {
  switch (role) {
    case Role::scene:
      return soft_ink;
    case Role::cell:
      return gray;
    case Role::ray:
      return ink;
    case Role::right:
      return blue;
    case Role::wrong:
      return vermillion;
    case Role::missed:
      return {0.80, 0.10, 0.35};
    case Role::note:
      break;
  }
  return faint_ink;
}

const char* name_of(Role role) {
  switch (role) {
    case Role::scene:
      return "scene";
    case Role::cell:
      return "cells, numbered as visited";
    case Role::ray:
      return "ray";
    case Role::right:
      return "expected";
    case Role::wrong:
      return "got";
    case Role::missed:
      return "overlooked";
    case Role::note:
      break;
  }
  return "for help";
}

bool draw_space(Canvas& canvas, const PanelFrame& frame, const SpacePanel& panel) {
  return SpaceDrawing(canvas, frame, panel).draw();
}

}  // namespace sightline::viz
