#include "bench/solids/povray_text.h"

#include <charconv>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>
#include <variant>

#include "bench/solids/picture.h"

namespace sightline::bench {
namespace {

std::string text(double value) {
  char buffer[40];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}
std::string text(const Vec3d& v) { return '<' + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + '>'; }

/// Where the axes go, then the origin.
std::string matrix_text(const glm::dmat3& axes, const Vec3d& origin) {
  std::string out = " matrix <";
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 3; ++i) out += text(axes[axis][i]) + ", ";
  }
  return out + text(origin.x) + ", " + text(origin.y) + ", " + text(origin.z) + '>';
}

/// From the shape's own coordinates to the world.
std::string text(const Frame& frame) {
  glm::dmat3 axes;
  Vec3d offset;
  for (int i = 0; i < 3; ++i) {
    const auto& row = frame.rows[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 3; ++axis) axes[axis][i] = row[static_cast<std::size_t>(axis)];
    offset[i] = row[3];
  }
  const glm::dmat3 back = glm::inverse(axes);
  return matrix_text(back, -(back * offset));
}

/// Turns y to the axis.
glm::dmat3 turn_to(const Vec3d& axis) {
  const Vec3d y = glm::normalize(axis);
  const Vec3d x = glm::normalize(glm::cross(y, std::fabs(y.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 0, 1)));
  return {x, y, glm::cross(x, y)};
}

struct ShapeText {
  std::string operator()(const solid::HalfSpace& half) const {
    const double length = glm::length(half.normal);
    return "plane { " + text(half.normal) + ", " + text(half.offset / length);
  }
  std::string operator()(const solid::Sphere& sphere) const {
    return "sphere { " + text(sphere.center) + ", " + text(sphere.radius);
  }
  std::string operator()(const solid::Box& box) const { return "box { " + text(box.lo) + ", " + text(box.hi); }
  std::string operator()(const solid::Cylinder& cylinder) const {
    return "cylinder { " + text(cylinder.base) + ", " + text(cylinder.top) + ", " + text(cylinder.radius);
  }
  std::string operator()(const solid::Cone& cone) const {
    return "cone { " + text(cone.apex) + ", 0, " + text(cone.base) + ", " + text(cone.radius);
  }
  std::string operator()(const solid::Torus& torus) const {
    return "torus { " + text(torus.major) + ", " + text(torus.minor) + matrix_text(turn_to(torus.axis), torus.center);
  }
  std::string operator()(const solid::Quadric& quadric) const {
    const auto& c = quadric.coefficients;
    return "quadric { " + text(Vec3d(c[0], c[1], c[2])) + ", " + text(Vec3d(c[3], c[4], c[5])) + ", " +
           text(Vec3d(c[6], c[7], c[8])) + ", " + text(c[9]);
  }
  std::string operator()(const std::shared_ptr<const ClosedMesh>&) const {
    throw std::invalid_argument("expected solids that POV-Ray has as well, found a closed mesh");
  }
};

std::string_view name_of(Operation operation) {
  switch (operation) {
    case Operation::unite:
      return "union";
    case Operation::intersect:
      return "intersection";
    case Operation::subtract:
      return "difference";
    case Operation::differ:
      break;
  }
  throw std::invalid_argument("expected operations that POV-Ray has as well, found a symmetric difference");
}

std::string text(const SolidTree& tree, const std::string& indent, const std::string& end = {}) {
  switch (tree.kind) {
    case SolidTree::Kind::primitive:
      return indent + std::visit(ShapeText(), tree.shape) + (tree.frame.is_identity() ? "" : text(tree.frame)) + end +
             " }\n";
    case SolidTree::Kind::complement:
      return text(tree.args.at(0), indent, " inverse" + end);
    case SolidTree::Kind::operation:
      break;
  }
  if (tree.args.size() == 1) return text(tree.args[0], indent, end);
  std::string out = indent + std::string(name_of(tree.operation)) + " {\n";
  for (const SolidTree& arg : tree.args) out += text(arg, indent + "  ");
  return out + (end.empty() ? "" : indent + ' ' + end + '\n') + indent + "}\n";
}

}  // namespace

std::string povray_text(const Vec3d& v) { return text(v); }

std::string povray_text(const Camera& camera) {
  return "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera {\n  perspective location " + text(camera.eye) +
         " direction " + text(camera.forward) + "\n  right " + text(2.0 * camera.right) + " up " +
         text(2.0 * camera.up) + "\n}\n";
}

std::string povray_text(const SolidTree& solid, const std::string& look) { return text(solid, "", look); }

std::string povray_text(const SolidScene& scene) {
  std::string out = povray_text(scene.camera) + "light_source { " + text(scene.light) + ", rgb 1 }\n";
  const std::string look = " pigment { rgb 1 } finish { ambient " + text(ambient) + " diffuse " + text(diffuse) + " }";
  for (const SolidTree& tree : scene.solids) out += povray_text(tree, look);
  return out;
}

}  // namespace sightline::bench
