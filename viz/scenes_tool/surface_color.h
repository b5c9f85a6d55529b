#pragma once

#include <optional>
#include <vector>

#include "sightline/scene/scene.h"
#include "sightline/texture/image_texture.h"
#include "sightline/texture/texture.h"

namespace sightline::scenes_tool {

/// The textures of a scene, made once.
class SurfaceColors {
 public:
  /// Images that cannot be read are left out.
  explicit SurfaceColors(const Scene& scene);

  /// Of a material (no_item: clay) at a point in its shape's own coordinates, and in its images.
  Vec3d color(std::uint32_t material, const Vec3d& point, const glm::dvec2& uv) const;

  /// By the name that a part of a solid has: a material's, or else a color of its own.
  Vec3d color(const std::string& name, const Vec3d& point) const;

 private:
  struct Source {
    std::optional<Texture> function;
    std::optional<ImageTexture> image;
  };

  const Scene& scene_;
  std::vector<Source> sources_;
};

}  // namespace sightline::scenes_tool
