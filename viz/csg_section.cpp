#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <span>

#include "sightline/csg/evaluator.h"
#include "viz/csg_light.h"
#include "viz/csg_trace.h"

namespace sightline::viz {
namespace {

/// Where a line is inside of each of up to 64 solids, a bit each, sampled from the left.
template <Level level>
void sample(const Solid& solid, const Ray<double>& ray, const SectionPlane& plane, int bit,
            std::span<std::uint64_t> samples) {
  NoSolidProbe probe;
  SolidEvaluator<level> evaluator(solid, ray, probe);
  const SpanList list = evaluator.spans();
  const double step = (plane.t_max - plane.t_min) / static_cast<double>(samples.size());
  const auto boundaries = evaluator[list];
  bool is_inside = list.begins_inside;
  std::size_t next = 0;
  for (std::size_t x = 0; x < samples.size(); ++x) {
    const double t = plane.t_min + (static_cast<double>(x) + 0.5) * step;
    for (; next < boundaries.size() && boundaries[next].t <= t; ++next) is_inside = !is_inside;
    if (is_inside) samples[x] |= std::uint64_t{1} << bit;
  }
}

constexpr int whole = 63;  // the bit of the solid itself

/// Fills the parts by their materials, and draws where they end; thick where the solid does.
Vec3d section_color(const LadderSolid& solid, const std::vector<std::uint32_t>& outlined,
                    const std::vector<std::uint64_t>& masks, int width, int height, int x, int y) {
  const auto mask = [&](int i, int j) {
    return masks[static_cast<std::size_t>(std::clamp(j, 0, height - 1)) * width + std::clamp(i, 0, width - 1)];
  };
  const std::uint64_t here = mask(x, y);
  const auto changes = [&](int reach) {
    return (here ^ mask(x + reach, y)) | (here ^ mask(x - reach, y)) | (here ^ mask(x, y + reach)) |
           (here ^ mask(x, y - reach));
  };
  const std::uint64_t wide = changes(2), narrow = changes(1);
  const bool is_inside = (here >> whole & 1) != 0;
  const auto first_of = [&](std::uint64_t bits) -> std::optional<Vec3d> {
    for (std::size_t i = 0; i < outlined.size(); ++i) {
      if ((bits >> i & 1) != 0) return light_of(solid, outlined[i]);
    }
    return std::nullopt;
  };
  if ((wide >> whole & 1) != 0) return 0.85 * first_of(wide).value_or(Vec3d(0.05));
  const Vec3d fill = first_of(here).value_or(first_of(~std::uint64_t{0}).value_or(Vec3d(0.35)));
  Vec3d light = is_inside ? 0.52 * Vec3d(1) + 0.48 * fill : Vec3d(0.965, 0.975, 0.985);
  if (const auto line = first_of(narrow)) light = 0.35 * light + 0.65 * *line;
  return light;
}

}  // namespace

ColorGrid trace_section(const LadderSolid& solid, const std::vector<std::uint32_t>& outlined, const Ray<double>& ray,
                        const SectionPlane& plane, int width, int height, Level level) {
  const int columns = width * side, rows = height * side;
  const double per_sample = (plane.t_max - plane.t_min) * glm::length(ray.direction) / columns;
  std::vector<std::uint64_t> masks(static_cast<std::size_t>(columns) * rows);
  with_level(level, [&]<Level l>() {
    tbb::parallel_for(0, rows, [&](int y) {
      Ray<double> beside = ray;
      beside.origin += plane.up * ((rows - 1 - 2 * y) * 0.5 * per_sample);
      const std::span samples(&masks[static_cast<std::size_t>(y) * columns], static_cast<std::size_t>(columns));
      sample<l>(solid.quick(), beside, plane, whole, samples);
      for (std::size_t i = 0; i < outlined.size(); ++i) {
        sample<l>(solid.parts()[outlined[i]], beside, plane, static_cast<int>(i), samples);
      }
    });
    return 0;
  });
  std::vector<Vec3f> light(masks.size());
  tbb::parallel_for(0, rows, [&](int y) {
    for (int x = 0; x < columns; ++x) {
      light[static_cast<std::size_t>(y) * columns + x] =
          Vec3f(section_color(solid, outlined, masks, columns, rows, x, y));
    }
  });
  return averaged(light, width, height);
}

}  // namespace sightline::viz
