#include "bench/solids/painter.h"

#include <cmath>
#include <utility>

#include "sightline/accel/box_primitives.h"
#include "sightline/accel/registry.h"
#include "sightline/query/primitives_of.h"
#include "sightline/query/queries.h"

namespace sightline::bench {
namespace {

/// A ray to the light begins this far from where it left the surface, so that rounding does not make it meet that
/// again. POV-Ray's own tolerance for shadows is a thousandth.
constexpr double shadow_begin = 0x1p-10;

template <Level level, class Structure>
class PainterOf final : public Painter {
 public:
  explicit PainterOf(SolidSet<level> solids)
      : solids_(std::move(solids)),
        structure_(Structure::build(PrimitivesOf(solids_), costly_primitives<Structure>())) {}

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
    Ray<double> ray;
    ray.origin = camera.eye;
    const Vec3d column = camera.right / double(camera.width);
    for (int y = 0; y < camera.height; y += row_step) {
      float* shade = picture.shades.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width);
      const Vec3d row = camera.forward + (camera.height - 2 * y - 1) / double(camera.height) * camera.up;
      for (int x = 0; x < camera.width; ++x, ++shade, ++rays) {
        ray.direction = row + double(2 * x + 1 - camera.width) * column;
        *shade = static_cast<float>(shade_of(ray, scene.light, leaves, rays));
      }
    }
  }

  template <class Leaves>
  double shade_of(const Ray<double>& ray, const Vec3d& light, const Leaves& leaves, std::uint64_t& rays) const {
    NoProbe probe;
    const Hit<double> hit = closest_hit(structure_, leaves, ray, probe);
    if (!hit.is_hit()) return 0;
    Boundary boundary;
    boundary.t = hit.t;
    boundary.primitive = static_cast<std::uint32_t>(hit.u);
    boundary.face = static_cast<std::uint32_t>(hit.v);
    Vec3d normal = solids_[hit.prim_id].normal(boundary, ray);
    if (glm::dot(normal, ray.direction) > 0) normal = -normal;
    Ray<double> shadow;
    shadow.origin = ray.at(hit.t);
    shadow.direction = light - shadow.origin;
    const double cosine = glm::dot(normal, shadow.direction);
    if (!(cosine > 0)) return ambient;
    const double distance = glm::length(shadow.direction);
    shadow.t_min = shadow_begin / distance;
    shadow.t_max = 1;
    ++rays;
    return any_hit(structure_, leaves, shadow, probe) ? ambient : ambient + diffuse * cosine / distance;
  }

  SolidSet<level> solids_;
  Structure structure_;
};

template <Level level>
std::unique_ptr<Painter> painter_of(std::vector<std::shared_ptr<const Solid>> solids, std::string_view accelerator) {
  std::unique_ptr<Painter> painter;
  Accelerators::for_each([&]<class Structure>(auto) {
    if (Structure::name == accelerator) {
      painter = std::make_unique<PainterOf<level, Structure>>(SolidSet<level>(std::move(solids)));
    }
  });
  if (!painter) throw std::invalid_argument("unknown accelerator '" + std::string(accelerator) + "'");
  return painter;
}

}  // namespace

std::unique_ptr<Painter> make_painter(const SolidScene& scene, Level level, const SolidOptions& options,
                                      std::string_view over_solids, std::string_view over_operands) {
  std::vector<std::shared_ptr<const Solid>> solids;
  for (const SolidTree& tree : scene.solids) solids.push_back(std::make_shared<Solid>(tree, options, over_operands));
  switch (level) {
    case Level::fast:
      return painter_of<Level::fast>(std::move(solids), over_solids);
    case Level::watertight:
      return painter_of<Level::watertight>(std::move(solids), over_solids);
    case Level::precise:
      return painter_of<Level::precise>(std::move(solids), over_solids);
    case Level::exact:
      break;
  }
  return painter_of<Level::exact>(std::move(solids), over_solids);
}

}  // namespace sightline::bench
