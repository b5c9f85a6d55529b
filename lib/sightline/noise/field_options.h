#pragma once

#include <array>
#include <string_view>

#include "sightline/noise/noise_options.h"

namespace sightline {

/// What is made of noise n at growing frequencies.
enum class FractalKind { none, fbm, turbulence, ridged };

struct FractalInfo {
  FractalKind kind;
  std::string_view name;
  std::string_view description;
};
inline constexpr std::array<FractalInfo, 4> fractal_infos{{
    {FractalKind::none, "none", "noise as it is"},
    {FractalKind::fbm, "fbm", "the sum of n: fractional Brownian motion"},
    {FractalKind::turbulence, "turbulence", "the sum of |n|: creases where n is 0"},
    {FractalKind::ridged, "ridged", "the sum of (1 - |n|)^2: ridges where n is 0"},
}};

struct FieldOptions {
  NoiseOptions noise;
  FractalKind fractal = FractalKind::none;
  int octaves = 5;        ///< 1 to 32, of a fractal. Each has a lattice of its own.
  double lacunarity = 2;  ///< From an octave to the next, how much its frequency grows: above 1, at most 16.
  double gain = 0.5;      ///< ... and its amplitude: above 0, at most 1.
  double frequency = 1;   ///< Lattice cells per unit of length: above 0.
  double warp = 0;        ///< How many cells of noise points are moved by before: 0 for none, at most 1024.
};

}  // namespace sightline
