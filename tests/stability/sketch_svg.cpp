#include "tests/stability/sketch_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/stability/label_layout.h"
#include "tests/stability/text.h"

namespace sightline::stability {
namespace {

using glm::dvec2;
using hard::Role, hard::Sketch;

constexpr double frame_width = 480, margin = 40, least_height = 150, largest_height = 400;
constexpr std::string_view paper = "#ffffff", ink = "#1c2230";

template <class... Each>
struct Overloaded : Each... {
  using Each::operator()...;
};

bool is_finite(const dvec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Hundredths of a pixel, whatever the locale.
std::string number(double value) {
  const auto hundredths = static_cast<long long>(std::lround(100 * std::clamp(value, -1e6, 1e6)));
  const long long magnitude = std::abs(hundredths);
  std::string text = (hundredths < 0 ? "-" : "") + std::to_string(magnitude / 100);
  if (magnitude % 100 != 0) text += (magnitude % 100 < 10 ? ".0" : ".") + std::to_string(magnitude % 100);
  return text;
}
std::string pair(const dvec2& p) { return number(p.x) + ' ' + number(p.y); }
std::string attribute(std::string_view name, const std::string& value) {
  return ' ' + std::string(name) + "=\"" + value + '"';
}

// ---- From the case's coordinates to pixels

struct Bounds {
  dvec2 lo{HUGE_VAL}, hi{-HUGE_VAL};
  void add(const dvec2& p) {
    if (!is_finite(p)) return;
    lo = min(lo, p);
    hi = max(hi, p);
  }
  static dvec2 min(const dvec2& a, const dvec2& b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
  static dvec2 max(const dvec2& a, const dvec2& b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }
};

Bounds bounds_of(const Sketch& sketch) {
  Bounds bounds;
  for (const Sketch::Part& part : sketch.parts) {
    std::visit(Overloaded{[&](const Sketch::Path& path) {
                            for (const dvec2& p : path.points) bounds.add(p);
                          },
                          [&](const Sketch::Circle& circle) {
                            bounds.add(circle.center - std::abs(circle.radius));
                            bounds.add(circle.center + std::abs(circle.radius));
                          },
                          [&](const Sketch::Dot& dot) { bounds.add(dot.at); },
                          [&](const Sketch::Label& label) { bounds.add(label.at); }},
               part);
  }
  if (!(bounds.lo.x <= bounds.hi.x)) return {dvec2(-1), dvec2(1)};
  return bounds;
}

/// Uniform, y up becomes y down, everything in the frame.
class Scale {
 public:
  explicit Scale(const Bounds& bounds) : middle_(0.5 * bounds.lo + 0.5 * bounds.hi) {
    const dvec2 size = bounds.hi - bounds.lo;
    const double across = frame_width - 2 * margin, up = largest_height - 2 * margin;
    factor_ = std::min(size.x > 0 ? across / size.x : HUGE_VAL, size.y > 0 ? up / size.y : HUGE_VAL);
    if (!std::isfinite(factor_)) factor_ = 1;  // a single point
    frame_ = dvec2(frame_width, std::clamp(factor_ * size.y + 2 * margin, least_height, largest_height));
  }
  dvec2 operator()(const dvec2& p) const {
    return {0.5 * frame_.x + factor_ * (p.x - middle_.x), 0.5 * frame_.y - factor_ * (p.y - middle_.y)};
  }
  double operator()(double length) const { return factor_ * length; }
  const dvec2& frame() const { return frame_; }

 private:
  dvec2 middle_, frame_{0};
  double factor_ = 1;
};

// ---- Parts

/// The group's color is that of all in it.
std::string group_of(Role role) {
  const RoleLook& look = look_of(role);
  return "<g" + attribute("class", std::string(look.name)) + attribute("color", std::string(look.color)) + '>';
}

std::string stroke_of(Role role) {
  const RoleLook& look = look_of(role);
  std::string text = " fill=\"none\" stroke=\"currentColor\"" + attribute("stroke-width", number(look.width));
  if (!look.dashes.empty()) text += attribute("stroke-dasharray", std::string(look.dashes));
  return text + " stroke-linejoin=\"round\"";
}

std::string line_of(const std::vector<dvec2>& points, Role role, bool is_closed) {
  std::string text;
  for (const dvec2& p : points) text += (text.empty() ? "M" : " L") + pair(p);
  return "<path" + attribute("d", text + (is_closed ? " Z" : "")) + stroke_of(role) + "/>";
}

std::string arrow_at(const dvec2& tip, const dvec2& from) {
  const double length = glm::distance(tip, from);
  if (!(length > 0)) return "";
  const dvec2 along = (tip - from) / length, across(-along.y, along.x);
  const dvec2 back = tip - 11.0 * along;
  return "<path" +
         attribute("d", "M" + pair(tip) + " L" + pair(back + 4.5 * across) + " L" + pair(back - 4.5 * across) + " Z") +
         " fill=\"currentColor\"/>";
}

/// Marks differ by role: disk, cross, ring, square.
std::string mark_at(const dvec2& p, Role role) {
  const auto circle = [&](double radius, const std::string& rest) {
    return "<circle" + attribute("cx", number(p.x)) + attribute("cy", number(p.y)) + attribute("r", number(radius)) +
           rest + "/>";
  };
  const std::string outline = " fill=\"none\" stroke=\"currentColor\" stroke-width=\"2.5\"";
  switch (role) {
    case Role::truth:
      return circle(5, " fill=\"currentColor\"");
    case Role::ray:
      return circle(4.5, outline);
    case Role::aid:
      return circle(2.5, " fill=\"currentColor\"");
    case Role::shape:
      return "<rect" + attribute("x", number(p.x - 4)) + attribute("y", number(p.y - 4)) +
             " width=\"8\" height=\"8\" fill=\"currentColor\"/>";
    case Role::naive:
      break;
  }
  const std::string cross =
      "M" + pair(p - 5.0) + " L" + pair(p + 5.0) + " M" + pair({p.x - 5, p.y + 5}) + " L" + pair({p.x + 5, p.y - 5});
  return "<path" + attribute("d", cross) + outline + "/>";
}

class Drawing {
 public:
  explicit Drawing(const Sketch& sketch) : scale_(bounds_of(sketch)), layout_(scale_.frame()) {
    for (const Sketch::Part& part : sketch.parts) std::visit([&](const auto& one) { draw(one); }, part);
    for (const Sketch::Part& part : sketch.parts) {
      if (const auto* label = std::get_if<Sketch::Label>(&part)) write(*label);
    }
  }
  const std::string& text() const { return text_; }
  const dvec2& frame() const { return scale_.frame(); }
  /// Whether there is a line, and whether there is a dot.
  std::pair<bool, bool> uses(Role role) const { return uses_[static_cast<std::size_t>(role)]; }

 private:
  void draw(const Sketch::Path& path) {
    std::vector<dvec2> points;
    for (const dvec2& p : path.points) {
      if (is_finite(p)) points.push_back(scale_(p));
    }
    if (points.size() < 2) return;
    add(path.role, line_of(points, path.role, path.is_closed));
    if (path.role == Role::ray && !path.is_closed) text_ += arrow_at(points.back(), points[points.size() - 2]);
    text_ += "</g>\n";
    if (path.is_closed) points.push_back(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) avoid_line(points[i - 1], points[i]);
  }
  void draw(const Sketch::Circle& circle) {
    if (!is_finite(circle.center) || !std::isfinite(circle.radius)) return;
    const dvec2 center = scale_(circle.center);
    const double radius = std::max(0.5, scale_(std::abs(circle.radius)));
    add(circle.role, "<circle" + attribute("cx", number(center.x)) + attribute("cy", number(center.y)) +
                         attribute("r", number(radius)) + stroke_of(circle.role) + "/></g>\n");
    constexpr int count = 180;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      layout_.avoid(center + radius * dvec2(std::cos(angle), std::sin(angle)), 60);
    }
  }
  void draw(const Sketch::Dot& dot) {
    if (!is_finite(dot.at)) return;
    const dvec2 at = scale_(dot.at);
    add(dot.role, mark_at(at, dot.role) + "</g>\n", true);
    for (const double x : {-4, 0, 4}) {
      for (const double y : {-4, 0, 4}) layout_.avoid(at + dvec2(x, y), 300);
    }
  }
  void draw(const Sketch::Label&) {}

  void write(const Sketch::Label& label) {
    if (!is_finite(label.at) || label.text.empty()) return;
    const PlacedLabel placed = layout_.place(scale_(label.at), label.text);
    constexpr std::array<std::string_view, 3> anchors{"start", "middle", "end"};
    const double x = std::lerp(placed.box.lo.x, placed.box.hi.x, placed.align);
    text_ += group_of(label.role);
    for (std::size_t i = 0; i < placed.lines.size(); ++i) {
      const double y = placed.box.lo.y + label_leading * static_cast<double>(i) + 0.76 * label_leading;
      text_ += "<text class=\"halo\"" + attribute("x", number(x)) + attribute("y", number(y)) +
               attribute("text-anchor", std::string(anchors[std::size_t(std::lround(2 * placed.align))])) +
               " fill=\"currentColor\" stroke=\"" + std::string(paper) +
               "\" stroke-width=\"4\" paint-order=\"stroke\" stroke-linejoin=\"round\">" + escaped(placed.lines[i]) +
               "</text>";
    }
    text_ += "</g>\n";
  }

  void add(Role role, const std::string& text, bool is_dot = false) {
    auto& [has_line, has_mark] = uses_[static_cast<std::size_t>(role)];
    (is_dot ? has_mark : has_line) = true;
    text_ += group_of(role) + text;
  }
  void avoid_line(const dvec2& from, const dvec2& to) {
    const int steps = std::clamp(static_cast<int>(glm::distance(from, to) / 4), 1, 400);
    for (int i = 0; i <= steps; ++i) layout_.avoid(glm::mix(from, to, double(i) / steps), 60);
  }

  Scale scale_;
  LabelLayout layout_;
  std::string text_;
  std::array<std::pair<bool, bool>, 5> uses_ = {};
};

std::string legend_of(const Drawing& drawing, double& y) {
  std::string text = "<g class=\"legend\">\n";
  double x = 12;
  y += 18;
  for (const Role role : {Role::shape, Role::ray, Role::truth, Role::naive, Role::aid}) {
    const auto [has_line, has_mark] = drawing.uses(role);
    if (!has_line && !has_mark) continue;
    const RoleLook& look = look_of(role);
    const double sample = (has_line ? 34 : 0) + (has_mark ? 16 : 0), width = sample + text_width(look.title, 13) + 16;
    if (x + width > frame_width) x = 12, y += 22;
    text += group_of(role);
    if (has_line) text += line_of({{x, y - 4}, {x + 30, y - 4}}, role, false);
    if (has_mark) text += mark_at({x + sample - 9, y - 4}, role);
    text += "<text" + attribute("x", number(x + sample)) + attribute("y", number(y)) +
            " font-size=\"13\" fill=\"currentColor\">" + escaped(look.title) + "</text></g>\n";
    x += width;
  }
  y += 10;
  return text + "</g>\n";
}

std::string caption_of(const std::string& caption, double& y) {
  std::string text = "<g class=\"caption\"" + attribute("color", std::string(ink)) + ">\n";
  const double per_character =
      text_width(caption, 13) / static_cast<double>(std::max<std::size_t>(1, width_of(caption)));
  for (const std::string& line :
       wrapped(caption, static_cast<std::size_t>((frame_width - 24) / std::max(1.0, per_character)))) {
    y += 18;
    text += "<text x=\"12\"" + attribute("y", number(y)) + " font-size=\"13\" fill=\"currentColor\">" + escaped(line) +
            "</text>\n";
  }
  y += 10;
  return text + "</g>\n";
}

}  // namespace

const RoleLook& look_of(Role role) {
  static constexpr std::array<RoleLook, 5> looks{{
      {Role::shape, "shape", "shape", "#1c2230", 2.5, ""},
      {Role::ray, "ray", "ray", "#0072b2", 1.8, ""},
      {Role::truth, "truth", "true", "#00795a", 3.2, "9 3"},
      {Role::naive, "naive", "naive code", "#c04a00", 2.2, "4 4"},
      {Role::aid, "aid", "for orientation", "#5d6677", 1.2, "1.5 4"},
  }};
  return looks[static_cast<std::size_t>(role)];
}

std::string svg_of(const Sketch& sketch, bool has_caption) {
  const Drawing drawing(sketch);
  double y = drawing.frame().y;
  std::string below = legend_of(drawing, y);
  if (has_caption) below += caption_of(sketch.caption, y);
  const std::string width = number(frame_width), height = number(y);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"sketch\" role=\"img\"" +
         attribute("viewBox", "0 0 " + width + ' ' + height) + attribute("width", width) + attribute("height", height) +
         " font-family=\"system-ui, 'DejaVu Sans', sans-serif\" font-size=\"" + number(label_size) + "\">\n<title>" +
         escaped(sketch.caption) + "</title>\n" + "<rect class=\"paper\"" + attribute("width", width) +
         attribute("height", height) + " fill=\"" + std::string(paper) + "\"/>\n" + drawing.text() + below + "</svg>\n";
}

}  // namespace sightline::stability
