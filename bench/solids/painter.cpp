#include "bench/solids/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "sightline/render/solid_tracer.h"

namespace sightline::bench {
namespace {

/// A ray to the light begins this far from where it left the surface, so that rounding does not make it meet that
/// again. POV-Ray's own tolerance for shadows is a thousandth.
constexpr double shadow_begin = 0x1p-10;

/// Pixels that are painted together: their rays are neighbours.
constexpr int tile_side = 4;
constexpr std::size_t tile_size = std::size_t{tile_side} * tile_side;

struct TileRays {
  std::array<Ray<double>, tile_size> rays;
  std::size_t count = 0;

  std::span<const Ray<double>> all() const { return {rays.data(), count}; }
};

struct Tile {
  TileRays seen;
  std::array<float*, tile_size> pixels;
  std::array<Hit<double>, tile_size> hits;

  TileRays lit;  ///< To the light.
  std::array<float*, tile_size> lit_pixels;
  std::array<float, tile_size> lit_shades;  ///< Where nothing is in between.
  std::array<std::uint8_t, tile_size> is_dark;

  /// Through pixels from (x, y) on, of each `row_step`-th row.
  void look(const Camera& camera, Picture& picture, int x, int y, int row_step) {
    seen.count = lit.count = 0;
    const Vec3d column = camera.right / double(camera.width);
    const int right = std::min(x + tile_side, camera.width), below = std::min(y + tile_side * row_step, camera.height);
    for (int j = y; j < below; j += row_step) {
      const Vec3d row = camera.forward + (camera.height - 2 * j - 1) / double(camera.height) * camera.up;
      float* const shades =
          picture.shades.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(camera.width);
      for (int i = x; i < right; ++i, ++seen.count) {
        seen.rays[seen.count].origin = camera.eye;
        seen.rays[seen.count].direction = row + double(2 * i + 1 - camera.width) * column;
        pixels[seen.count] = shades + i;
      }
    }
  }
};

class TracingPainter final : public Painter {
 public:
  explicit TracingPainter(std::unique_ptr<SolidTracer> tracer) : tracer_(std::move(tracer)) {}

  void paint(const SolidScene& scene, Picture& picture, int row_step) const override {
    std::uint64_t rays = 0;
    paint(scene, picture, row_step, rays);
  }
  PaintStats count(const SolidScene& scene, Picture& picture) const override {
    PaintStats stats;
    SolidWork work;
    paint(scene, picture, 1, stats.rays, work);
    stats.solids = work.solids;
    return stats;
  }

 private:
  /// `work` is nothing, or a SolidWork.
  template <class... Work>
  void paint(const SolidScene& scene, Picture& picture, int row_step, std::uint64_t& rays, Work&... work) const {
    const Camera& camera = scene.camera;
    Tile tile;
    for (int y = 0; y < camera.height; y += tile_side * row_step) {
      for (int x = 0; x < camera.width; x += tile_side) {
        tile.look(camera, picture, x, y, row_step);
        paint(tile, scene.light, work...);
        rays += tile.seen.count + tile.lit.count;
      }
    }
  }

  template <class... Work>
  void paint(Tile& tile, const Vec3d& light, Work&... work) const {
    tracer_->closest_hits(tile.seen.all(), std::span(tile.hits).first(tile.seen.count), work...);
    for (std::size_t i = 0; i < tile.seen.count; ++i) {
      *tile.pixels[i] = tile.hits[i].is_hit() ? static_cast<float>(ambient) : 0;
      if (tile.hits[i].is_hit()) look_at_light(tile, i, light);
    }
    tracer_->any_hits(tile.lit.all(), std::span(tile.is_dark).first(tile.lit.count), work...);
    for (std::size_t i = 0; i < tile.lit.count; ++i) {
      if (!tile.is_dark[i]) *tile.lit_pixels[i] = tile.lit_shades[i];
    }
  }

  /// Adds the ray to the light, where that could shine.
  void look_at_light(Tile& tile, std::size_t i, const Vec3d& light) const {
    const Ray<double>& ray = tile.seen.rays[i];
    const Hit<double>& hit = tile.hits[i];
    Vec3d normal = tracer_->solids()[hit.prim_id]->normal(boundary_of(hit), ray);
    if (glm::dot(normal, ray.direction) > 0) normal = -normal;
    Ray<double>& shadow = tile.lit.rays[tile.lit.count];
    shadow.origin = ray.at(hit.t);
    shadow.direction = light - shadow.origin;
    const double cosine = glm::dot(normal, shadow.direction);
    if (!(cosine > 0)) return;
    const double distance = glm::length(shadow.direction);
    shadow.t_min = shadow_begin / distance;
    shadow.t_max = 1;
    tile.lit_pixels[tile.lit.count] = tile.pixels[i];
    tile.lit_shades[tile.lit.count] = static_cast<float>(ambient + diffuse * cosine / distance);
    ++tile.lit.count;
  }

  std::unique_ptr<SolidTracer> tracer_;
};

}  // namespace

std::unique_ptr<Painter> make_painter(const SolidScene& scene, Level level, const SolidOptions& options,
                                      std::string_view over_solids, std::string_view over_operands, bool in_packets) {
  std::vector<std::shared_ptr<const Solid>> solids;
  for (const SolidTree& tree : scene.solids) solids.push_back(std::make_shared<Solid>(tree, options, over_operands));
  return std::make_unique<TracingPainter>(make_solid_tracer(over_solids, std::move(solids), level, {{}, in_packets}));
}

}  // namespace sightline::bench
