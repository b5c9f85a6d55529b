#pragma once
/// Textures by name: what tools list, set and draw.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "sightline/texture/checker.h"
#include "sightline/texture/clouds.h"
#include "sightline/texture/granite.h"
#include "sightline/texture/marble.h"
#include "sightline/texture/wood.h"

namespace sightline {

struct TextureInfo {
  std::string_view name;
  std::string_view description;
  std::vector<TextureOptionInfo> options;
};

/// All textures that are functions of space, the course's first.
const std::vector<TextureInfo>& texture_infos();

/// One of them. Immutable, and safe to ask from many threads.
class Texture {
 public:
  using Any = std::variant<Wood, Marble, Granite, Clouds, Checker>;

  Texture(Any texture) : texture_(std::move(texture)) {}  // NOLINT: one of the textures is a texture

  const Any& any() const { return texture_; }

  Color operator()(const Vec3d& p, const Footprint& footprint = {}) const {
    return std::visit([&](const auto& texture) { return texture(p, footprint); }, texture_);
  }
  /// At as many points as there are footprints and colors; equal to single ones to the last bit.
  void colors(std::span<const Vec3d> points, std::span<const Footprint> footprints, std::span<Color> colors) const {
    std::visit(
        [&](const auto& texture) {
          if constexpr (requires { texture.colors(points, footprints, colors); }) {
            texture.colors(points, footprints, colors);
          } else {
            for (std::size_t i = 0; i < points.size(); ++i) colors[i] = texture(points[i], footprints[i]);
          }
        },
        texture_);
  }

 private:
  Any texture_;
};

/// `spec` is a name ("wood"), or a name and options ("wood:texture_frequency=3,late=0.2/0.1/0").
/// \throws std::invalid_argument for what is not of this form, for an unknown name, and for options that the texture
/// does not have or allow.
Texture make_texture(const std::string& spec);

}  // namespace sightline
