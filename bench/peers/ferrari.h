#pragma once
/// Tori by the closed form that most tracers use: the peer of torus_roots.

#include <array>

#include "sightline/math/ray.h"
#include "sightline/shape/torus.h"

namespace sightline::bench {

/// Real roots of x^4 + a x^3 + b x^2 + c x + d as double rounds them, in ascending order, double ones twice; returns
/// how many. Ludovico Ferrari's factors, the resolvent's largest root by Cardano or Viete.
int ferrari_roots(double a, double b, double c, double d, std::array<double, 4>& roots);

/// Where a line meets a torus whose axis is of unit length: the quartic of the ray with a direction of unit length,
/// after a test of the sphere around the torus.
int ferrari_roots(const Torus& torus, const Ray<double>& ray, std::array<double, 4>& roots);

}  // namespace sightline::bench
