#pragma once
/// A drawing of a hard case, in the plane: what shows best why it is hard.

#include <glm/vec2.hpp>
#include <string>
#include <variant>
#include <vector>

namespace sightline::hard {

/// What a part of a drawing stands for, which gives it its color and its entry in the legend.
enum class Role { shape, ray, truth, naive, aid };

/// Coordinates are the case's own: x to the right, y up. A drawing is scaled to its parts, the same in x and y.
struct Sketch {
  struct Path {
    std::vector<glm::dvec2> points;
    Role role = Role::shape;
    bool is_closed = false;
  };
  struct Circle {
    glm::dvec2 center{0};
    double radius = 1;
    Role role = Role::shape;
  };
  struct Dot {
    glm::dvec2 at{0};
    Role role = Role::truth;
  };
  struct Label {
    glm::dvec2 at{0};
    std::string text;
    Role role = Role::aid;
  };
  using Part = std::variant<Path, Circle, Dot, Label>;

  std::string caption;  ///< A sentence: what is drawn, and in what scale where that is not true to size.
  std::vector<Part> parts;

  Sketch& line(const glm::dvec2& from, const glm::dvec2& to, Role role) {
    parts.push_back(Path{{from, to}, role, false});
    return *this;
  }
  Sketch& path(std::vector<glm::dvec2> points, Role role = Role::shape) {
    parts.push_back(Path{std::move(points), role, false});
    return *this;
  }
  Sketch& polygon(std::vector<glm::dvec2> points, Role role = Role::shape) {
    parts.push_back(Path{std::move(points), role, true});
    return *this;
  }
  Sketch& rectangle(const glm::dvec2& lo, const glm::dvec2& hi, Role role = Role::shape) {
    return polygon({lo, {hi.x, lo.y}, hi, {lo.x, hi.y}}, role);
  }
  Sketch& circle(const glm::dvec2& center, double radius, Role role = Role::shape) {
    parts.push_back(Circle{center, radius, role});
    return *this;
  }
  Sketch& dot(const glm::dvec2& at, Role role = Role::truth) {
    parts.push_back(Dot{at, role});
    return *this;
  }
  Sketch& label(const glm::dvec2& at, std::string text, Role role = Role::aid) {
    parts.push_back(Label{at, std::move(text), role});
    return *this;
  }
};

}  // namespace sightline::hard
