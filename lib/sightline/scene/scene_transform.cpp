#include "sightline/scene/scene_transform.h"

#include <array>
#include <cmath>

#include "sightline/io/srgb.h"
#include "sightline/scene/scene_members.h"
#include "sightline/scene/solid_frame.h"

namespace sightline {
namespace {

Transform matrix_of(const JsonValue& json) {
  if (json.size() != 12 && json.size() != 16) json.fail("12 or 16 numbers", std::to_string(json.size()));
  Affine matrix;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const double value = json[i].real();
    if (i < 12) {
      matrix.rows[i / 4][i % 4] = value;
    } else if (value != (i == 15 ? 1 : 0)) {
      json[i].fail(i == 15 ? "1: the fourth row is 0 0 0 1" : "0: the fourth row is 0 0 0 1");
    }
  }
  return Transform::of(matrix);
}

Transform look_at_of(const JsonValue& json) {
  check_members(json, "look_at");
  const Vec3d eye = vector_of(json["eye"]), target = vector_of(json["target"]);
  const auto up_member = json.find("up");
  const Vec3d up = up_member ? vector_of(*up_member) : Vec3d(0, 1, 0);
  // Lengths of 1 at most, so that no square over- or underflows.
  const auto sized = [](const Vec3d& v) { return max_norm(v) > 0 ? v / max_norm(v) : v; };
  const Vec3d back = sized(eye - target);
  const Vec3d right = sized(glm::cross(sized(up), back));
  if (!is_finite(back) || back == Vec3d(0)) json.fail("a target other than the eye");
  if (!is_finite(right) || right == Vec3d(0)) json.fail("an \"up\" that is not the direction of sight");
  const Vec3d z = glm::normalize(back), x = glm::normalize(right), y = glm::cross(z, x);
  Affine matrix;
  for (int i = 0; i < 3; ++i) matrix.rows[static_cast<std::size_t>(i)] = {x[i], y[i], z[i], eye[i]};
  return Transform::of(matrix);
}

Transform step_of(const JsonValue& json) {
  check_members(json, "step");
  constexpr auto names = std::to_array<std::string_view>({"translate", "rotate", "scale", "matrix", "look_at"});
  const std::string name(one_member(json, names));
  const JsonValue value = json[name.c_str()];
  if (name == "translate") return Transform::translation(vector_of(value));
  if (name == "scale") return Transform::scaling(value.is_array() ? vector_of(value) : Vec3d(value.real()));
  if (name == "matrix") return matrix_of(value);
  if (name == "look_at") return look_at_of(value);
  check_members(value, "rotation");
  return Transform::rotation(vector_of(value["axis"]), value["degrees"].real());
}

}  // namespace

Transform transform_of(const JsonValue& json, const std::function<std::string()>& node) {
  Transform product;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const auto refuse = [&](const std::string& found) {
      json[i].fail("a transform of " + node() + " that can be undone", found);
    };
    try {
      product = product * step_of(json[i]);
    } catch (const std::invalid_argument& error) {
      refuse(error.what());
    }
    if (!is_finite(product.matrix()) || !is_finite(product.inverse())) refuse("one beyond the range of double");
    if (determinant_sign(product.matrix()) == 0) refuse("one that is singular in double");
  }
  return product;
}

Color color_of(const JsonValue& json) {
  if (!json.is_text()) {
    const Vec3d color = vector_of(json);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(color[static_cast<int>(i)] >= 0) || json[i].number() < 0) json[i].fail("a number of at least 0");
    }
    return Color(color);
  }
  const std::string& text = json.text();
  if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) {
    json.fail("a color such as \"#ff8000\" or [1, 0.2, 0]");
  }
  Color color;
  for (int i = 0; i < 3; ++i) {
    const auto byte = std::stoi(text.substr(static_cast<std::size_t>(1 + 2 * i), 2), nullptr, 16);
    color[i] = decode_srgb(static_cast<float>(byte) / 255);
  }
  return color;
}

}  // namespace sightline
