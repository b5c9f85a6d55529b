#pragma once
/// Materials made ready for shading: what each reads, and what it does with light.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sightline/render/effect.h"
#include "sightline/scene/scene.h"
#include "sightline/texture/dents.h"
#include "sightline/texture/image_texture.h"
#include "sightline/texture/texture.h"

namespace sightline {

/// A texture of the scene, opened.
struct SurfaceTexture {
  std::optional<Texture> function;
  std::optional<ImageTexture> image;
};

/// Refers to textures of its table.
struct SurfaceMaterial {
  Material values;
  const Texture* color_function = nullptr;
  const ImageTexture* color_image = nullptr;
  const ImageTexture* normal_map = nullptr;
  std::optional<Dents> dents;

  bool is_diffuse = true;  ///< Scatters light to all sides.
  bool has_coat = false;   ///< Reflects as a dielectric does: not a mere Lambert surface.
  bool is_mirror = false;  ///< What it reflects, it reflects in one direction,
  bool is_glossy = false;  ///< or around one.
  bool is_transparent = false;
  bool is_emitting = false;

  /// All that something made of it asks for.
  Effects effects() const;
};

/// The materials of a scene, by number; and of what has none.
class MaterialTable {
 public:
  /// Opens textures of those that `is_used` says are used, no others. \throws FileError for an image that cannot be
  /// read.
  MaterialTable(const Scene& scene, std::span<const std::uint8_t> is_used);

  const SurfaceMaterial& operator[](std::uint32_t number) const {
    return number == no_item ? clay_ : materials_[number];
  }

  /// What a material does with light, by its values alone.
  static SurfaceMaterial of(const Material& material);

 private:
  std::vector<SurfaceTexture> textures_;
  std::vector<SurfaceMaterial> materials_;
  SurfaceMaterial clay_;
};

}  // namespace sightline
