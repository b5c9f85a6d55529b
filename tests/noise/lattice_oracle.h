#pragma once
/// What noise is by its definition, in numbers of any type: from what lattice points have, one corner after the other.

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sightline/noise/noise.h"

namespace sightline::test {

using Wide = boost::multiprecision::cpp_bin_float_50;

template <class N>
N eased(Ease ease, const N& t) {
  return ease == Ease::cubic ? N(t * t * (3 - 2 * t)) : N(t * t * t * (t * (t * 6 - 15) + 10));
}

/// corner(lattice point, way from it to the point) gives a number, and these are interpolated along x, then y, then z.
template <std::size_t dims, class N, class Corner>
N interpolated(Ease ease, const std::array<N, dims>& point, const Corner& corner) {
  using std::floor;
  std::array<N, dims> low;
  for (std::size_t a = 0; a < dims; ++a) low[a] = floor(point[a]);
  std::array<N, std::size_t{1} << dims> at;
  for (std::size_t c = 0; c < at.size(); ++c) {
    std::array<double, dims> lattice;
    std::array<N, dims> way;
    for (std::size_t a = 0; a < dims; ++a) {
      const N x = low[a] + (c >> a & 1);
      lattice[a] = static_cast<double>(x);
      way[a] = point[a] - x;
    }
    at[c] = corner(lattice, way);
  }
  for (std::size_t a = 0, count = at.size() / 2; a < dims; ++a, count /= 2) {
    const N s = eased(ease, N(point[a] - low[a]));
    for (std::size_t c = 0; c < count; ++c) at[c] = at[2 * c] + s * (at[2 * c + 1] - at[2 * c]);
  }
  return at[0];
}

template <std::size_t dims>
glm::vec<static_cast<int>(dims), double> vector_of(const std::array<double, dims>& numbers) {
  glm::vec<static_cast<int>(dims), double> v;
  for (std::size_t a = 0; a < dims; ++a) v[static_cast<int>(a)] = numbers[a];
  return v;
}

/// Gradients and values as they show at lattice points themselves, where nothing is interpolated.
template <std::size_t dims>
class LatticeOracle {
 public:
  explicit LatticeOracle(const Noise& noise) : noise_(noise) {}

  template <class N>
  N operator()(const std::array<N, dims>& point) const {
    const NoiseOptions& options = noise_.options();
    const Ease ease = options.kind == NoiseKind::improved ? Ease::quintic : options.ease;
    return interpolated(ease, point, [&](const std::array<double, dims>& lattice, const std::array<N, dims>& way) {
      const auto sample = noise_.sample(vector_of(lattice));
      if (options.kind == NoiseKind::value) return N(sample.value);
      N sum = 0;
      for (std::size_t a = 0; a < dims; ++a) sum += way[a] * sample.gradient[static_cast<int>(a)];
      return sum;
    });
  }

  /// The derivatives, as differences in so many digits that nothing of these is lost.
  std::array<double, dims> gradient(const std::array<double, dims>& at) const {
    const Wide step = boost::multiprecision::ldexp(Wide(1), -50);
    std::array<double, dims> gradient;
    for (std::size_t a = 0; a < dims; ++a) {
      std::array<Wide, dims> before, after;
      for (std::size_t k = 0; k < dims; ++k) before[k] = after[k] = at[k];
      before[a] -= step, after[a] += step;
      gradient[a] = static_cast<double>(((*this)(after) - (*this)(before)) / (2 * step));
    }
    return gradient;
  }

 private:
  const Noise& noise_;
};

}  // namespace sightline::test
