#include "bench/claims/spectrum.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace sightline::bench {
namespace {

constexpr std::size_t units = 128, per_unit = 16, count = units * per_unit;

/// cos(2 pi i / count).
const std::vector<double>& cosines() {
  static const std::vector<double> table = [] {
    std::vector<double> made(count);
    for (std::size_t i = 0; i < count; ++i) made[i] = std::cos(2 * std::numbers::pi * static_cast<double>(i) / count);
    return made;
  }();
  return table;
}

}  // namespace

BandShares band_shares(const std::function<double(double)>& signal) {
  const std::vector<double>& cosine = cosines();
  std::vector<double> samples(count);
  double mean = 0;
  for (std::size_t i = 0; i < count; ++i) {
    samples[i] = signal(static_cast<double>(i) / per_unit);
    mean += samples[i] / count;
  }
  for (std::size_t i = 0; i < count; ++i) samples[i] = (samples[i] - mean) * 0.5 * (1 - cosine[i]);
  double all = 0;
  BandShares shares;
  for (std::size_t k = 1; k <= count / 2; ++k) {
    double real = 0, imaginary = 0;
    for (std::size_t i = 0, turn = 0; i < count; ++i, turn = (turn + k) % count) {
      real += samples[i] * cosine[turn];
      imaginary += samples[i] * cosine[(turn + count / 4) % count];  // -sin
    }
    const double power = real * real + imaginary * imaginary, frequency = static_cast<double>(k) / units;
    all += power;
    if (frequency > 2) shares.above += power;
    if (frequency < 0.25) shares.below += power;
    if (frequency >= 0.5 && frequency <= 2) shares.octaves += power;
  }
  return {shares.above / all, shares.below / all, shares.octaves / all};
}

}  // namespace sightline::bench
