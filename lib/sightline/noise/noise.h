#pragma once
/// Noise: a random function of the plane or of space that is the same whenever it is asked, smooth but for white noise,
/// and without end.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "sightline/noise/noise_function.h"
#include "sightline/noise/noise_options.h"

namespace sightline {

/// A value and its derivatives along the axes.
template <class T, int dims>
struct NoiseSample {
  T value;
  glm::vec<dims, T> gradient;
};

/// Values are between -1 and 1 but for `perlin`, which stays within the square root of dims / 4, and `improved`, within
/// 1.0364. Where a coordinate is infinite or NaN the value is NaN. Immutable, and safe to ask from many threads.
class Noise {
 public:
  /// \throws std::invalid_argument for a period that is no power of two up to 2^30.
  explicit Noise(const NoiseOptions& options = {});

  const NoiseOptions& options() const { return options_; }

  float operator()(const glm::vec2& p) const { return of(p).value({p.x, p.y}); }
  float operator()(const glm::vec3& p) const { return of(p).value({p.x, p.y, p.z}); }
  double operator()(const glm::dvec2& p) const { return of(p).value({p.x, p.y}); }
  double operator()(const glm::dvec3& p) const { return of(p).value({p.x, p.y, p.z}); }

  /// The value with its exact derivative, which is no difference of values: rounding aside, the polynomial's own.
  template <int dims, class T>
  NoiseSample<T, dims> sample(const glm::vec<dims, T>& p) const {
    const auto& function = of(p);
    if constexpr (dims == 2) {
      const auto s = function.sample({p.x, p.y});
      return {s[0], {s[1], s[2]}};
    } else {
      const auto s = function.sample({p.x, p.y, p.z});
      return {s[0], {s[1], s[2], s[3]}};
    }
  }

  /// At many points, faster, and equal to single values to the last bit. \throws std::invalid_argument where there are
  /// not as many values as points.
  template <int dims, class T>
  void values(std::span<const glm::vec<dims, T>> points, std::span<T> values) const;
  template <int dims, class T>
  void samples(std::span<const glm::vec<dims, T>> points, std::span<NoiseSample<T, dims>> samples) const;

  /// The same, axis by axis, for those who have points in this form.
  template <class T, std::size_t dims>
  const NoiseFunction<T, dims>& function() const {
    if constexpr (dims == 2) {
      if constexpr (sizeof(T) == 4)
        return *plane_float_;
      else
        return *plane_double_;
    } else {
      if constexpr (sizeof(T) == 4)
        return *space_float_;
      else
        return *space_double_;
    }
  }

 private:
  template <int dims, class T>
  const NoiseFunction<T, dims>& of(const glm::vec<dims, T>&) const {
    return function<T, dims>();
  }

  NoiseOptions options_;
  std::shared_ptr<const NoiseFunction<float, 2>> plane_float_;
  std::shared_ptr<const NoiseFunction<float, 3>> space_float_;
  std::shared_ptr<const NoiseFunction<double, 2>> plane_double_;
  std::shared_ptr<const NoiseFunction<double, 3>> space_double_;
};

}  // namespace sightline
