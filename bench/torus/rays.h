#pragma once
/// Rays for tori around the origin, the same in every run.

#include <string>
#include <string_view>
#include <vector>

#include "sightline/math/ray.h"
#include "sightline/shape/torus.h"

namespace sightline::bench {

struct TorusRays {
  std::string_view name;
  std::string_view description;
  std::vector<Ray<double>> rays;
};

/// Three sets of rays whose lines meet the sphere around the torus, which has a major radius of 1.
std::vector<TorusRays> torus_rays(const Torus& torus, std::size_t count);

}  // namespace sightline::bench
