/// How much noise has of each frequency: it is one band about a cycle per cell, and the same along axes and diagonals.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "sightline/noise/noise.h"

namespace sightline {
namespace {

using Complex = std::complex<double>;

/// In place, of a number of values that is a power of two. Cooley and Tukey, "An Algorithm for the Machine Calculation
/// of Complex Fourier Series", 1965.
void transform(std::vector<Complex>& values) {
  const std::size_t n = values.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n / 2;
    for (; (j & bit) != 0; bit /= 2) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(values[i], values[j]);
  }
  for (std::size_t half = 1; half < n; half *= 2) {
    for (std::size_t k = 0; k < half; ++k) {
      const Complex turn = std::polar(1.0, -std::numbers::pi * static_cast<double>(k) / static_cast<double>(half));
      for (std::size_t i = k; i < n; i += 2 * half) {
        const Complex a = values[i], b = turn * values[i + half];
        values[i] = a + b;
        values[i + half] = a - b;
      }
    }
  }
}

constexpr std::size_t cells = 64, samples_per_cell = 8, side = cells * samples_per_cell;

/// Energies by frequency, in cycles per domain from -side / 2 on, of a noise that repeats with the domain: so there is
/// no edge, and nothing leaks from one frequency to others.
class Spectrum {
 public:
  template <class At>  // the value at (x, y), in cells
  void add(const At& at) {
    std::vector<std::vector<Complex>> rows(side, std::vector<Complex>(side));
    for (std::size_t y = 0; y < side; ++y) {
      for (std::size_t x = 0; x < side; ++x) {
        rows[y][x] = at(static_cast<double>(x) / samples_per_cell, static_cast<double>(y) / samples_per_cell);
      }
      transform(rows[y]);
    }
    std::vector<Complex> column(side);
    for (std::size_t x = 0; x < side; ++x) {
      for (std::size_t y = 0; y < side; ++y) column[y] = rows[y][x];
      transform(column);
      for (std::size_t y = 0; y < side; ++y) energies_[y * side + x] += std::norm(column[y]);
    }
  }

  /// In cycles per cell.
  template <class Is>
  double energy(const Is& is_counted) const {
    double sum = 0;
    for (std::size_t y = 0; y < side; ++y) {
      for (std::size_t x = 0; x < side; ++x) {
        if (is_counted(frequency(x), frequency(y))) sum += energies_[y * side + x];
      }
    }
    return sum;
  }

 private:
  static double frequency(std::size_t i) {
    return (static_cast<double>(i) - (i < side / 2 ? 0.0 : static_cast<double>(side))) / cells;
  }

  std::vector<double> energies_ = std::vector<double>(side * side);
};

struct Shares {
  double high, low;      ///< Of all energy, above 2 cycles a cell, and below a quarter of one.
  double axis_diagonal;  ///< Energy within 22.5 degrees of an axis over that within 22.5 degrees of a diagonal.
};

Shares shares_of(const Spectrum& spectrum) {
  const double all = spectrum.energy([](double, double) { return true; });
  const auto is_near_axis = [](double x, double y) {
    x = std::fabs(x), y = std::fabs(y);
    return std::fmin(x, y) < std::tan(std::numbers::pi / 8) * std::fmax(x, y);
  };
  const double axis = spectrum.energy(is_near_axis);
  return {spectrum.energy([](double x, double y) { return std::hypot(x, y) > 2; }) / all,
          spectrum.energy([](double x, double y) { return std::hypot(x, y) < 0.25; }) / all, axis / (all - axis)};
}

Shares in_plane(NoiseOptions options) {
  Spectrum spectrum;
  options.period = cells;
  for (options.seed = 0; options.seed < 4; ++options.seed) {
    const Noise noise(options);
    spectrum.add([&](double x, double y) { return noise(glm::dvec2(x, y)); });
  }
  return shares_of(spectrum);
}

Shares in_slices(NoiseOptions options) {
  Spectrum spectrum;
  options.period = cells;
  const Noise noise(options);
  for (const double z : {0.1, 3.35, 7.6, 11.85}) {
    spectrum.add([&](double x, double y) { return noise(glm::dvec3(x, y, z)); });
  }
  return shares_of(spectrum);
}

void expect_band(const Shares& shares) {
  EXPECT_LT(shares.high, 0.0005);
  EXPECT_LT(shares.low, 0.15);
}

TEST(Spectrum, OfPerlinIsABand) {
  for (const Ease ease : {Ease::cubic, Ease::quintic}) {
    expect_band(in_plane({.kind = NoiseKind::perlin, .ease = ease}));
    expect_band(in_slices({.kind = NoiseKind::perlin, .ease = ease}));
  }
}

TEST(Spectrum, OfPerlinIsTheSameAlongAxesAndDiagonals) {
  EXPECT_NEAR(in_plane({.kind = NoiseKind::perlin}).axis_diagonal, 1, 0.1);
  EXPECT_NEAR(in_slices({.kind = NoiseKind::perlin}).axis_diagonal, 1, 0.1);
}

/// The contrast: value noise is mostly low, white noise the same everywhere, most of it in the corners above.
TEST(Spectrum, OfOthersIsWider) {
  EXPECT_GT(in_plane({.kind = NoiseKind::value}).low, 0.15);
  EXPECT_GT(in_plane({.kind = NoiseKind::white}).high, 0.5);
}

}  // namespace
}  // namespace sightline
