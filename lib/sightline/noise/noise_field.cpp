#include "sightline/noise/noise_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sightline/math/random.h"
#include "sightline/noise/require_as_many.h"

namespace sightline {
namespace {

constexpr std::size_t block_size = 256;

void require(bool is_good, const char* name, const char* range, double found) {
  if (is_good) return;
  throw std::invalid_argument(std::string("expected ") + name + ' ' + range + ", found " + std::to_string(found));
}

NoiseOptions with_seed(NoiseOptions options, std::uint64_t which) {
  if (which > 0) options.seed = Random::hash(options.seed + which * 0x9e37'79b9'7f4a'7c15u);
  return options;
}

/// f(n) and f'(n).
template <class T>
struct Shaped {
  T value, slope;
};

template <class T>
Shaped<T> shaped(FractalKind kind, T n) {
  const T size = std::fabs(n), sign = n < 0 ? T(-1) : T(1);
  switch (kind) {
    case FractalKind::turbulence:
      return {size, sign};
    case FractalKind::ridged:
      return {(1 - size) * (1 - size), -2 * (1 - size) * sign};
    case FractalKind::none:
    case FractalKind::fbm:
      break;
  }
  return {n, T(1)};
}

/// Of f(n), over many points of many cells.
template <int dims>
double mean_of(FractalKind kind, const Noise& noise) {
  if (kind == FractalKind::none || kind == FractalKind::fbm) return 0;
  constexpr int count = 1 << 14;
  std::vector<glm::vec<dims, double>> points(count);
  Random random(1);
  for (auto& p : points) {
    for (int axis = 0; axis < dims; ++axis) p[axis] = 4096 * random.uniform_double();
  }
  std::vector<double> values(count);
  noise.values<dims, double>(points, values);
  double sum = 0;
  for (const double n : values) sum += shaped(kind, n).value;
  return sum / count;
}

}  // namespace

NoiseField::NoiseField(const FieldOptions& options) : options_(options) {
  const int count = options.fractal == FractalKind::none ? 1 : options.octaves;
  require(count >= 1 && count <= 32, "a number of octaves", "from 1 to 32", count);
  require(options.lacunarity > 1 && options.lacunarity <= 16, "a lacunarity", "above 1, at most 16",
          options.lacunarity);
  require(options.gain > 0 && options.gain <= 1, "a gain", "above 0, at most 1", options.gain);
  require(options.frequency > 0 && options.frequency <= 0x1p100, "a frequency", "above 0, at most 2^100",
          options.frequency);
  require(options.warp >= 0 && options.warp <= 1024, "a warp", "from 0 to 1024", options.warp);
  double frequency = options.frequency, amplitude = 1;
  for (int i = 0; i < count; ++i) {
    octaves_.push_back({Noise(with_seed(options.noise, static_cast<std::uint64_t>(i))), frequency, amplitude});
    frequency *= options.lacunarity;
    amplitude *= options.gain;
  }
  for (std::uint64_t axis = 0; axis < 3 && options.warp > 0; ++axis) {
    warps_.emplace_back(with_seed(options.noise, 64 + axis));
  }
  means_ = {mean_of<2>(options.fractal, octaves_[0].noise), mean_of<3>(options.fractal, octaves_[0].noise)};
}

double NoiseField::weight_of(const Octave& octave, double footprint) const {
  // In cells: a quarter is fine, a half is not.
  const double t = std::clamp(4 * octave.frequency * std::fabs(footprint) - 1, 0.0, 1.0);
  return 1 - t * t * (3 - 2 * t);
}

int NoiseField::octaves_within(double footprint) const {
  return static_cast<int>(std::count_if(octaves_.begin(), octaves_.end(),
                                        [&](const Octave& octave) { return weight_of(octave, footprint) > 0; }));
}

double NoiseField::amplitude() const {
  double sum = 0;
  for (const Octave& octave : octaves_) sum += octave.amplitude;
  return sum;
}

double NoiseField::lost_amplitude(double footprint) const {
  double sum = 0;
  for (const Octave& octave : octaves_) {
    const double weight = weight_of(octave, footprint);
    sum += octave.amplitude * octave.amplitude * (1 - weight * weight);
  }
  return std::sqrt(sum);
}

/// Up to block_size points with what is found of them, axis by axis. A single point is a block of one, so that it goes
/// through the very same operations.
template <int dims, class T, bool has_gradient>
class NoiseField::Block {
 public:
  /// With one footprint for all points, or one for each.
  Block(const NoiseField& field, std::span<const glm::vec<dims, T>> points, std::span<const T> footprints)
      : field_(field), count_(points.size()) {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t a = 0; a < axes; ++a) points_[a][i] = points[i][static_cast<int>(a)];
    }
    if (!field.warps_.empty()) bend();
    for (auto& list : sums_) std::fill_n(list.begin(), count_, T(0));
    const double mean = field.means_[axes - 2];
    for (const Octave& octave : field.octaves_) {
      if (footprints.size() == 1)
        add(octave, field.weight_of(octave, footprints[0]), mean);
      else
        add_each(octave, footprints, mean);
    }
    if (has_gradient && !field.warps_.empty()) straighten();
  }

  T value(std::size_t i) const { return sums_[0][i]; }
  NoiseSample<T, dims> sample(std::size_t i) const {
    NoiseSample<T, dims> sample{sums_[0][i], {}};
    for (std::size_t a = 0; a < axes; ++a) sample.gradient[static_cast<int>(a)] = sums_[1 + a][i];
    return sample;
  }

 private:
  static constexpr std::size_t axes = dims, results = has_gradient ? 1 + axes : 1;
  using List = std::array<T, block_size>;

  /// Noise, and its derivatives by P, at points times a frequency.
  void ask(const Noise& noise, double frequency) {
    const T scale = static_cast<T>(frequency);
    std::array<const T*, axes> scaled;
    for (std::size_t a = 0; a < axes; ++a) {
      for (std::size_t i = 0; i < count_; ++i) scaled_[a][i] = scale * points_[a][i];
      scaled[a] = scaled_[a].data();
    }
    if constexpr (has_gradient) {
      std::array<T*, 1 + axes> lists;
      for (std::size_t k = 0; k < lists.size(); ++k) lists[k] = found_[k].data();
      noise.function<T, axes>().samples(scaled, count_, lists);
    } else {
      noise.function<T, axes>().values(scaled, count_, found_[0].data());
    }
  }

  void add(const Octave& octave, double weight, double mean) {
    const T rest = static_cast<T>(octave.amplitude * (1 - weight) * mean);
    if (!(weight > 0)) {
      for (std::size_t i = 0; i < count_; ++i) sums_[0][i] += rest;
      return;
    }
    ask(octave.noise, octave.frequency);
    for (std::size_t i = 0; i < count_; ++i) add_at(i, octave, weight, rest);
  }

  /// By a weight of each point's own.
  void add_each(const Octave& octave, std::span<const T> footprints, double mean) {
    std::array<double, block_size> weights;
    bool is_seen = false;
    for (std::size_t i = 0; i < count_; ++i) {
      weights[i] = field_.weight_of(octave, footprints[i]);
      is_seen |= weights[i] > 0;
    }
    if (is_seen) ask(octave.noise, octave.frequency);
    for (std::size_t i = 0; i < count_; ++i) {
      const T rest = static_cast<T>(octave.amplitude * (1 - weights[i]) * mean);
      if (weights[i] > 0)
        add_at(i, octave, weights[i], rest);
      else
        sums_[0][i] += rest;
    }
  }

  void add_at(std::size_t i, const Octave& octave, double weight, T rest) {
    const T scale = static_cast<T>(octave.amplitude * weight), steepness = static_cast<T>(octave.frequency);
    const Shaped<T> f = shaped(field_.options_.fractal, found_[0][i]);
    sums_[0][i] += scale * f.value + rest;
    for (std::size_t k = 1; k < results; ++k) sums_[k][i] += scale * f.slope * steepness * found_[k][i];
  }

  /// Moves points by noise, each coordinate by its own, and remembers the derivatives of where they go.
  void bend() {
    const T reach = static_cast<T>(field_.options_.warp), back = static_cast<T>(1 / field_.options_.frequency);
    std::array<List, axes> moved;
    for (std::size_t a = 0; a < axes; ++a) {
      ask(field_.warps_[a], field_.options_.frequency);
      for (std::size_t i = 0; i < count_; ++i) moved[a][i] = points_[a][i] + reach * back * found_[0][i];
      for (std::size_t k = 1; k < results; ++k) {
        for (std::size_t i = 0; i < count_; ++i) bends_[a][k - 1][i] = reach * found_[k][i] + T(k - 1 == a ? 1 : 0);
      }
    }
    points_ = moved;
  }

  /// Derivatives by where points were, from those by where they went.
  void straighten() {
    for (std::size_t i = 0; i < count_; ++i) {
      std::array<T, axes> gradient{};
      for (std::size_t k = 0; k < axes; ++k) {
        for (std::size_t a = 0; a < axes; ++a) gradient[k] += bends_[a][k][i] * sums_[1 + a][i];
      }
      for (std::size_t k = 0; k < axes; ++k) sums_[1 + k][i] = gradient[k];
    }
  }

  const NoiseField& field_;
  std::size_t count_;
  std::array<List, axes> points_, scaled_;
  std::array<List, results> found_, sums_;
  std::array<std::array<List, has_gradient ? axes : 0>, axes> bends_;
};

template <bool has_gradient, int dims, class T, class Take>
void NoiseField::for_blocks(std::span<const glm::vec<dims, T>> points, std::span<const T> footprints,
                            const Take& take) const {
  for (std::size_t first = 0; first < points.size(); first += block_size) {
    const std::size_t count = std::min(block_size, points.size() - first);
    const std::span<const T> of_block = footprints.size() == 1 ? footprints : footprints.subspan(first, count);
    const Block<dims, T, has_gradient> block(*this, points.subspan(first, count), of_block);
    for (std::size_t i = 0; i < count; ++i) take(first + i, block, i);
  }
}

template <int dims, class T>
T NoiseField::operator()(const glm::vec<dims, T>& p, T footprint) const {
  return Block<dims, T, false>(*this, {&p, 1}, {&footprint, 1}).value(0);
}

template <int dims, class T>
NoiseSample<T, dims> NoiseField::sample(const glm::vec<dims, T>& p, T footprint) const {
  return Block<dims, T, true>(*this, {&p, 1}, {&footprint, 1}).sample(0);
}

template <int dims, class T>
void NoiseField::values(std::span<const glm::vec<dims, T>> points, std::span<T> values, T footprint) const {
  require_as_many(points.size(), values.size());
  for_blocks<false>(points, std::span<const T>(&footprint, 1),
                    [&](std::size_t at, const auto& block, std::size_t i) { values[at] = block.value(i); });
}

template <int dims, class T>
void NoiseField::samples(std::span<const glm::vec<dims, T>> points, std::span<NoiseSample<T, dims>> samples,
                         T footprint) const {
  require_as_many(points.size(), samples.size());
  for_blocks<true>(points, std::span<const T>(&footprint, 1),
                   [&](std::size_t at, const auto& block, std::size_t i) { samples[at] = block.sample(i); });
}

template <int dims, class T>
void NoiseField::samples(std::span<const glm::vec<dims, T>> points, std::span<const T> footprints,
                         std::span<NoiseSample<T, dims>> samples) const {
  require_as_many(points.size(), samples.size());
  require_as_many(points.size(), footprints.size());
  for_blocks<true>(points, footprints,
                   [&](std::size_t at, const auto& block, std::size_t i) { samples[at] = block.sample(i); });
}

template float NoiseField::operator()(const glm::vec2&, float) const;
template NoiseSample<float, 2> NoiseField::sample(const glm::vec2&, float) const;
template void NoiseField::values(std::span<const glm::vec2>, std::span<float>, float) const;
template void NoiseField::samples(std::span<const glm::vec2>, std::span<NoiseSample<float, 2>>, float) const;
template double NoiseField::operator()(const glm::dvec2&, double) const;
template NoiseSample<double, 2> NoiseField::sample(const glm::dvec2&, double) const;
template void NoiseField::values(std::span<const glm::dvec2>, std::span<double>, double) const;
template void NoiseField::samples(std::span<const glm::dvec2>, std::span<NoiseSample<double, 2>>, double) const;
template float NoiseField::operator()(const glm::vec3&, float) const;
template NoiseSample<float, 3> NoiseField::sample(const glm::vec3&, float) const;
template void NoiseField::values(std::span<const glm::vec3>, std::span<float>, float) const;
template void NoiseField::samples(std::span<const glm::vec3>, std::span<NoiseSample<float, 3>>, float) const;
template double NoiseField::operator()(const glm::dvec3&, double) const;
template NoiseSample<double, 3> NoiseField::sample(const glm::dvec3&, double) const;
template void NoiseField::values(std::span<const glm::dvec3>, std::span<double>, double) const;
template void NoiseField::samples(std::span<const glm::dvec3>, std::span<NoiseSample<double, 3>>, double) const;
template void NoiseField::samples(std::span<const glm::dvec3>, std::span<const double>,
                                  std::span<NoiseSample<double, 3>>) const;

}  // namespace sightline
