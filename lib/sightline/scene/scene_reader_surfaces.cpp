#include <array>
#include <limits>
#include <stdexcept>

#include "sightline/io/image_file.h"
#include "sightline/scene/scene_members.h"
#include "sightline/scene/scene_reader.h"
#include "sightline/scene/scene_transform.h"
#include "sightline/texture/texture.h"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void set(double& value, const JsonValue& json, const char* name, double lowest, double highest) {
  if (const auto member = json.find(name)) value = member->real_within(lowest, highest);
}

void set(Color& value, const JsonValue& json, const char* name) {
  if (const auto member = json.find(name)) value = color_of(*member);
}

}  // namespace

TextureSource SceneReader::texture_of(const std::string& name, const JsonValue& json) const {
  check_members(json, "texture");
  TextureSource texture;
  texture.name = name;
  if (const auto is_data = json.find("data")) texture.is_data = is_data->truth();
  constexpr auto kinds = std::to_array<std::string_view>({"procedural", "image"});
  const std::string kind(one_member(json, kinds));
  const JsonValue source = json[kind.c_str()];
  if (kind == "procedural") {
    try {
      make_texture(source.text());
    } catch (const std::invalid_argument& error) {
      source.fail("a texture with its options", error.what());
    }
    texture.source = source.text();
  } else {
    const std::filesystem::path path = file_of(source);
    read_image(path);  // says what is wrong with it
    texture.source = path;
  }
  return texture;
}

Material SceneReader::material_of(const std::string& name, const JsonValue& json) const {
  check_members(json, "material");
  Material material;
  material.name = name;
  set(material.color, json, "color");
  if (const auto texture = json.find("color_texture"))
    material.color_texture = look_up(textures_, *texture, "textures");
  if (const auto map = json.find("normal_map")) material.normal_map = look_up(textures_, *map, "textures");
  set(material.normal_strength, json, "normal_strength", 0, infinity);
  set(material.roughness, json, "roughness", 0, 1);
  set(material.metallic, json, "metallic", 0, 1);
  set(material.transmission, json, "transmission", 0, 1);
  set(material.refractive_index, json, "refractive_index", 1, infinity);
  set(material.absorption, json, "absorption");
  set(material.emission, json, "emission");
  return material;
}

Light SceneReader::light_of(const JsonValue& json) const {
  check_members(json, "light");
  Light light;
  const JsonValue kind = json["kind"];
  const std::string& name = kind.text();
  set(light.color, json, "color");
  set(light.intensity, json, "intensity", 0, infinity);
  const auto belongs = [&](const char* member, const char* owner) {
    if (const auto found = json.find(member); found && name != owner) {
      found->fail(std::string("it at a light of kind \"") + owner + "\"", "one of kind \"" + name + "\"");
    }
  };
  for (const char* member : {"inner_angle", "outer_angle"}) belongs(member, "spot");
  for (const char* member : {"width", "height"}) belongs(member, "area");
  if (name == "point") {
    light.kind = PointLight{};
  } else if (name == "directional") {
    light.kind = DirectionalLight{};
  } else if (name == "spot") {
    SpotLight spot;
    set(spot.outer_angle, json, "outer_angle", 0, 90);
    set(spot.inner_angle, json, "inner_angle", 0, spot.outer_angle);
    light.kind = spot;
  } else if (name == "area") {
    AreaLight area;
    set(area.width, json, "width", 0, infinity);
    set(area.height, json, "height", 0, infinity);
    light.kind = area;
  } else {
    kind.fail("one of point, directional, spot, area");
  }
  return light;
}

SceneCamera SceneReader::camera_of(const JsonValue& json) const {
  check_members(json, "camera");
  SceneCamera camera;
  set(camera.field_of_view, json, "field_of_view", 1, 179);
  return camera;
}

}  // namespace sightline
