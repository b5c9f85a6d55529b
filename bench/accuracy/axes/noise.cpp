#include <memory>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/chance.h"
#include "bench/accuracy/error_sum.h"
#include "bench/text_table.h"
#include "sightline/noise/noise_field.h"

namespace sightline::bench {
namespace {

template <class T>
using Points = std::vector<glm::vec<3, T>>;

/// Floats in both, so that every choice is given the same points.
template <class T>
std::shared_ptr<const Points<T>> points_of(const Effort& effort, double half) {
  Chance chance(effort.seed);
  auto points = std::make_shared<Points<T>>(effort.count(16'384, 4'096));
  for (auto& p : *points) p = glm::vec<3, T>(Vec3f(chance.point(half)));
  return points;
}

template <class T>
std::vector<T> values_of(const NoiseField& field, const Points<T>& points, T footprint) {
  std::vector<T> values(points.size());
  field.values(std::span(points), std::span(values), footprint);
  return values;
}

template <class T>
Choice choice_of(const std::string& name, const NoiseField& field, const std::shared_ptr<const Points<T>>& points,
                 const std::vector<double>& truth, T footprint = 0) {
  ErrorSum sum;
  const std::vector<T> own = values_of(field, *points, footprint);
  for (std::size_t i = 0; i < own.size(); ++i) sum.add(static_cast<double>(own[i]) - truth[i]);
  auto values = std::make_shared<std::vector<T>>(points->size());
  return {name, sum.errors(), [field, points, values, footprint] {
            field.values(std::span(*points), std::span(*values), footprint);
            return static_cast<double>(values->front() + values->back());
          }};
}

/// The largest jump of the second derivative along x at lattice planes, per cell squared.
double curvature_jump(const Noise& noise, const Effort& effort) {
  constexpr double h = 0x1p-12;
  Chance chance(effort.seed);
  double largest = 0;
  for (int i = 0; i < 2'000; ++i) {
    const glm::dvec3 p(std::floor(chance.between(-100, 100)), chance.between(-100, 100), chance.between(-100, 100));
    const auto slope = [&](double dx) { return noise.sample<3>(p + glm::dvec3(dx, 0, 0)).gradient.x; };
    largest = std::max(largest, std::fabs((slope(h) - slope(0)) - (slope(0) - slope(-h))) / h);
  }
  return largest;
}

Panel kinds(const Effort& effort) {
  const auto floats = points_of<float>(effort, 100);
  const auto doubles = points_of<double>(effort, 100);
  Panel panel{"one octave",
              "noise within 100 cells of the origin, in batches; double is the reference: its own error, some 1e-15, "
              "counts as 0",
              "point",
              "of the value",
              ErrorKind::maximum,
              static_cast<double>(floats->size())};
  for (const NoiseKind kind : {NoiseKind::perlin, NoiseKind::improved, NoiseKind::value}) {
    for (const EaseInfo& ease : ease_infos) {
      if (kind == NoiseKind::improved && ease.ease == Ease::cubic) continue;
      FieldOptions options;
      options.noise.kind = kind, options.noise.ease = ease.ease;
      const NoiseField field(options);
      const auto truth = values_of<double>(field, *doubles, 0);
      const std::string name =
          std::string(noise_infos[static_cast<std::size_t>(kind)].name) + ' ' + std::string(ease.name);
      const double jump = curvature_jump(field.noise(), effort);
      panel.choices.push_back(choice_of<float>(name + " float", field, floats, truth));
      panel.choices.push_back(choice_of<double>(name + " double", field, doubles, truth));
      for (std::size_t back : {1, 2}) panel.choices[panel.choices.size() - back].extras = {{"curvature jump", jump}};
    }
  }
  return panel;
}

Panel octaves(const Effort& effort) {
  constexpr int all = 8;
  FieldOptions options;
  options.noise.kind = NoiseKind::improved, options.fractal = FractalKind::fbm, options.octaves = all;
  const NoiseField field(options);
  const auto points = points_of<float>(effort, 100);
  const auto doubles = points_of<double>(effort, 100);
  const auto truth = values_of<double>(field, *doubles, 0);
  Panel panel{
      "octaves",
      "fractional Brownian motion of improved noise in float: octaves that a footprint leaves of 8, against all "
      "8 in double",
      "point",
      "of the value",
      ErrorKind::rms,
      static_cast<double>(points->size())};
  for (int left = 1; left < all; ++left) {
    const float footprint = std::ldexp(1.0f, -left - 1);  // a quarter of the last octave's cell: that one is whole
    panel.choices.push_back(choice_of<float>(
        plural(static_cast<std::size_t>(field.octaves_within(footprint)), "octave"), field, points, truth, footprint));
  }
  panel.choices.push_back(choice_of<float>("8 octaves", field, points, truth));
  return panel;
}

}  // namespace

Axis noise_axis() {
  return {"noise", "in what numbers, with what ease, and how many octaves of noise", [](const Effort& effort) {
            return std::vector{kinds(effort), octaves(effort)};
          }};
}

}  // namespace sightline::bench
