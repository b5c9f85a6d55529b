#include "sightline/noise/noise.h"

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>
#include <string>

#include "sightline/noise/require_as_many.h"

namespace sightline {
namespace {

/// As many points as are turned into lists at once: few enough for the nearest cache.
constexpr std::size_t block_size = 256;

/// Points of a block, axis by axis.
template <int dims, class T>
class Block {
 public:
  explicit Block(std::span<const glm::vec<dims, T>> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int a = 0; a < dims; ++a) lists_[static_cast<std::size_t>(a)][i] = points[i][a];
    }
  }
  std::array<const T*, dims> lists() const {
    std::array<const T*, dims> lists;
    for (std::size_t a = 0; a < dims; ++a) lists[a] = lists_[a].data();
    return lists;
  }

 private:
  std::array<std::array<T, block_size>, dims> lists_;
};

}  // namespace

Noise::Noise(const NoiseOptions& options) : options_(options) {
  const std::uint32_t period = options.period;
  if (period != 0 && (!std::has_single_bit(period) || period > 1u << 30)) {
    throw std::invalid_argument("expected a period that is a power of two up to 2^30, or 0 for none, found " +
                                std::to_string(period));
  }
  plane_float_ = make_noise_function<float, 2>(options);
  space_float_ = make_noise_function<float, 3>(options);
  plane_double_ = make_noise_function<double, 2>(options);
  space_double_ = make_noise_function<double, 3>(options);
}

template <int dims, class T>
void Noise::values(std::span<const glm::vec<dims, T>> points, std::span<T> values) const {
  require_as_many(points.size(), values.size());
  for (std::size_t first = 0; first < points.size(); first += block_size) {
    const std::size_t count = std::min(block_size, points.size() - first);
    const Block<dims, T> block(points.subspan(first, count));
    function<T, dims>().values(block.lists(), count, values.data() + first);
  }
}

template <int dims, class T>
void Noise::samples(std::span<const glm::vec<dims, T>> points, std::span<NoiseSample<T, dims>> samples) const {
  require_as_many(points.size(), samples.size());
  std::array<std::array<T, block_size>, 1 + dims> results;
  std::array<T*, 1 + dims> lists;
  for (std::size_t k = 0; k < lists.size(); ++k) lists[k] = results[k].data();
  for (std::size_t first = 0; first < points.size(); first += block_size) {
    const std::size_t count = std::min(block_size, points.size() - first);
    const Block<dims, T> block(points.subspan(first, count));
    function<T, dims>().samples(block.lists(), count, lists);
    for (std::size_t i = 0; i < count; ++i) {
      samples[first + i].value = results[0][i];
      for (int a = 0; a < dims; ++a) samples[first + i].gradient[a] = results[1 + static_cast<std::size_t>(a)][i];
    }
  }
}

template void Noise::values(std::span<const glm::vec2>, std::span<float>) const;
template void Noise::values(std::span<const glm::vec3>, std::span<float>) const;
template void Noise::values(std::span<const glm::dvec2>, std::span<double>) const;
template void Noise::values(std::span<const glm::dvec3>, std::span<double>) const;
template void Noise::samples(std::span<const glm::vec2>, std::span<NoiseSample<float, 2>>) const;
template void Noise::samples(std::span<const glm::vec3>, std::span<NoiseSample<float, 3>>) const;
template void Noise::samples(std::span<const glm::dvec2>, std::span<NoiseSample<double, 2>>) const;
template void Noise::samples(std::span<const glm::dvec3>, std::span<NoiseSample<double, 3>>) const;

}  // namespace sightline
