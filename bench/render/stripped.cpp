#include "bench/render/stripped.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sightline::bench {
namespace {

constexpr int side = 4;
constexpr std::size_t most = std::size_t{side} * side;

/// Sixteen neighbours on their way.
struct Square {
  std::array<Ray<double>, most> rays, to_lamp;
  std::array<WorldHit, most> hits;
  std::array<Color, most> seen, light;
  std::array<std::uint32_t, most> places, lit;
  std::array<std::uint8_t, most> is_dark;
};

template <bool is_textured>
class Stripped {
 public:
  explicit Stripped(const RenderScene& scene)
      : scene_(scene),
        moment_(*scene.moments[0]),
        camera_(moment_.lens.camera),
        lamp_(moment_.lamps[0]),
        column_(camera_.right / double(camera_.width)),
        row_(camera_.up / double(camera_.height)),
        pixel_width_(static_cast<float>(2 * glm::length(row_))) {}

  void add_samples(TileBuffer& tile) {
    for (int y = 0; y < tile.rect.height; y += side) {
      for (int x = 0; x < tile.rect.width; x += side) {
        const std::size_t count = look(tile.rect, x, y);
        moment_.world->closest_hits(std::span<const Ray<double>>(square_.rays).first(count),
                                    std::span(square_.hits).first(count));
        std::size_t lit = 0;
        for (std::size_t i = 0; i < count; ++i) {
          square_.seen[i] = Color(0);
          if (square_.hits[i].is_hit()) lit += shade(i, lit);
        }
        moment_.world->any_hits(std::span<const Ray<double>>(square_.to_lamp).first(lit),
                                std::span(square_.is_dark).first(lit));
        for (std::size_t i = 0; i < lit; ++i) {
          if (!square_.is_dark[i]) square_.seen[square_.lit[i]] = square_.light[i];
        }
        for (std::size_t i = 0; i < count; ++i) tile.sums[square_.places[i]].add(Vec3d(square_.seen[i]));
      }
    }
  }

 private:
  std::size_t look(const TileRect& rect, int x, int y) {
    std::size_t count = 0;
    const int right = std::min(x + side, rect.width), below = std::min(y + side, rect.height);
    for (int j = y; j < below; ++j) {
      for (int i = x; i < right; ++i, ++count) {
        square_.places[count] = static_cast<std::uint32_t>(j * rect.width + i);
        Ray<double>& ray = square_.rays[count];
        ray.origin = camera_.eye;
        ray.direction = camera_.forward + (2 * (rect.x + i + 0.5) - camera_.width) * column_ +
                        (camera_.height - 2 * (rect.y + j + 0.5)) * row_;
      }
    }
    return count;
  }

  /// 1 where light could come to what the ray hits: then as number `lit`.
  std::size_t shade(std::size_t i, std::size_t lit) {
    const Ray<double>& ray = square_.rays[i];
    const WorldHit& hit = square_.hits[i];
    const Surfaces& surfaces = *moment_.surfaces;
    const SurfacePoint at = surfaces.locate(ray, hit);
    const SurfaceMaterial& material = (*scene_.materials)[surfaces.material(hit)];
    Color color = material.values.color;
    double cosine = 0;
    Vec3d face;
    if constexpr (is_textured) {
      const double speed = std::sqrt(glm::dot(ray.direction, ray.direction));
      const Vec3d to_viewer = -ray.direction / speed;
      face = glm::dot(at.outside, to_viewer) < 0 ? -at.outside : at.outside;
      const float width = pixel_width_ * static_cast<float>(hit.t);
      const double slant = std::fabs(glm::dot(face, to_viewer));
      const double footprint = scene_.has_footprints ? width / std::sqrt(std::max(slant, 0x1p-4)) : 0.0;
      color *= (*material.color_function)(surfaces.local(hit, at), surfaces.local_footprint(hit, at, footprint));
    } else {
      face = glm::dot(at.outside, ray.direction) > 0 ? -at.outside : at.outside;
    }
    cosine = glm::dot(face, -lamp_.axis);
    if (!(cosine > 0)) return 0;
    square_.light[lit] = static_cast<float>(cosine * std::numbers::inv_pi) * color * lamp_.strength;
    square_.lit[lit] = static_cast<std::uint32_t>(i);
    square_.to_lamp[lit].origin = at.beyond(face);
    square_.to_lamp[lit].direction = -lamp_.axis;
    return 1;
  }

  const RenderScene& scene_;
  const Moment& moment_;
  const Camera& camera_;
  const Lamp& lamp_;
  Vec3d column_, row_;
  float pixel_width_;
  Square square_;
};

}  // namespace

void add_stripped_samples(const RenderScene& scene, TileBuffer& tile) {
  if (scene.effects.has(Effect::procedural_texture)) return Stripped<true>(scene).add_samples(tile);
  Stripped<false>(scene).add_samples(tile);
}

}  // namespace sightline::bench
