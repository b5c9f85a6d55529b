#include "viz/scenes_tool/surface_color.h"

#include <stdexcept>

#include "sightline/io/file_error.h"
#include "sightline/math/random.h"

namespace sightline::scenes_tool {

SurfaceColors::SurfaceColors(const Scene& scene) : scene_(scene), sources_(scene.textures.size()) {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const TextureSource& texture = scene.textures[i];
    try {
      if (const auto* spec = std::get_if<std::string>(&texture.source)) {
        sources_[i].function.emplace(make_texture(*spec));
      } else if (!texture.is_data) {
        sources_[i].image.emplace(std::get<std::filesystem::path>(texture.source));
      }
    } catch (const FileError&) {
      continue;  // the picture shows it without
    }
  }
}

Vec3d SurfaceColors::color(std::uint32_t material, const Vec3d& point, const glm::dvec2& uv) const {
  if (material == no_item) return Vec3d(0.72, 0.7, 0.66);
  const Material& m = scene_.materials[material];
  Vec3d color(m.color);
  if (m.color_texture != no_item) {
    const Source& source = sources_[m.color_texture];
    if (source.function) color *= Vec3d((*source.function)(point));
    if (source.image) color *= Vec3d((*source.image)(uv));
  }
  return glm::min(color + Vec3d(m.emission), Vec3d(1));
}

Vec3d SurfaceColors::color(const std::string& name, const Vec3d& point) const {
  for (std::uint32_t i = 0; i < scene_.materials.size(); ++i) {
    if (scene_.materials[i].name == name) return color(i, point, glm::dvec2(0));
  }
  std::uint64_t hash = 7;
  for (const char c : name) hash = Random::hash(hash ^ static_cast<unsigned char>(c));
  const auto part = [&](int shift) { return 0.3 + 0.5 * static_cast<double>(hash >> shift & 255) / 255; };
  return {part(0), part(8), part(16)};
}

}  // namespace sightline::scenes_tool
