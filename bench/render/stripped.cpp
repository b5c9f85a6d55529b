#include "bench/render/stripped.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "sightline/render/integrator.h"

namespace sightline::bench {
namespace {

struct Place {
  int x, y;
  std::uint32_t in_tile;
};

struct Painted {
  SurfacePoint at;
  std::uint32_t material;
  Color color;
};

/// Of as many pixels as the renderer's waves have where no ray goes on.
constexpr std::size_t wave_size = 16;

template <bool is_textured>
class Stripped {
 public:
  explicit Stripped(const RenderScene& scene) : scene_(scene) {}

  void add_samples(TileBuffer& tile) {
    const std::vector<Place> order = in_squares(tile.rect);
    moment_ = scene_.moments[0].get();
    const Camera& camera = moment_->lens.camera;
    column_ = camera.right / double(camera.width), row_ = camera.up / double(camera.height);
    pixel_width_ = static_cast<float>(2 * glm::length(row_));
    for (std::size_t first = 0; first < order.size(); first += wave_size) {
      const auto places = std::span(order).subspan(first, std::min(wave_size, order.size() - first));
      look(places);
      trace();
      see();
      for (std::size_t i = 0; i < places.size(); ++i) tile.sums[places[i].in_tile].add(radiance_[i]);
    }
  }

 private:
  static std::vector<Place> in_squares(const TileRect& rect) {
    constexpr int side = 4;
    std::vector<Place> order(rect.pixels());
    Place* next = order.data();
    for (int y = 0; y < rect.height; y += side) {
      for (int x = 0; x < rect.width; x += side) {
        const int right = std::min(x + side, rect.width), below = std::min(y + side, rect.height);
        for (int j = y; j < below; ++j) {
          for (int i = x; i < right; ++i) {
            *next++ = {rect.x + i, rect.y + j, static_cast<std::uint32_t>(j * rect.width + i)};
          }
        }
      }
    }
    return order;
  }

  void look(std::span<const Place> places) {
    const Camera& camera = moment_->lens.camera;
    rays_.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const int x = places[i].x, y = places[i].y;
      radiance_[i] = Vec3d(0);
      Ray<double>& ray = rays_[i];
      ray = {};
      ray.origin = camera.eye;
      ray.direction =
          camera.forward + (2 * (x + 0.5) - camera.width) * column_ + (camera.height - 2 * (y + 0.5)) * row_;
    }
  }

  void trace() {
    hits_.resize(rays_.size());
    moment_->world->closest_hits(rays_, hits_);
    if constexpr (is_textured) paint();
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      if (hits_[i].is_hit()) shade(i);
    }
  }

  void paint() {
    const Surfaces& surfaces = *moment_->surfaces;
    const Texture* function = nullptr;
    painted_.resize(hits_.size());
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      const WorldHit& hit = hits_[i];
      if (!hit.is_hit()) continue;
      const Ray<double>& ray = rays_[i];
      Painted& painted = painted_[i];
      surfaces.locate(ray, hit, painted.at);
      painted.material = surfaces.material(hit);
      function = (*scene_.materials)[painted.material].color_function;
      strokes_.push_back(i);
      points_.emplace_back() = surfaces.local(hit, painted.at);
      double footprint = 0;
      if (scene_.has_footprints) {
        const float width = pixel_width_ * static_cast<float>(hit.t);
        const double speed = std::sqrt(glm::dot(ray.direction, ray.direction));
        const double slant = std::fabs(glm::dot(painted.at.outside, -ray.direction / speed));
        footprint = width / std::sqrt(std::max(slant, 0x1p-4));
      }
      footprints_.emplace_back() = surfaces.local_footprint(hit, painted.at, footprint);
    }
    if (points_.empty()) return;
    colors_.resize(points_.size());
    function->colors(points_, footprints_, colors_);
    for (std::size_t k = 0; k < points_.size(); ++k) painted_[strokes_[k]].color = colors_[k];
    strokes_.clear();
    points_.clear();
    footprints_.clear();
  }

  void shade(std::size_t place) {
    const Ray<double>& ray = rays_[place];
    const WorldHit& hit = hits_[place];
    const Surfaces& surfaces = *moment_->surfaces;
    SurfacePoint located;
    if constexpr (!is_textured) surfaces.locate(ray, hit, located);
    const SurfacePoint& at = is_textured ? painted_[place].at : located;
    const std::uint32_t number = is_textured ? painted_[place].material : surfaces.material(hit);
    const SurfaceMaterial& material = (*scene_.materials)[number];
    const Vec3d side = glm::dot(at.outside, -ray.direction) < 0 ? -at.outside : at.outside;
    Color color = material.values.color;
    if constexpr (is_textured) color *= painted_[place].color;
    if (is_black(color)) return;
    const Lamp& lamp = moment_->lamps[0];
    const double cosine = glm::dot(side, -lamp.axis);
    if (!(cosine > 0)) return;
    const Color light = static_cast<float>(cosine * std::numbers::inv_pi) * color * lamp.strength;
    if (is_black(light)) return;
    sights_.add(at.beyond(side), -lamp.axis, std::numeric_limits<double>::infinity(),
                {light, static_cast<std::uint32_t>(place)});
  }

  void see() {
    if (sights_.rays().empty()) return;
    is_stopped_.resize(sights_.rays().size());
    moment_->world->any_hits(sights_.rays(), is_stopped_);
    for (std::size_t i = 0; i < sights_.rays().size(); ++i) {
      if (!is_stopped_[i]) radiance_[sights_.lights()[i].slot] += Vec3d(sights_.lights()[i].color);
    }
    sights_.clear();
  }

  const RenderScene& scene_;
  const Moment* moment_ = nullptr;
  Vec3d column_{0}, row_{0};
  float pixel_width_ = 0;
  std::array<Vec3d, wave_size> radiance_{};
  std::vector<Ray<double>> rays_;
  Sights sights_;
  std::vector<WorldHit> hits_;
  std::vector<Painted> painted_;
  std::vector<std::size_t> strokes_;
  std::vector<Vec3d> points_;
  std::vector<Footprint> footprints_;
  std::vector<Color> colors_;
  std::vector<std::uint8_t> is_stopped_;
};

}  // namespace

void add_stripped_samples(const RenderScene& scene, TileBuffer& tile) {
  if (scene.effects.has(Effect::procedural_texture)) return Stripped<true>(scene).add_samples(tile);
  Stripped<false>(scene).add_samples(tile);
}

}  // namespace sightline::bench
