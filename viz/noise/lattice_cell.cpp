#include "viz/noise/lattice_cell.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sightline::viz {

double eased(Ease ease, double t) {
  return ease == Ease::cubic ? t * t * (3 - 2 * t) : t * t * t * (10 + t * (6 * t - 15));
}
double slope_of_eased(Ease ease, double t) {
  return ease == Ease::cubic ? 6 * t * (1 - t) : 30 * t * t * (1 - t) * (1 - t);
}
double curvature_of_eased(Ease ease, double t) {
  return ease == Ease::cubic ? 6 - 12 * t : 60 * t * (1 - t) * (1 - 2 * t);
}

glm::dvec2 lattice_gradient(const Noise& noise, const glm::dvec2& lattice_point) {
  return noise.sample(lattice_point).gradient;
}

Ease ease_of(const Noise& noise) {
  return noise.options().kind == NoiseKind::improved ? Ease::quintic : noise.options().ease;
}

LatticeCell lattice_cell(const Noise& noise, const glm::dvec2& point) {
  const bool has_gradients = noise.options().kind != NoiseKind::value;
  const glm::dvec2 base = glm::floor(point), way = point - base;
  LatticeCell cell{};
  cell.s = eased(ease_of(noise), way.x);
  cell.t = eased(ease_of(noise), way.y);
  constexpr std::array<std::string_view, 4> names{"LL", "LR", "UL", "UR"};
  for (std::size_t i = 0; i < 4; ++i) {
    CellCorner& corner = cell.corners[i];
    const glm::dvec2 step(i % 2 == 1, i / 2 == 1);
    corner.name = names[i];
    corner.position = base + step;
    corner.way = point - corner.position;
    corner.gradient = has_gradients ? lattice_gradient(noise, corner.position) : glm::dvec2(0);
    corner.contribution = has_gradients ? glm::dot(corner.gradient, corner.way) : noise(corner.position);
    corner.weight = (step.x > 0 ? cell.s : 1 - cell.s) * (step.y > 0 ? cell.t : 1 - cell.t);
  }
  const auto between = [](double a, double b, double share) { return a + share * (b - a); };
  cell.lower = between(cell.corners[0].contribution, cell.corners[1].contribution, cell.s);
  cell.upper = between(cell.corners[2].contribution, cell.corners[3].contribution, cell.s);
  cell.value = between(cell.lower, cell.upper, cell.t);
  return cell;
}

}  // namespace sightline::viz
