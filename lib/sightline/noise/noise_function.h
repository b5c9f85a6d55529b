#pragma once
/// One kind of noise, whatever it is, for one type of numbers in the plane or in space.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "sightline/noise/noise_options.h"

namespace sightline {

template <class T, std::size_t dims>
class NoiseFunction {
 public:
  using Point = std::array<T, dims>;
  /// Lists of as many numbers each, one for each axis.
  using PointLists = std::array<const T*, dims>;
  /// A list of values and one for each component of the gradient.
  using SampleLists = std::array<T*, 1 + dims>;

  virtual ~NoiseFunction() = default;

  virtual T value(const Point& point) const = 0;
  /// The value, then the gradient.
  virtual std::array<T, 1 + dims> sample(const Point& point) const = 0;
  /// The same to the last bit for many points.
  virtual void values(const PointLists& points, std::size_t count, T* values) const = 0;
  virtual void samples(const PointLists& points, std::size_t count, const SampleLists& samples) const = 0;
};

template <class T, std::size_t dims>
std::shared_ptr<const NoiseFunction<T, dims>> make_noise_function(const NoiseOptions& options);

extern template std::shared_ptr<const NoiseFunction<float, 2>> make_noise_function(const NoiseOptions&);
extern template std::shared_ptr<const NoiseFunction<float, 3>> make_noise_function(const NoiseOptions&);
extern template std::shared_ptr<const NoiseFunction<double, 2>> make_noise_function(const NoiseOptions&);
extern template std::shared_ptr<const NoiseFunction<double, 3>> make_noise_function(const NoiseOptions&);

}  // namespace sightline
