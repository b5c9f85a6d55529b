#include "sightline/io/gltf_materials.h"

#include <cmath>
#include <map>
#include <numbers>

#include "sightline/io/assimp_model.h"
#include "sightline/io/embedded_image.h"
#include "sightline/io/gltf_buffers.h"

namespace sightline {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

std::string name_of(const JsonValue& json) {
  const auto name = json.find("name");
  return name ? name->text() : "";
}

double real_or(const JsonValue& json, const char* name, double otherwise, double lowest, double highest) {
  const auto member = json.find(name);
  return member ? member->real_within(lowest, highest) : otherwise;
}

Vec3f color_or(const JsonValue& json, const char* name, const Vec3f& otherwise) {
  const auto member = json.find(name);
  if (!member) return otherwise;
  Vec3f color;
  for (int i = 0; i < 3; ++i) {
    const JsonValue part = (*member)[static_cast<std::size_t>(i)];
    part.real_within(0, std::numeric_limits<float>::max());
    color[i] = part.number();
  }
  return color;
}

class Surfaces {
 public:
  Surfaces(const JsonValue& document, const GltfAccessors& accessors, Model& model)
      : document_(document), accessors_(accessors), model_(model) {}

  ModelMaterial material_of(const JsonValue& json) {
    ModelMaterial material;
    material.name = name_of(json);
    material.color = Vec3f(1);
    material.metallic = 1;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (const auto pbr = json.find("pbrMetallicRoughness")) {
      material.color = color_or(*pbr, "baseColorFactor", material.color);
      material.metallic = real_or(*pbr, "metallicFactor", 1, 0, 1);
      material.roughness = real_or(*pbr, "roughnessFactor", 1, 0, 1);
      if (const auto texture = pbr->find("baseColorTexture")) material.color_image = image_of(*texture, false);
    }
    if (const auto texture = json.find("normalTexture")) {
      material.normal_image = image_of(*texture, true);
      material.normal_strength = real_or(*texture, "scale", 1, 0, infinity);
    }
    material.emission = color_or(json, "emissiveFactor", material.emission);
    const auto extensions = json.find("extensions");
    const auto extension = [&](const char* name) { return extensions ? extensions->find(name) : std::nullopt; };
    if (const auto glass = extension("KHR_materials_transmission")) {
      material.transmission = real_or(*glass, "transmissionFactor", 0, 0, 1);
    }
    if (const auto index = extension("KHR_materials_ior")) {
      material.refractive_index = real_or(*index, "ior", 1.5, 0, infinity);
    }
    if (const auto strength = extension("KHR_materials_emissive_strength")) {
      material.emission *= static_cast<float>(real_or(*strength, "emissiveStrength", 1, 0, 0x1p60));
    }
    if (const auto volume = extension("KHR_materials_volume")) {
      // After a distance this share is left of each color: Beer's law.
      const double distance = real_or(*volume, "attenuationDistance", infinity, 0, infinity);
      const Vec3f left = color_or(*volume, "attenuationColor", Vec3f(1));
      for (int i = 0; i < 3; ++i) {
        const double absorption = -std::log(double(left[i])) / distance;
        if (absorption > 0 && std::isfinite(absorption)) material.absorption[i] = static_cast<float>(absorption);
      }
    }
    return material;
  }

 private:
  /// Of a reference to a texture.
  std::uint32_t image_of(const JsonValue& json, bool is_data) {
    if (json.whole_or("texCoord", 0) != 0) {
      return warn(json, "the first places in images (TEXCOORD_0)", "others");
    }
    const JsonValue texture = document_["textures"][json["index"].whole()];
    const auto source = texture.find("source");
    if (!source) return warn(texture, "a PNG or JPEG image", "none");
    const auto [place, is_new] = known_.try_emplace({source->whole(), is_data}, nothing);
    if (!is_new) return place->second;
    const JsonValue image = document_["images"][source->whole()];
    ModelImage added{name_of(image), std::string(), is_data};
    if (const auto uri = image.find("uri")) {
      if (auto data = gltf_data(*uri)) {
        added.source = std::move(*data);
      } else {
        const std::filesystem::path file = find_image(image.path(), gltf_file(*uri).string());
        if (file.empty()) return warn(image, "an image in the folder of the model", "\"" + uri->text() + "\"");
        added.source = file;
      }
    } else {
      added.source = std::string(accessors_.view(image["bufferView"]));
    }
    const auto* bytes = std::get_if<std::string>(&added.source);
    if (bytes && image_extension(*bytes).empty()) return warn(image, "a PNG or JPEG image", "another");
    if (added.name.empty() && !bytes) added.name = std::get<std::filesystem::path>(added.source).filename().string();
    model_.images.push_back(std::move(added));
    return place->second = static_cast<std::uint32_t>(model_.images.size() - 1);
  }

  std::uint32_t warn(const JsonValue& json, const std::string& expected, const std::string& found) {
    model_.warnings.push_back("texture " + json.place() + ": expected " + expected + ", found " + found.substr(0, 80));
    return nothing;
  }

  const JsonValue& document_;
  const GltfAccessors& accessors_;
  Model& model_;
  std::map<std::pair<std::uint64_t, bool>, std::uint32_t> known_;
};

}  // namespace

void read_gltf_surfaces(const JsonValue& document, const GltfAccessors& accessors, Model& model) {
  const auto materials = document.find("materials");
  Surfaces surfaces(document, accessors, model);
  for (std::size_t i = 0; materials && i < materials->size(); ++i) {
    model.materials.push_back(surfaces.material_of((*materials)[i]));
  }
}

void read_gltf_lights(const JsonValue& document, Model& model) {
  const auto extensions = document.find("extensions");
  const auto punctual = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
  const auto lights = punctual ? punctual->find("lights") : std::nullopt;
  for (std::size_t i = 0; lights && i < lights->size(); ++i) {
    const JsonValue json = (*lights)[i];
    ModelLight light;
    light.name = name_of(json);
    light.color = color_or(json, "color", Vec3f(1));
    light.intensity = real_or(json, "intensity", 1, 0, std::numeric_limits<double>::max());
    const std::string& type = json["type"].text();
    if (type == "directional") {
      light.kind = ModelLight::Kind::directional;
    } else if (type == "spot") {
      light.kind = ModelLight::Kind::spot;
      const JsonValue spot = json["spot"];
      // A quarter turn is 90 degrees, whatever its last bit is.
      const auto angle = [&](const char* name, double otherwise) {
        return std::fmin(90, degrees * real_or(spot, name, otherwise, 0, 1.6));
      };
      light.outer_angle = angle("outerConeAngle", std::numbers::pi / 4);
      light.inner_angle = std::fmin(light.outer_angle, angle("innerConeAngle", 0));
    } else if (type != "point") {
      json["type"].fail("one of point, directional, spot");
    }
    model.lights.push_back(light);
  }
}

void read_gltf_cameras(const JsonValue& document, Model& model) {
  const auto cameras = document.find("cameras");
  for (std::size_t i = 0; cameras && i < cameras->size(); ++i) {
    const JsonValue json = (*cameras)[i];
    ModelCamera camera;
    camera.name = name_of(json);
    if (const auto perspective = json.find("perspective")) {
      camera.field_of_view = degrees * (*perspective)["yfov"].real_within(0x1p-10, 3.14);
    } else {
      model.warnings.push_back("camera " + json.place() + ": expected perspective, found another, which becomes that");
    }
    model.cameras.push_back(camera);
  }
}

}  // namespace sightline
