#include "sightline/render/surface_material.h"

namespace sightline {
namespace {

bool is_black(const Color& color) { return color == Color(0); }

}  // namespace

SurfaceMaterial MaterialTable::of(const Material& material) {
  SurfaceMaterial prepared;
  prepared.values = material;
  const bool is_metal = material.metallic == 1;
  prepared.is_transparent = material.transmission > 0 && !is_metal && !is_black(material.color);
  prepared.is_diffuse = !is_metal && material.transmission < 1 && !is_black(material.color);
  // A dielectric of index 1 reflects nothing.
  prepared.has_coat =
      !is_metal && material.refractive_index != 1 && (material.roughness < 1 || prepared.is_transparent);
  const bool is_reflecting = prepared.has_coat || (material.metallic > 0);
  prepared.is_mirror = is_reflecting && material.roughness == 0;
  prepared.is_glossy = is_reflecting && material.roughness > 0;
  prepared.is_emitting = !is_black(material.emission);
  return prepared;
}

Effects SurfaceMaterial::effects() const {
  Effects effects;
  const auto add = [&](bool is_asked, Effect effect) {
    if (is_asked) effects.add(effect);
  };
  add(is_mirror, Effect::mirror);
  add(is_glossy, Effect::glossy);
  add(is_transparent, Effect::refraction);
  add(is_transparent && !is_black(values.absorption), Effect::absorption);
  add(is_emitting, Effect::emission);
  add(color_function, Effect::procedural_texture);
  add(color_image, Effect::image_texture);
  add(normal_map || dents, Effect::normal_map);
  return effects;
}

MaterialTable::MaterialTable(const Scene& scene, std::span<const std::uint8_t> is_used)
    : textures_(scene.textures.size()) {
  Material clay;
  clay.name = "clay";
  clay.color = {0.72f, 0.7f, 0.66f};
  clay_ = of(clay);

  const auto open = [&](std::uint32_t number, bool is_data) -> const SurfaceTexture& {
    SurfaceTexture& texture = textures_[number];
    if (texture.function || texture.image) return texture;
    const auto& source = scene.textures[number].source;
    if (const auto* spec = std::get_if<std::string>(&source)) {
      texture.function.emplace(make_texture(*spec));
    } else {
      ImageTextureOptions options;
      options.content = is_data ? ImageContent::data : ImageContent::color;
      texture.image.emplace(std::get<std::filesystem::path>(source), options);
    }
    return texture;
  };
  for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    SurfaceMaterial prepared = of(material);
    if (is_used[i]) {
      if (material.color_texture != no_item && !is_black(material.color)) {
        const SurfaceTexture& texture = open(material.color_texture, scene.textures[material.color_texture].is_data);
        if (texture.function) prepared.color_function = &*texture.function;
        if (texture.image) prepared.color_image = &*texture.image;
      }
      if (material.normal_map != no_item && material.normal_strength > 0) {
        const SurfaceTexture& texture = open(material.normal_map, true);
        if (texture.image) prepared.normal_map = &*texture.image;
      }
      if (material.dents) prepared.dents.emplace(*material.dents);
    }
    materials_.push_back(std::move(prepared));
  }
}

}  // namespace sightline
