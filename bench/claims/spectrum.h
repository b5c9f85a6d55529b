#pragma once
/// How the power of a signal is spread over frequencies.

#include <functional>

namespace sightline::bench {

/// Of the power but for the mean's: that above two cycles a unit, that below a quarter of one, and that of the two
/// octaves from a half to two.
struct BandShares {
  double above = 0, below = 0, octaves = 0;
};

/// Of 128 units of a signal, 16 samples each, through a window of Hann (which spreads a line over 4 / 128 cycles), by
/// the definition of the discrete Fourier transform. NaN for a constant.
BandShares band_shares(const std::function<double(double)>& signal);

}  // namespace sightline::bench
