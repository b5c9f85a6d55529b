/// What lattice points are given: gradients of length 1, each as often as any other, whichever way one goes through the
/// lattice and whatever the seed.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/noise/noise.h"

namespace sightline {
namespace {

constexpr std::size_t direction_count = 32;

/// Gradients by number, in the order of their coordinates.
template <int dims>
class Directions {
 public:
  explicit Directions(const Noise& noise) {
    for (int i = 0; i < 4096; ++i) {
      glm::vec<dims, double> p(0);
      p.x = i;
      const auto gradient = noise.sample(p).gradient;
      if (find(gradient) == all_.size()) all_.push_back(gradient);
    }
  }

  const std::vector<glm::vec<dims, double>>& all() const { return all_; }

  std::size_t find(const glm::vec<dims, double>& gradient) const {
    return static_cast<std::size_t>(std::find(all_.begin(), all_.end(), gradient) - all_.begin());
  }

 private:
  std::vector<glm::vec<dims, double>> all_;
};

/// Pearson's statistic of counts that are to be equal. Its mean is one less than there are counts, and its variance
/// twice that; six deviations above that come by chance once in a million times, and seeds are fixed.
void expect_uniform(const std::vector<int>& counts, const std::string& what) {
  double sum = 0, statistic = 0;
  for (const int count : counts) sum += count;
  const double expected = sum / static_cast<double>(counts.size());
  for (const int count : counts) statistic += (count - expected) * (count - expected) / expected;
  const double freedom = static_cast<double>(counts.size() - 1), deviation = std::sqrt(2 * freedom);
  EXPECT_LT(statistic, freedom + 6 * deviation) << what;
  EXPECT_GT(statistic, freedom - 6 * deviation) << what << ": more even than chance";
}

template <int dims>
void expect_unit_vectors_spread_evenly() {
  const Directions<dims> directions{Noise()};
  ASSERT_EQ(directions.all().size(), direction_count);
  glm::vec<dims, double> sum(0);
  std::array<double, dims> squares{};
  for (const auto& direction : directions.all()) {
    EXPECT_NEAR(glm::dot(direction, direction), 1, 0x1p-51);
    EXPECT_LT(directions.find(-direction), direction_count);
    sum += direction;
    for (int k = 0; k < dims; ++k) squares[static_cast<std::size_t>(k)] += direction[k] * direction[k];
  }
  for (int k = 0; k < dims; ++k) {
    EXPECT_NEAR(sum[k], 0, 0x1p-46);
    // No axis is favoured: the second moment is that of the whole circle or sphere.
    EXPECT_NEAR(squares[static_cast<std::size_t>(k)], static_cast<double>(direction_count) / dims, 0x1p-46);
  }
}

TEST(Directions, AreUnitVectorsSpreadEvenly) {
  expect_unit_vectors_spread_evenly<2>();
  expect_unit_vectors_spread_evenly<3>();
}

/// Lattice points in a block, `stride` apart along each axis.
template <int dims, class See>
void for_lattice(int side, double stride, double origin, const See& see) {
  for (int i = 0; i < (dims == 2 ? side * side : side * side * side); ++i) {
    glm::vec<dims, double> p;
    for (int axis = 0, rest = i; axis < dims; ++axis, rest /= side) p[axis] = origin + stride * (rest % side);
    see(p);
  }
}

/// Strides that are powers of two leave all but few bits of coordinates alike, and 0x1p32 all 32 lowest ones. Those
/// from 2^17 to 2^31 are beyond a hash of a fold and a multiplication: directions there are off by some tenths.
template <int dims>
void expect_uniform_everywhere(int side) {
  for (const std::uint64_t seed : {0, 1, 77}) {
    const Noise noise({.seed = seed});
    const Directions<dims> directions(noise);
    for (const double stride : {1.0, 2.0, 3.0, 16.0, 255.0, 256.0, 65536.0, 0x1p32, 0x1p35}) {
      for (const double origin : {0.0, -17.0, 0x1p40 + 1}) {
        std::vector<int> counts(direction_count);
        for_lattice<dims>(side, stride, origin, [&](const glm::vec<dims, double>& p) {
          ++counts.at(directions.find(noise.sample(p).gradient));
        });
        expect_uniform(counts, std::to_string(dims) + "D, seed " + std::to_string(seed) + ", stride " +
                                   std::to_string(stride) + ", origin " + std::to_string(origin));
      }
    }
  }
}

TEST(Directions, AreEachAsOftenAsAnyOther) {
  expect_uniform_everywhere<2>(128);
  expect_uniform_everywhere<3>(26);
}

/// A pair of gradients is one of 32 * 32, each as often as any other.
template <int dims, class Other>
void expect_independent(const std::string& what, int side, const Noise& noise, const Other& other) {
  const Directions<dims> directions(noise);
  std::vector<int> counts(direction_count * direction_count);
  for_lattice<dims>(side, 1, -13, [&](const glm::vec<dims, double>& p) {
    const std::size_t first = directions.find(noise.sample(p).gradient), second = directions.find(other(p));
    ++counts.at(first * direction_count + second);
  });
  expect_uniform(counts, what);
}

template <int dims>
void expect_independent_neighbours(int side) {
  const Noise noise({.seed = 3});
  for (int code = 1; code < (dims == 2 ? 9 : 27); ++code) {
    glm::vec<dims, double> offset;
    for (int axis = 0, rest = code; axis < dims; ++axis, rest /= 3) offset[axis] = rest % 3 - 1;
    if (offset == glm::vec<dims, double>(0)) continue;
    expect_independent<dims>("neighbour " + std::to_string(code), side, noise,
                             [&](const glm::vec<dims, double>& p) { return noise.sample(p + offset).gradient; });
  }
}

TEST(Directions, OfNeighboursAreIndependent) {
  expect_independent_neighbours<2>(400);
  expect_independent_neighbours<3>(54);
}

TEST(Directions, OfSeedsAreIndependent) {
  const Noise noise({.seed = 1});
  for (const std::uint64_t seed : {0, 2, 3, 257, 1 << 20}) {
    const Noise other({.seed = seed});
    expect_independent<2>("seed " + std::to_string(seed), 400, noise,
                          [&](const glm::dvec2& p) { return other.sample(p).gradient; });
    expect_independent<3>("seed " + std::to_string(seed), 54, noise,
                          [&](const glm::dvec3& p) { return other.sample(p).gradient; });
  }
}

/// That seeds only move the lattice would show nowhere above.
TEST(Directions, OfSeedsAreNotMovedCopies) {
  const Noise noise({.seed = 1}), other({.seed = 2});
  constexpr int side = 64, window = 6;
  const auto gradient_at = [](const Noise& n, int x, int y) { return n.sample(glm::dvec2(x, y)).gradient; };
  int found = 0;
  for (int x = -side; x < side; ++x) {
    for (int y = -side; y < side; ++y) {
      int same = 0;
      for (int k = 0; k < window; ++k) same += gradient_at(other, k, 0) == gradient_at(noise, x + k, y);
      found += same == window;
    }
  }
  EXPECT_EQ(found, 0);
}

/// The twelve of 2002, four of them twice as often, and never any other.
TEST(Directions, OfImprovedNoiseAreThoseOfACubesEdges) {
  const Noise noise({.kind = NoiseKind::improved});
  std::vector<std::pair<glm::dvec3, int>> found;
  for_lattice<3>(64, 1, -32, [&](const glm::dvec3& p) {
    const glm::dvec3 gradient = noise.sample(p).gradient;
    const auto entry = std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == gradient; });
    if (entry == found.end()) {
      found.emplace_back(gradient, 1);
    } else {
      ++entry->second;
    }
  });
  ASSERT_EQ(found.size(), 12u);
  for (const auto& [gradient, count] : found) {
    EXPECT_EQ(glm::dot(gradient, gradient), 2);
    EXPECT_EQ(std::fabs(gradient.x) + std::fabs(gradient.y) + std::fabs(gradient.z), 2);
    constexpr std::array doubled{glm::dvec3(1, 1, 0), glm::dvec3(-1, 1, 0), glm::dvec3(0, -1, 1),
                                 glm::dvec3(0, -1, -1)};
    const bool is_doubled = std::find(doubled.begin(), doubled.end(), gradient) != doubled.end();
    EXPECT_NEAR(count, (is_doubled ? 2 : 1) * 64 * 64 * 64 / 16, 2000);
  }
}

}  // namespace
}  // namespace sightline
