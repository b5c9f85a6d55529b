#pragma once
/// Random numbers that are the same on every machine, compiler and standard library; std's distributions are not.

#include <cstdint>

namespace sightline {

/// Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014 (SplitMix64): a counter in steps of
/// the golden ratio, hashed. Every seed starts its own sequence of period 2^64.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(hash(seed)) {}

  /// 32 uniform bits.
  std::uint32_t next() { return static_cast<std::uint32_t>(next64() >> 32); }

  /// Uniform multiples of 2^-24 in [0, 1).
  float uniform() { return static_cast<float>(next64() >> 40) * 0x1p-24f; }

  /// Uniform multiples of 2^-53 in [0, 1).
  double uniform_double() { return static_cast<double>(next64() >> 11) * 0x1p-53; }

  /// Uniform within [lo, hi], but for rounding.
  float uniform(float lo, float hi) { return lo + (hi - lo) * uniform(); }

  /// One of 0 ... count - 1, each as likely to within count / 2^32. `count` is at least 1.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>((std::uint64_t{next()} * std::uint64_t{count}) >> 32);
  }

  /// The finalizer, for hashing lattice points and the like.
  static std::uint64_t hash(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58'476d'1ce4'e5b9u;
    x = (x ^ (x >> 27)) * 0x94d0'49bb'1331'11ebu;
    return x ^ (x >> 31);
  }

 private:
  std::uint64_t next64() { return hash(state_ += 0x9e37'79b9'7f4a'7c15u); }

  std::uint64_t state_;
};

}  // namespace sightline
