#include "sightline/noise/noise_function.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "sightline/math/random.h"
#include "sightline/noise/kernel.h"

namespace sightline {
namespace {

template <class T, class Corners, Ease ease>
class LatticeNoise final : public NoiseFunction<T, Corners::dims> {
 public:
  using Base = NoiseFunction<T, Corners::dims>;

  explicit LatticeNoise(const NoiseOptions& options) : kernel_(Corners(options.seed, options.period)) {}

  T value(const typename Base::Point& point) const override {
    T value;
    kernel_.template at<false>(point.data(), &value);
    return value;
  }
  std::array<T, 1 + Corners::dims> sample(const typename Base::Point& point) const override {
    std::array<T, 1 + Corners::dims> sample;
    kernel_.template at<true>(point.data(), sample.data());
    return sample;
  }
  void values(const typename Base::PointLists& points, std::size_t count, T* values) const override {
    kernel_.template at<false>(points.data(), count, &values);
  }
  void samples(const typename Base::PointLists& points, std::size_t count,
               const typename Base::SampleLists& samples) const override {
    kernel_.template at<true>(points.data(), count, samples.data());
  }

 private:
  NoiseKernel<T, Corners, ease> kernel_;
};

/// Noise in space where z is 0.
template <class T>
class Slice final : public NoiseFunction<T, 2> {
 public:
  using Base = NoiseFunction<T, 2>;

  explicit Slice(const NoiseOptions& options) : space_(make_noise_function<T, 3>(options)) {}

  T value(const typename Base::Point& p) const override { return space_->value({p[0], p[1], 0}); }
  std::array<T, 3> sample(const typename Base::Point& p) const override {
    const auto sample = space_->sample({p[0], p[1], 0});
    return {sample[0], sample[1], sample[2]};
  }
  void values(const typename Base::PointLists& points, std::size_t count, T* values) const override {
    for_blocks(count, [&](std::size_t first, std::size_t size) {
      space_->values({points[0] + first, points[1] + first, zeros.data()}, size, values + first);
    });
  }
  void samples(const typename Base::PointLists& points, std::size_t count,
               const typename Base::SampleLists& samples) const override {
    std::array<T, block> unused;
    for_blocks(count, [&](std::size_t first, std::size_t size) {
      space_->samples({points[0] + first, points[1] + first, zeros.data()}, size,
                      {samples[0] + first, samples[1] + first, samples[2] + first, unused.data()});
    });
  }

 private:
  static constexpr std::size_t block = 256;
  static constexpr std::array<T, block> zeros{};

  template <class See>
  static void for_blocks(std::size_t count, const See& see) {
    for (std::size_t first = 0; first < count; first += block) see(first, std::min(block, count - first));
  }

  std::shared_ptr<const NoiseFunction<T, 3>> space_;
};

/// A number between -1 and 1 for all bits of the coordinates. It has no gradient anywhere: that is NaN.
template <class T, std::size_t dims>
class WhiteNoise final : public NoiseFunction<T, dims> {
 public:
  using Base = NoiseFunction<T, dims>;

  explicit WhiteNoise(const NoiseOptions& options) : seed_(Random::hash(options.seed + 1)) {}

  T value(const typename Base::Point& point) const override {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    std::uint64_t hash = seed_;
    bool is_finite = true;
    for (const T x : point) {
      is_finite &= std::isfinite(x);
      hash = Random::hash((hash ^ std::bit_cast<Bits>(x + T(0))) + 0x9e37'79b9'7f4a'7c15u);  // -0 is 0
    }
    const T value = static_cast<T>(static_cast<std::int64_t>(hash) >> (64 - std::numeric_limits<T>::digits)) *
                    (T(2) / static_cast<T>(std::uint64_t{1} << std::numeric_limits<T>::digits));
    return is_finite ? value : std::numeric_limits<T>::quiet_NaN();
  }
  std::array<T, 1 + dims> sample(const typename Base::Point& point) const override {
    std::array<T, 1 + dims> sample;
    sample.fill(std::numeric_limits<T>::quiet_NaN());
    sample[0] = value(point);
    return sample;
  }
  void values(const typename Base::PointLists& points, std::size_t count, T* values) const override {
    for (std::size_t i = 0; i < count; ++i) values[i] = value(at(points, i));
  }
  void samples(const typename Base::PointLists& points, std::size_t count,
               const typename Base::SampleLists& samples) const override {
    for (std::size_t i = 0; i < count; ++i) {
      const auto sample = this->sample(at(points, i));
      for (std::size_t k = 0; k < sample.size(); ++k) samples[k][i] = sample[k];
    }
  }

 private:
  static typename Base::Point at(const typename Base::PointLists& points, std::size_t i) {
    typename Base::Point point;
    for (std::size_t a = 0; a < dims; ++a) point[a] = points[a][i];
    return point;
  }

  std::uint64_t seed_;
};

}  // namespace

template <class T, std::size_t dims>
std::shared_ptr<const NoiseFunction<T, dims>> make_noise_function(const NoiseOptions& options) {
  const auto eased = [&]<class Corners>() -> std::shared_ptr<const NoiseFunction<T, dims>> {
    if (options.ease == Ease::cubic) return std::make_shared<LatticeNoise<T, Corners, Ease::cubic>>(options);
    return std::make_shared<LatticeNoise<T, Corners, Ease::quintic>>(options);
  };
  switch (options.kind) {
    case NoiseKind::perlin:
      return eased.template operator()<UnitGradientCorners<T, dims>>();
    case NoiseKind::value:
      return eased.template operator()<ValueCorners<T, dims>>();
    case NoiseKind::white:
      return std::make_shared<WhiteNoise<T, dims>>(options);
    case NoiseKind::improved:
      break;
  }
  if constexpr (dims == 2) {
    return std::make_shared<Slice<T>>(options);
  } else {
    return std::make_shared<LatticeNoise<T, EdgeGradientCorners<T>, Ease::quintic>>(options);
  }
}

template std::shared_ptr<const NoiseFunction<float, 2>> make_noise_function(const NoiseOptions&);
template std::shared_ptr<const NoiseFunction<float, 3>> make_noise_function(const NoiseOptions&);
template std::shared_ptr<const NoiseFunction<double, 2>> make_noise_function(const NoiseOptions&);
template std::shared_ptr<const NoiseFunction<double, 3>> make_noise_function(const NoiseOptions&);

}  // namespace sightline
