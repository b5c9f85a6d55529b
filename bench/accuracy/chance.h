#pragma once
/// What axes draw by chance; the same for the same seed.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/math/vec.h"

namespace sightline::bench {

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : random_(seed) {}

  double unit() { return random_.uniform_double(); }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }
  /// With a uniform logarithm.
  double scale(double lo, double hi) { return lo * std::pow(hi / lo, unit()); }
  std::uint64_t below(std::uint64_t count) { return random_.next() % count; }
  double sign() { return random_.next() % 2 == 0 ? 1 : -1; }
  /// Uniform on the unit sphere (Archimedes: height and angle are independent).
  Vec3d direction() {
    const double z = between(-1, 1), angle = 2 * std::numbers::pi * unit(), radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }
  Vec3d point(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }

 private:
  Random random_;
};

}  // namespace sightline::bench
