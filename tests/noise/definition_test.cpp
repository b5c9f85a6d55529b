/// Noise against its definition, and its gradient against differences in fifty digits.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "sightline/math/random.h"
#include "tests/noise/lattice_oracle.h"

namespace sightline {
namespace {

using test::LatticeOracle;
using test::vector_of;
using test::Wide;

/// Perlin's table, as published with "Improving Noise", 2002.
constexpr std::array<int, 256> permutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,  69,  142,
    8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,  94,  252, 219, 203,
    117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136, 171, 168, 68,  175, 74,  165,
    71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,
    55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,
    18,  169, 200, 196, 135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250,
    124, 123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189,
    28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,
    129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,
    242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114,
    67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

/// Which two components a gradient of 2002 adds up, by the four lowest bits of a hash, and with which signs.
double of_edge(int bits, const std::array<double, 3>& way) {
  const auto [x, y, z] = way;
  switch (bits & 15) {
    case 0:
      return x + y;
    case 1:
      return -x + y;
    case 2:
      return x - y;
    case 3:
      return -x - y;
    case 4:
      return x + z;
    case 5:
      return -x + z;
    case 6:
      return x - z;
    case 7:
      return -x - z;
    case 8:
      return y + z;
    case 9:
      return -y + z;
    case 10:
      return y - z;
    case 11:
      return -y - z;
    case 12:
      return y + x;
    case 13:
      return -y + z;
    case 14:
      return y - x;
    default:
      return -y - z;
  }
}

double of_2002(const std::array<double, 3>& point) {
  return test::interpolated(Ease::quintic, point,
                            [](const std::array<double, 3>& lattice, const std::array<double, 3>& way) {
                              int hash = 0;
                              for (const double x : lattice) {
                                const int cell = static_cast<int>(x - 256 * std::floor(x / 256));
                                hash = permutation[static_cast<std::size_t>((hash + cell) & 255)];
                              }
                              return of_edge(hash, way);
                            });
}

/// Most points are within the first few thousand cells, some by a hair's breadth off a lattice plane.
template <std::size_t dims>
std::array<double, dims> some_point(Random& random, double extent) {
  std::array<double, dims> point;
  for (double& x : point) {
    x = extent * (2 * random.uniform_double() - 1);
    if (random.below(16) == 0) x = std::round(x) + std::ldexp(random.uniform_double() - 0.5, -20);
  }
  return point;
}

TEST(Definition, ImprovedNoiseIsTheReference) {
  const Noise noise({.kind = NoiseKind::improved});
  Random random(7);
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto p = some_point<3>(random, i % 2 == 0 ? 1000 : 1e6);
    worst = std::fmax(worst, std::fabs(noise(vector_of(p)) - of_2002(p)));
  }
  EXPECT_LT(worst, 1e-14);
}

/// The way is exact, so what rounds are a dozen operations on numbers below 2: a few units in the last place of 1. The
/// gradient is up to 2 times as steep, and sums up more of them.
template <class T>
constexpr double value_rounding = 8 * std::numeric_limits<T>::epsilon();
template <class T>
constexpr double gradient_rounding = 32 * std::numeric_limits<T>::epsilon();

template <class T, std::size_t dims>
void expect_by_definition(const NoiseOptions& options, double extent) {
  const Noise noise(options);
  const LatticeOracle<dims> oracle(noise);
  Random random(11);
  double worst_value = 0, worst_gradient = 0;
  for (int i = 0; i < 400; ++i) {
    auto p = some_point<dims>(random, extent);
    for (double& x : p) x = static_cast<T>(x);
    const auto sample = noise.sample(glm::vec<static_cast<int>(dims), T>(vector_of(p)));
    std::array<Wide, dims> wide;
    for (std::size_t a = 0; a < dims; ++a) wide[a] = p[a];
    worst_value = std::fmax(worst_value, std::fabs(sample.value - static_cast<double>(oracle(wide))));
    const auto gradient = oracle.gradient(p);
    for (std::size_t a = 0; a < dims; ++a) {
      worst_gradient = std::fmax(worst_gradient, std::fabs(sample.gradient[static_cast<int>(a)] - gradient[a]));
    }
  }
  EXPECT_LE(worst_value, value_rounding<T>) << static_cast<int>(options.kind) << ' ' << dims;
  EXPECT_LE(worst_gradient, gradient_rounding<T>) << static_cast<int>(options.kind) << ' ' << dims;
}

class OfKind : public ::testing::TestWithParam<std::tuple<NoiseKind, Ease, std::uint32_t>> {};

TEST_P(OfKind, ValueAndGradientAreByDefinition) {
  const auto [kind, ease, period] = GetParam();
  const NoiseOptions options{.kind = kind, .seed = 9, .ease = ease, .period = period};
  expect_by_definition<double, 2>(options, 1000);
  expect_by_definition<double, 3>(options, 1000);
  expect_by_definition<double, 3>(options, 0x1p33);  // beyond what is near
  expect_by_definition<float, 2>(options, 100);
  expect_by_definition<float, 3>(options, 100);
}

INSTANTIATE_TEST_SUITE_P(Definition, OfKind,
                         ::testing::Combine(::testing::Values(NoiseKind::perlin, NoiseKind::improved, NoiseKind::value),
                                            ::testing::Values(Ease::cubic, Ease::quintic), ::testing::Values(0u, 4u)));

}  // namespace
}  // namespace sightline
