/// How large noise gets: what theory says, kept by everything and all but reached.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/noise/kernel.h"
#include "sightline/noise/noise.h"

namespace sightline {
namespace {

/// For bounds that are reached where roundings add up.
constexpr double rounding = 0x1p-50;

template <int dims>
double largest(const Noise& noise, const std::vector<glm::vec<dims, double>>& points) {
  std::vector<double> values(points.size());
  noise.values<dims, double>(points, values);
  double most = 0;
  for (const double value : values) most = std::fmax(most, std::fabs(value));
  return most;
}

template <int dims>
std::vector<glm::vec<dims, double>> scattered(int count) {
  std::vector<glm::vec<dims, double>> points(static_cast<std::size_t>(count));
  Random random(3);
  for (auto& p : points) {
    for (int axis = 0; axis < dims; ++axis) p[axis] = 4096 * random.uniform_double();
  }
  return points;
}

TEST(Bounds, OfPerlinInThePlane) {
  for (const Ease ease : {Ease::cubic, Ease::quintic}) {
    const Noise noise({.ease = ease});
    EXPECT_LE(largest(noise, scattered<2>(1'000'000)), std::sqrt(0.5) + rounding);
    // The bound belongs to the middle of a cell whose gradients all point there. Of a million one almost is.
    std::vector<glm::dvec2> middles;
    for (int i = 0; i < 1 << 20; ++i) middles.emplace_back(i % 1024 + 0.5, i / 1024 + 0.5);
    const double most = largest(noise, middles);
    EXPECT_LE(most, std::sqrt(0.5) + rounding);
    EXPECT_GE(most, 0.99 * std::sqrt(0.5));
  }
}

/// Eight corners at random never all point to the middle, so that the bound is only kept ...
TEST(Bounds, OfPerlinInSpace) {
  for (const Ease ease : {Ease::cubic, Ease::quintic}) {
    const double most = largest(Noise({.ease = ease}), scattered<3>(2'000'000));
    EXPECT_LE(most, std::sqrt(0.75));
    EXPECT_GE(most, 0.6);
  }
}

/// ... and reached by corners that do: the unit vector to the middle of the cell has the signs of the way.
template <std::size_t dimensions>
class PointingCorners {
 public:
  static constexpr std::size_t dims = dimensions;

  template <bool has_gradient, class D, class V = hn::Vec<D>>
  HWY_INLINE NoiseNode<V, dims, has_gradient> at(D d, Keys<D>, const std::array<V, dims>& way) const {
    static_assert(!has_gradient);
    V sum = hn::Abs(way[0]);
    for (std::size_t a = 1; a < dims; ++a) sum = hn::Add(sum, hn::Abs(way[a]));
    return {hn::Mul(sum, hn::Set(d, 1 / std::sqrt(static_cast<double>(dims))))};
  }

  const HashedLattice lattice{0, 0};
};

template <std::size_t dims, Ease ease>
void expect_bound_of_pointing_corners() {
  const NoiseKernel<double, PointingCorners<dims>, ease> kernel{PointingCorners<dims>()};
  const double bound = std::sqrt(static_cast<double>(dims)) / 2;
  Random random(5);
  for (int i = 0; i < 100'000; ++i) {
    std::array<double, dims> point;
    for (double& x : point) x = random.uniform_double();
    double value = 0;
    kernel.template at<false>(point.data(), &value);
    EXPECT_LE(value, bound + rounding);
  }
  std::array<double, dims> middle;
  middle.fill(0.5);
  double value = 0;
  kernel.template at<false>(middle.data(), &value);
  EXPECT_GE(value, 0.99 * bound);
}

TEST(Bounds, AreReachedByCornersThatPointToTheMiddle) {
  expect_bound_of_pointing_corners<2, Ease::cubic>();
  expect_bound_of_pointing_corners<2, Ease::quintic>();
  expect_bound_of_pointing_corners<3, Ease::cubic>();
  expect_bound_of_pointing_corners<3, Ease::quintic>();
}

/// Every cell is asked in its middle, and from the best ones uphill. The bound is known rounded to nine digits.
TEST(Bounds, OfImprovedNoise) {
  const Noise noise({.kind = NoiseKind::improved});
  constexpr double bound = 1.0363538115;
  EXPECT_LE(largest(noise, scattered<3>(2'000'000)), bound);
  std::vector<glm::dvec3> best;
  std::vector<glm::vec3> row(256);
  std::vector<float> values(row.size());
  for (int i = 0; i < 256 * 256; ++i) {
    for (int x = 0; x < 256; ++x) row[static_cast<std::size_t>(x)] = glm::vec3(x, i % 256, i / 256) + 0.5f;
    noise.values<3, float>(row, values);
    for (std::size_t x = 0; x < row.size(); ++x) {
      if (std::fabs(values[x]) >= 1) best.emplace_back(row[x]);
    }
  }
  ASSERT_FALSE(best.empty());
  double most = 0;
  for (glm::dvec3 p : best) {
    double here = std::fabs(noise(p));
    for (double step = 0.125; step > 0x1p-20; step /= 2) {
      for (bool is_moving = true; is_moving;) {
        is_moving = false;
        for (int way = 0; way < 6; ++way) {
          glm::dvec3 there = p;
          there[way / 2] += way % 2 == 0 ? step : -step;
          if (const double value = std::fabs(noise(there)); value > here) p = there, here = value, is_moving = true;
        }
      }
    }
    most = std::fmax(most, here);
  }
  EXPECT_LE(most, bound);
  EXPECT_GE(most, 0.99 * bound);
}

TEST(Bounds, OfValuesAndWhiteNoise) {
  for (const NoiseKind kind : {NoiseKind::value, NoiseKind::white}) {
    const double most = largest(Noise({.kind = kind}), scattered<2>(1'000'000));
    EXPECT_LE(most, 1);
    EXPECT_GE(most, 0.99);
  }
}

}  // namespace
}  // namespace sightline
