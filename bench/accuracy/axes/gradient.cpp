#include <cstdio>
#include <memory>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/chance.h"
#include "bench/accuracy/error_sum.h"
#include "sightline/noise/noise.h"

namespace sightline::bench {
namespace {

template <class T>
using Point = glm::vec<3, T>;
using Points = std::vector<Point<double>>;  ///< Of floats.

Noise noise_of() { return Noise({NoiseKind::improved, 0, Ease::quintic, 0}); }

/// Within a cell noise is a polynomial of degree 6 along each axis, which seven points determine. So this difference is
/// the derivative but for rounding, some 2^-52 / h.
Point<double> true_gradient(const Noise& noise, const Point<double>& p) {
  constexpr double h = 0x1p-4;
  Point<double> gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const auto pair = [&](int steps) {
      Point<double> above = p, below = p;
      above[axis] += steps * h, below[axis] -= steps * h;
      return noise(above) - noise(below);
    };
    gradient[axis] = (45 * pair(1) - 9 * pair(2) + pair(3)) / (60 * h);
  }
  return gradient;
}

template <class T>
Point<double> central(const Noise& noise, const Point<double>& at, T h) {
  const Point<T> p(at);
  Point<double> gradient;
  for (int axis = 0; axis < 3; ++axis) {
    Point<T> above = p, below = p;
    above[axis] += h, below[axis] -= h;
    gradient[axis] = static_cast<double>((noise(above) - noise(below)) / (2 * h));
  }
  return gradient;
}

template <class Ask>
Choice choice_of(const std::string& name, const std::shared_ptr<const Points>& points, const Points& truths,
                 const Ask& ask) {
  ErrorSum sum;
  for (std::size_t i = 0; i < truths.size(); ++i) sum.add(max_norm(Vec3d(ask((*points)[i]) - truths[i])));
  return {name, sum.errors(), [points, ask] {
            Point<double> all(0);
            for (const auto& p : *points) all += ask(p);
            return all.x + all.y + all.z;
          }};
}

std::vector<Panel> panels(const Effort& effort) {
  Chance chance(effort.seed);
  const Noise noise = noise_of();
  auto points = std::make_shared<Points>();
  Points truths;
  for (std::size_t i = 0; i < effort.count(8'192, 2'048); ++i) {
    Point<double> p;
    for (int axis = 0; axis < 3; ++axis) {  // inside of a cell, far enough that the seven points are as well
      p[axis] = static_cast<float>(std::floor(chance.between(-64, 64)) + chance.between(0.2, 0.8));
    }
    points->push_back(p), truths.push_back(true_gradient(noise, p));
  }
  Panel panel{"improved noise",
              "its gradient, single points; the truth is known to some 1e-14, and double's own error is not less",
              "gradient",
              "of a component",
              ErrorKind::maximum,
              static_cast<double>(points->size())};
  const std::shared_ptr<const Points> asked = points;
  panel.choices.push_back(choice_of("analytic float", asked, truths, [noise](const Point<double>& p) {
    return Point<double>(noise.sample<3, float>(Point<float>(p)).gradient);
  }));
  panel.choices.push_back(choice_of("analytic double", asked, truths,
                                    [noise](const Point<double>& p) { return noise.sample<3, double>(p).gradient; }));
  for (int digits = 1; digits <= 8; ++digits) {
    const double h = std::pow(10.0, -digits);
    char step[16];
    std::snprintf(step, sizeof step, "h = 1e-%d ", digits);
    panel.choices.push_back(choice_of(std::string(step) + "float", asked, truths, [noise, h](const Point<double>& p) {
      return central<float>(noise, p, static_cast<float>(h));
    }));
    panel.choices.push_back(choice_of(std::string(step) + "double", asked, truths,
                                      [noise, h](const Point<double>& p) { return central<double>(noise, p, h); }));
  }
  return {panel};
}

}  // namespace

Axis gradient_axis() { return {"gradient", "how the gradient of noise is found", panels}; }

}  // namespace sightline::bench
