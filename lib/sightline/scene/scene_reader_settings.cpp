#include <array>
#include <limits>

#include "sightline/io/image_file.h"
#include "sightline/scene/scene_members.h"
#include "sightline/scene/scene_reader.h"
#include "sightline/scene/set_member.h"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Surroundings SceneReader::surroundings_of(const JsonValue& json) {
  Surroundings surroundings;
  if (!json.is_object()) {
    surroundings.background = color_of(json);
    return surroundings;
  }
  check_members(json, "background");
  constexpr auto kinds = std::to_array<std::string_view>({"color", "zenith", "image"});
  const std::string kind(one_member(json, kinds));
  const auto belongs = [&](const char* member, const char* owner) {
    if (const auto found = json.find(member); found && kind != owner) {
      found->fail(std::string("\"") + owner + "\" beside it", "\"" + kind + "\"");
    }
  };
  for (const char* member : {"horizon", "ground"}) belongs(member, "zenith");
  belongs("rotation", "image");
  set_member(surroundings.intensity, json, "intensity", 0, infinity);
  set_member(surroundings.lights, json, "lights");
  if (kind == "color") {
    surroundings.background = color_of(json["color"]);
  } else if (kind == "zenith") {
    SkyGradient sky{color_of(json["zenith"]), color_of(json["horizon"]), {}};
    sky.ground = sky.horizon;
    set_member(sky.ground, json, "ground");
    surroundings.background = sky;
  } else {
    SkyImage sky{file_of(json["image"])};
    read_image(sky.image);  // says what is wrong with it
    set_member(sky.rotation, json, "rotation", -360, 360);
    surroundings.background = sky;
  }
  return surroundings;
}

RenderHints SceneReader::render_hints_of(const JsonValue& json) {
  check_members(json, "render");
  RenderHints hints;
  set_member(hints.samples, json, "samples", 1, most_samples);
  set_member(hints.depth, json, "depth", 0, most_bounces);
  set_member(hints.interreflection, json, "interreflection");
  set_member(hints.cut_off, json, "cut_off", 0, 1);
  set_member(hints.shadow_error, json, "shadow_error", 0, 1);
  return hints;
}

void SceneReader::read_settings(const JsonValue& json) {
  if (const auto background = json.find("background")) scene_.surroundings = surroundings_of(*background);
  if (const auto ambient = json.find("ambient")) {
    check_members(*ambient, "ambient");
    scene_.ambient = {color_of((*ambient)["color"]), 0};
    set_member(scene_.ambient.occlusion_distance, *ambient, "occlusion_distance", 0, infinity);
  }
  if (const auto fog = json.find("fog")) {
    check_members(*fog, "fog");
    scene_.fog = {(*fog)["density"].real_within(0, infinity), color_of((*fog)["color"])};
  }
  if (const auto render = json.find("render")) scene_.render = render_hints_of(*render);
}

SceneCamera SceneReader::camera_of(const JsonValue& json) {
  check_members(json, "camera");
  SceneCamera camera;
  set_member(camera.field_of_view, json, "field_of_view", 1, 179);
  set_member(camera.aperture, json, "aperture", 0, infinity);
  set_member(camera.focus_distance, json, "focus_distance", 0, infinity);
  if (camera.aperture > 0 && !(camera.focus_distance > 0)) {
    json.fail("a \"focus_distance\" above 0 beside \"aperture\"", json.find("focus_distance") ? "0" : "none");
  }
  if (const auto shutter = json.find("shutter")) {
    if (shutter->size() != 2) shutter->fail("2 numbers", std::to_string(shutter->size()));
    for (std::size_t i = 0; i < 2; ++i) camera.shutter[i] = (*shutter)[i].real();
    if (!(camera.shutter[1] >= camera.shutter[0])) {
      (*shutter)[1].fail("a time at which it closes, not before it opens");
    }
  }
  return camera;
}

}  // namespace sightline
