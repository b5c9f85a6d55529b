/// The same noise from any number of threads, in batches of any size, and other noise from any other seed.

#include <gtest/gtest.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/noise/noise_field.h"

namespace sightline {
namespace {

/// Some far away, and some that are no numbers, among the others.
template <int dims, class T>
std::vector<glm::vec<dims, T>> some_points(std::size_t count, std::uint64_t seed) {
  std::vector<glm::vec<dims, T>> points(count);
  Random random(seed);
  for (auto& p : points) {
    const double extent = random.below(20) == 0 ? 1e11 : 100;
    for (int axis = 0; axis < dims; ++axis) p[axis] = static_cast<T>(extent * (2 * random.uniform_double() - 1));
    if (random.below(100) == 0) p.x = std::numeric_limits<T>::infinity();
  }
  return points;
}

template <class T>
bool is_same(T a, T b) {
  return a == b ? std::signbit(a) == std::signbit(b) : std::isnan(a) && std::isnan(b);
}

template <class T>
bool are_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](T x, T y) { return is_same(x, y); });
}

/// `noise` is Noise or NoiseField.
template <int dims, class T, class Asked>
void expect_same_in_sizes(const Asked& noise, const std::string& what) {
  const auto points = some_points<dims, T>(100, 9);
  const std::span<const glm::vec<dims, T>> all(points);
  std::vector<T> single(points.size());
  std::vector<NoiseSample<T, dims>> single_samples(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    single[i] = noise(points[i]);
    single_samples[i] = noise.sample(points[i]);
    EXPECT_TRUE(is_same(single[i], single_samples[i].value)) << what << ' ' << i;
  }
  for (std::size_t size = 1; size <= points.size(); ++size) {
    const std::size_t first = points.size() - size;
    std::vector<T> values(size);
    std::vector<NoiseSample<T, dims>> samples(size);
    noise.template values<dims, T>(all.subspan(first), values);
    noise.template samples<dims, T>(all.subspan(first), samples);
    int wrong = 0;
    for (std::size_t i = 0; i < size; ++i) {
      wrong += !is_same(values[i], single[first + i]) || !is_same(samples[i].value, single[first + i]);
      for (int a = 0; a < dims; ++a) {
        wrong += !is_same(samples[i].gradient[a], single_samples[first + i].gradient[a]);
      }
    }
    EXPECT_EQ(wrong, 0) << what << ", " << size << " points";
  }
}

template <class Asked>
void expect_same_in_sizes(const Asked& noise, const std::string& what) {
  expect_same_in_sizes<2, float>(noise, what + " in the plane, float");
  expect_same_in_sizes<3, float>(noise, what + " in space, float");
  expect_same_in_sizes<2, double>(noise, what + " in the plane, double");
  expect_same_in_sizes<3, double>(noise, what + " in space, double");
}

TEST(Determinism, InBatchesOfAnySize) {
  for (const NoiseInfo& info : noise_infos) {
    for (const std::uint32_t period : {0u, 32u}) {
      const NoiseOptions noise{.kind = info.kind, .seed = 4, .ease = Ease::quintic, .period = period};
      const std::string name(info.name);
      expect_same_in_sizes(Noise(noise), name);
      for (const FractalInfo& fractal : fractal_infos) {
        expect_same_in_sizes(
            NoiseField({.noise = noise, .fractal = fractal.kind, .octaves = 3, .frequency = 1.7, .warp = 0.5}),
            name + ' ' + std::string(fractal.name));
      }
    }
  }
}

TEST(Determinism, OnAnyNumberOfThreads) {
  const auto points = some_points<3, float>(200'000, 2);
  const std::span<const glm::vec3> all(points);
  const NoiseField field({.noise = {}, .fractal = FractalKind::turbulence, .octaves = 3});
  std::vector<float> expected(points.size());
  field.values<3, float>(all, expected);
  for (const std::size_t threads : {1u, 2u, 7u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<float> values(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1000), [&](const auto& range) {
      field.values<3, float>(all.subspan(range.begin(), range.size()),
                             std::span(values).subspan(range.begin(), range.size()));
    });
    EXPECT_TRUE(are_same(values, expected)) << threads;
  }
}

TEST(Determinism, BySeedAlone) {
  const auto points = some_points<3, double>(2000, 3);
  const auto values_of = [&](const NoiseOptions& options) {
    std::vector<double> values(points.size());
    Noise(options).values<3, double>(points, values);
    return values;
  };
  for (const NoiseInfo& info : noise_infos) {
    const auto reference = values_of({.kind = info.kind, .seed = 5});
    EXPECT_TRUE(are_same(reference, values_of({.kind = info.kind, .seed = 5}))) << info.name;
    for (const std::uint64_t seed :
         {std::uint64_t{0}, std::uint64_t{4}, std::uint64_t{6}, 5 + (std::uint64_t{1} << 40)}) {
      const auto other = values_of({.kind = info.kind, .seed = seed});
      // Products of deviations from a mean of 0: n of them add up to about the root of n.
      double product = 0, square = 0;
      for (std::size_t i = 0; i < other.size(); ++i) {
        if (std::isnan(other[i])) continue;
        product += reference[i] * other[i];
        square += reference[i] * reference[i];
      }
      EXPECT_LT(std::fabs(product) / square, 0.15) << info.name << ' ' << seed;
    }
  }
}

/// Written down once: the lattice is the same on every machine and in every later version. Processors that multiply and
/// add at once round less, so values are the same but for a few roundings.
TEST(Determinism, OnEveryMachine) {
  constexpr std::array known{std::pair(-0x1.31f25b6a43181p-4, -0x1.3f7f3ep-3),
                             std::pair(-0x1.06e1c3cp-1, -0x1.b7ddfcp-2), std::pair(0x1.6ff2cbaf8p-2, 0x1.68362p-4),
                             std::pair(0x1.77417e72468e8p-3, 0x1.a05a9p-2)};
  static_assert(known.size() == noise_infos.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    const Noise noise({.kind = noise_infos[i].kind, .seed = 42});
    EXPECT_NEAR(noise(glm::dvec3(3.25, -7.5, 1e10 + 0.125)), known[i].first, 0x1p-49) << noise_infos[i].name;
    EXPECT_NEAR(noise(glm::vec2(-0.75f, 12.375f)), known[i].second, 0x1p-20) << noise_infos[i].name;
  }
}

}  // namespace
}  // namespace sightline
