#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include "sightline/io/image_file.h"
#include "sightline/scene/scene_members.h"
#include "sightline/scene/scene_reader.h"
#include "sightline/scene/set_member.h"
#include "sightline/texture/texture.h"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What options call their values.
template <class Infos>
auto kind_of(const JsonValue& json, const Infos& infos) {
  std::string known;
  for (const auto& info : infos) {
    if (info.name == json.text()) return info.kind;
    known += (known.empty() ? "" : ", ") + std::string(info.name);
  }
  json.fail("one of " + known);
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
  set_member(material.color, json, "color");
  if (const auto texture = json.find("color_texture"))
    material.color_texture = look_up(textures_, *texture, "textures");
  if (const auto map = json.find("normal_map")) material.normal_map = look_up(textures_, *map, "textures");
  set_member(material.normal_strength, json, "normal_strength", 0, infinity);
  if (const auto dents = json.find("dents")) material.dents = dents_of(*dents);
  set_member(material.roughness, json, "roughness", 0, 1);
  set_member(material.metallic, json, "metallic", 0, 1);
  set_member(material.transmission, json, "transmission", 0, 1);
  set_member(material.refractive_index, json, "refractive_index", 1, infinity);
  set_member(material.absorption, json, "absorption");
  set_member(material.emission, json, "emission");
  return material;
}

DentOptions SceneReader::dents_of(const JsonValue& json) {
  check_members(json, "dents");
  DentOptions dents;
  FieldOptions& field = dents.field;
  set_member(dents.height, json, "height", -infinity, infinity);
  if (const auto kind = json.find("noise")) field.noise.kind = kind_of(*kind, noise_infos);
  if (const auto kind = json.find("fractal")) field.fractal = kind_of(*kind, fractal_infos);
  auto octaves = static_cast<std::uint32_t>(field.octaves);
  set_member(octaves, json, "octaves", 1, 32);
  field.octaves = static_cast<int>(octaves);
  for (const auto& [name, value] : {std::pair{"lacunarity", &field.lacunarity}, std::pair{"gain", &field.gain},
                                    std::pair{"frequency", &field.frequency}, std::pair{"warp", &field.warp}}) {
    set_member(*value, json, name, -infinity, infinity);
  }
  field.noise.seed = json.whole_or("seed", 0);
  try {
    Dents made(dents);
  } catch (const std::invalid_argument& error) {
    json.fail("noise with its options", error.what());
  }
  return dents;
}

Light SceneReader::light_of(const JsonValue& json) const {
  check_members(json, "light");
  Light light;
  const JsonValue kind = json["kind"];
  const std::string& name = kind.text();
  set_member(light.color, json, "color");
  set_member(light.intensity, json, "intensity", 0, infinity);
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
    set_member(spot.outer_angle, json, "outer_angle", 0, 90);
    set_member(spot.inner_angle, json, "inner_angle", 0, spot.outer_angle);
    light.kind = spot;
  } else if (name == "area") {
    AreaLight area;
    set_member(area.width, json, "width", 0, infinity);
    set_member(area.height, json, "height", 0, infinity);
    light.kind = area;
  } else {
    kind.fail("one of point, directional, spot, area");
  }
  return light;
}

}  // namespace sightline
