#include "bench/render/anew.h"

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
  std::array<SurfacePoint, most> at;
  std::array<Vec3d, most> points;
  std::array<Footprint, most> footprints;
  std::array<Color, most> seen, light, colors;
  std::array<std::uint32_t, most> places, met, lit;
  std::array<std::uint8_t, most> is_dark;
};

template <bool is_textured>
class Anew {
 public:
  explicit Anew(const RenderScene& scene)
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
        const std::size_t met = meet(count);
        std::size_t lit = 0;
        for (std::size_t k = 0; k < met; ++k) lit += shade(k, lit);
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

  /// Where rays hit, and with which colors; returns how many do.
  std::size_t meet(std::size_t count) {
    std::size_t met = 0;
    const SurfaceMaterial* material = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
      square_.seen[i] = Color(0);
      const WorldHit& hit = square_.hits[i];
      if (!hit.is_hit()) continue;
      const Ray<double>& ray = square_.rays[i];
      const Surfaces& surfaces = *moment_.surfaces;
      SurfacePoint& at = square_.at[met];
      surfaces.locate(ray, hit, at);
      material = &(*scene_.materials)[surfaces.material(hit)];
      if constexpr (is_textured) {
        double footprint = 0;
        if (scene_.has_footprints) {
          const double speed = std::sqrt(glm::dot(ray.direction, ray.direction));
          const double slant = std::fabs(glm::dot(at.outside, -ray.direction / speed));
          footprint = pixel_width_ * static_cast<float>(hit.t) / std::sqrt(std::max(slant, 0x1p-4));
        }
        square_.points[met] = surfaces.local(hit, at);
        square_.footprints[met] = surfaces.local_footprint(hit, at, footprint);
      }
      square_.colors[met] = material->values.color;
      square_.met[met++] = static_cast<std::uint32_t>(i);
    }
    if constexpr (is_textured) {
      if (met > 0) {
        material->color_function->colors(std::span<const Vec3d>(square_.points).first(met),
                                         std::span<const Footprint>(square_.footprints).first(met),
                                         std::span(square_.colors).first(met));
      }
    }
    return met;
  }

  /// 1 where light could come to what is met there: then as number `lit`.
  std::size_t shade(std::size_t k, std::size_t lit) {
    const std::uint32_t i = square_.met[k];
    const SurfacePoint& at = square_.at[k];
    const Vec3d face = glm::dot(at.outside, square_.rays[i].direction) > 0 ? -at.outside : at.outside;
    const double cosine = glm::dot(face, -lamp_.axis);
    if (!(cosine > 0)) return 0;
    square_.light[lit] = static_cast<float>(cosine * std::numbers::inv_pi) * square_.colors[k] * lamp_.strength;
    square_.lit[lit] = i;
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

void add_anew_samples(const RenderScene& scene, TileBuffer& tile) {
  if (scene.effects.has(Effect::procedural_texture)) return Anew<true>(scene).add_samples(tile);
  Anew<false>(scene).add_samples(tile);
}

}  // namespace sightline::bench
