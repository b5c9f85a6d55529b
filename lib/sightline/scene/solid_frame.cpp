#include "sightline/scene/solid_frame.h"

#include "sightline/math/transform.h"

namespace sightline {
namespace {

Vec3d scale_of(const JsonValue& json) {
  const Vec3d scale = json.is_array() ? vector_of(json) : Vec3d(json.real());
  if (!is_finite(1.0 / scale)) json.fail("a scale other than 0");
  return scale;
}

}  // namespace

Vec3d vector_of(const JsonValue& json) {
  if (json.size() != 3) json.fail("3 numbers");
  const auto at = [&](std::size_t i) { return json[i].real(); };
  return {at(0), at(1), at(2)};
}

Frame frame_of(const JsonValue& json) {
  Transform placed;
  if (const auto translate = json.find("translate")) placed = Transform::translation(vector_of(*translate));
  if (const auto rotate = json.find("rotate")) {
    const Vec3d axis = vector_of((*rotate)["axis"]);
    if (axis == Vec3d(0)) (*rotate)["axis"].fail("an axis other than 0");
    placed = placed * Transform::rotation(axis, (*rotate)["degrees"].real());
  }
  if (const auto size = json.find("scale")) placed = placed * Transform::scaling(scale_of(*size));
  return placed.inverse();
}

}  // namespace sightline
