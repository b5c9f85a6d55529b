#include "bench/solids/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "sightline/accel/box_primitives.h"
#include "sightline/accel/registry.h"
#include "sightline/query/packets.h"
#include "sightline/query/primitives_of.h"

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

template <Level level, class Structure>
class PainterOf final : public Painter {
 public:
  PainterOf(SolidSet<level> solids, bool in_packets)
      : solids_(std::move(solids)),
        structure_(Structure::build(PrimitivesOf(solids_), costly_primitives<Structure>())),
        in_packets_(in_packets) {}

  void paint(const SolidScene& scene, Picture& picture, int row_step) const override {
    NoSolidProbe probe;
    std::uint64_t rays = 0;
    paint(scene, picture, row_step, probe, rays);
  }
  PaintStats count(const SolidScene& scene, Picture& picture) const override {
    PaintStats stats;
    paint(scene, picture, 1, stats.solids, stats.rays);
    return stats;
  }

 private:
  template <class Probe>
  void paint(const SolidScene& scene, Picture& picture, int row_step, Probe& probe, std::uint64_t& rays) const {
    const SolidLeaves<level, Probe> leaves(solids_, structure_.leaf_order(), probe);
    const Camera& camera = scene.camera;
    Tile tile;
    for (int y = 0; y < camera.height; y += tile_side * row_step) {
      for (int x = 0; x < camera.width; x += tile_side) {
        tile.look(camera, picture, x, y, row_step);
        paint(tile, scene.light, leaves);
        rays += tile.seen.count + tile.lit.count;
      }
    }
  }

  template <class Leaves>
  void paint(Tile& tile, const Vec3d& light, const Leaves& leaves) const {
    find_closest(leaves, tile.seen, tile.hits);
    for (std::size_t i = 0; i < tile.seen.count; ++i) {
      *tile.pixels[i] = tile.hits[i].is_hit() ? static_cast<float>(ambient) : 0;
      if (tile.hits[i].is_hit()) look_at_light(tile, i, light);
    }
    find_any(leaves, tile.lit, tile.is_dark);
    for (std::size_t i = 0; i < tile.lit.count; ++i) {
      if (!tile.is_dark[i]) *tile.lit_pixels[i] = tile.lit_shades[i];
    }
  }

  /// Adds the ray to the light, where that could shine.
  void look_at_light(Tile& tile, std::size_t i, const Vec3d& light) const {
    const Ray<double>& ray = tile.seen.rays[i];
    const Hit<double>& hit = tile.hits[i];
    Boundary boundary;
    boundary.t = hit.t;
    boundary.primitive = static_cast<std::uint32_t>(hit.u);
    boundary.face = static_cast<std::uint32_t>(hit.v);
    Vec3d normal = solids_[hit.prim_id].normal(boundary, ray);
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

  template <class Leaves>
  void find_closest(const Leaves& leaves, const TileRays& rays, std::span<Hit<double>> hits) const {
    NoProbe probe;
    if (in_packets_) return packet_closest_hits(structure_, leaves, rays.all(), hits, probe);
    for (std::size_t i = 0; i < rays.count; ++i) hits[i] = closest_hit(structure_, leaves, rays.rays[i], probe);
  }
  template <class Leaves>
  void find_any(const Leaves& leaves, const TileRays& rays, std::span<std::uint8_t> are_hits) const {
    NoProbe probe;
    if (in_packets_) return packet_any_hits(structure_, leaves, rays.all(), are_hits, probe);
    for (std::size_t i = 0; i < rays.count; ++i) are_hits[i] = any_hit(structure_, leaves, rays.rays[i], probe);
  }

  SolidSet<level> solids_;
  Structure structure_;
  bool in_packets_;
};

template <Level level>
std::unique_ptr<Painter> painter_of(std::vector<std::shared_ptr<const Solid>> solids, std::string_view accelerator,
                                    bool in_packets) {
  std::unique_ptr<Painter> painter;
  Accelerators::for_each([&]<class Structure>(auto) {
    if (Structure::name == accelerator) {
      painter = std::make_unique<PainterOf<level, Structure>>(SolidSet<level>(std::move(solids)), in_packets);
    }
  });
  if (!painter) throw std::invalid_argument("unknown accelerator '" + std::string(accelerator) + "'");
  return painter;
}

}  // namespace

std::unique_ptr<Painter> make_painter(const SolidScene& scene, Level level, const SolidOptions& options,
                                      std::string_view over_solids, std::string_view over_operands, bool in_packets) {
  std::vector<std::shared_ptr<const Solid>> solids;
  for (const SolidTree& tree : scene.solids) solids.push_back(std::make_shared<Solid>(tree, options, over_operands));
  switch (level) {
    case Level::fast:
      return painter_of<Level::fast>(std::move(solids), over_solids, in_packets);
    case Level::watertight:
      return painter_of<Level::watertight>(std::move(solids), over_solids, in_packets);
    case Level::precise:
      return painter_of<Level::precise>(std::move(solids), over_solids, in_packets);
    case Level::exact:
      break;
  }
  return painter_of<Level::exact>(std::move(solids), over_solids, in_packets);
}

}  // namespace sightline::bench
