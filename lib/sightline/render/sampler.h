#pragma once
/// Where samples of a pixel lie: evenly spread over the unit square, for each purpose in another order.

#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>

#include "sightline/math/random.h"

namespace sightline {

/// What a pair of numbers is for. Pairs of different purposes are independent, so what one effect draws does not depend
/// on whether another is simulated: a picture is the same bits in a renderer that knows more effects than it has.
enum class Draw : std::uint32_t {
  pixel,
  lens,
  light,
  occlusion,
  diffuse,
  glossy,
  lobe,
  environment,
  survival,
  shadow,
  sky
};

/// Sample number `index` of a sequence: Sobol's first two dimensions, scrambled as Owen does, in an order of their own
/// for each seed. Any 2^k first samples are a (0, k, 2)-net: each elementary rectangle of area 2^-k holds one.
/// Sobol', "On the distribution of points in a cube", 1967; Owen, "Randomly permuted (t, m, s)-nets", 1995; Laine and
/// Karras, "Stratified sampling for stochastic transparency", 2011; Burley, "Practical hash-based Owen scrambling",
/// 2020.
class Sampler {
 public:
  Sampler(std::uint64_t seed, std::uint32_t pixel, std::uint32_t index)
      : key_(Random::hash(seed ^ std::uint64_t{pixel} * 0x9e37'79b9'7f4a'7c15u)), index_(index) {}

  /// In [0, 1) x [0, 1), multiples of 2^-32. `step` counts a path's surfaces, `which` things of one purpose there.
  glm::dvec2 square(Draw purpose, std::uint32_t step = 0, std::uint32_t which = 0) const {
    const std::uint64_t salt = Random::hash(
        key_ + (std::uint64_t{static_cast<std::uint32_t>(purpose)} << 48 | std::uint64_t{step} << 24 | which));
    const auto low = static_cast<std::uint32_t>(salt), high = static_cast<std::uint32_t>(salt >> 32);
    const std::uint32_t place = scrambled(index_, low ^ high * 0x85eb'ca6bu);
    return {scrambled(reversed(place), low) * 0x1p-32, scrambled(second(place), high) * 0x1p-32};
  }

 private:
  static constexpr std::uint32_t reversed(std::uint32_t x) {
    x = (x & 0x5555'5555u) << 1 | (x >> 1 & 0x5555'5555u);
    x = (x & 0x3333'3333u) << 2 | (x >> 2 & 0x3333'3333u);
    x = (x & 0x0f0f'0f0fu) << 4 | (x >> 4 & 0x0f0f'0f0fu);
    return (x & 0x00ff'00ffu) << 24 | (x & 0x0000'ff00u) << 8 | (x >> 8 & 0x0000'ff00u) | x >> 24;
  }

  /// Each bit is turned over or not by a hash of the bits above it.
  static constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x = reversed(x) + seed;
    x ^= x * 0x6c50'b47cu;
    x ^= x * 0xb82f'1e52u;
    x ^= x * 0xc7af'e638u;
    x ^= x * 0x8d22'f6e6u;
    return reversed(x);
  }

  /// Sobol's second dimension: the upper triangular matrix of binomial coefficients modulo 2, of reversed bits.
  static constexpr std::uint32_t second(std::uint32_t index) {
    std::uint32_t point = 0;
    for (std::uint32_t column = 0x8000'0000u; index != 0; index >>= 1, column ^= column >> 1) {
      if (index & 1) point ^= column;
    }
    return point;
  }

  std::uint64_t key_;
  std::uint32_t index_;
};

}  // namespace sightline
