#include "sightline/scene/solid_frame.h"

#include <array>
#include <cmath>
#include <numbers>

namespace sightline {
namespace {

using Matrix = std::array<Vec3d, 3>;  ///< By rows.

struct Turn {
  double cosine, sine;
};

/// Exact for quarter turns.
Turn turn_of(double degrees) {
  const double rest = std::remainder(degrees, 360);
  if (rest == 0) return {1, 0};
  if (std::fabs(rest) == 180) return {-1, 0};
  if (std::fabs(rest) == 90) return {0, rest > 0 ? 1. : -1.};
  const double angle = rest * (std::numbers::pi / 180);
  return {std::cos(angle), std::sin(angle)};
}

/// Rodrigues' formula.
Matrix rotation(const Vec3d& axis, const Turn& turn) {
  const Vec3d a = axis / max_norm(axis);  // which neither over- nor underflows
  const Vec3d unit = a / std::sqrt(glm::dot(a, a));
  const auto [c, s] = turn;
  Matrix rows;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Vec3d& row = rows[static_cast<std::size_t>(i)];
    row[i] = unit[i] * unit[i] + c * (1 - unit[i] * unit[i]);
    row[j] = unit[i] * unit[j] * (1 - c) - unit[k] * s;
    row[k] = unit[i] * unit[k] * (1 - c) + unit[j] * s;
  }
  return rows;
}

Vec3d scale_of(const JsonValue& json) {
  const Vec3d scale = json.is_array() ? vector_of(json) : Vec3d(json.real());
  if (scale.x == 0 || scale.y == 0 || scale.z == 0) json.fail("a scale other than 0");
  return scale;
}

}  // namespace

Vec3d vector_of(const JsonValue& json) {
  if (json.size() != 3) json.fail("3 numbers");
  const auto at = [&](std::size_t i) { return json[i].real(); };
  return {at(0), at(1), at(2)};
}

Frame frame_of(const JsonValue& json) {
  Vec3d move(0), scale(1);
  Matrix turned{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (const auto translate = json.find("translate")) move = vector_of(*translate);
  if (const auto rotate = json.find("rotate")) {
    const Vec3d axis = vector_of((*rotate)["axis"]);
    if (axis == Vec3d(0)) (*rotate)["axis"].fail("an axis other than 0");
    turned = rotation(axis, turn_of((*rotate)["degrees"].real()));
  }
  if (const auto size = json.find("scale")) scale = scale_of(*size);
  Frame frame;
  for (int i = 0; i < 3; ++i) {
    auto& row = frame.rows[static_cast<std::size_t>(i)];
    const Vec3d column(turned[0][i], turned[1][i], turned[2][i]);  // a rotation is undone by its transpose
    const Vec3d axis = column / scale[i];
    row = {axis.x, axis.y, axis.z, 0 - glm::dot(axis, move)};
  }
  return frame;
}

Frame combined(const Frame& outer, const Frame& inner) {
  if (outer.is_identity()) return inner;
  if (inner.is_identity()) return outer;
  Frame frame;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = inner.rows[i];
    for (std::size_t k = 0; k < 4; ++k) {
      frame.rows[i][k] = row[0] * outer.rows[0][k] + row[1] * outer.rows[1][k] + row[2] * outer.rows[2][k];
    }
    frame.rows[i][3] += row[3];
  }
  return frame;
}

}  // namespace sightline
