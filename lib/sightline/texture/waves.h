#pragma once
/// Periodic functions with their means over an interval in closed form: textures made of them need no supersampling.
///
/// Norton, Rockwood and Skolmoski, "Clamping: A Method of Antialiasing Textured Surfaces by Bandwidth Limiting in
/// Object Space", 1982; Apodaca and Gritz, "Advanced RenderMan", 1999, chapter 11; Quilez, "Filtering the checkerboard
/// pattern", 2017.
///   W1  A narrow interval holds at most one jump of a wave. Its mean is the value in the middle and the jump's share:
///       nothing cancels, however narrow it is.
///   W2  A wide interval's mean is that of a period and what its ends are off by, divided by its width.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace sightline {

/// x mod 1, in [0, 1): x - floor(x), which is exact but for negative x. Just below zero, where it would round to 1, it
/// is the number below 1. Beyond 2^52 all numbers are whole. Of what is not finite NaN.
inline double fraction(double x) {
  constexpr double below_one = 1 - 0x1p-53;
  const double rest = x - std::floor(x);
  return rest > below_one ? below_one : rest;
}

enum class Wave { sine, sawtooth, crease };
inline constexpr std::array<std::string_view, 3> wave_names{"sine", "sawtooth", "crease"};

/// A wave's mean value, and the mean of its derivative.
struct WaveMean {
  double value, slope;
};

/// Of x mod 1 over an interval around a point of phase f, in [0, 1).
inline WaveMean sawtooth_mean(double f, double width) {
  if (!(width > 0)) return {f, 1};
  const double half = width / 2;
  if (width < 1) {  // W1
    const double lifted = std::max(0.0, half - f) / width, dropped = std::max(0.0, f + half - 1) / width;
    const bool has_jump = lifted > 0 || dropped > 0;
    return {std::clamp(f + lifted - dropped, 0.0, 1.0), has_jump ? 1 - 1 / width : 1};
  }
  if (!std::isfinite(width)) return {0.5, 0};
  const double end = fraction(f + half), start = fraction(f - half);  // W2
  return {0.5 - (end * (1 - end) - start * (1 - start)) / (2 * width), (end - start) / width};
}

/// Of (1 - cos(2 pi x)) / 2: 0 at whole x, 1 between.
inline WaveMean sine_mean(double f, double width) {
  using std::numbers::pi;
  // sin(a) / a, which is 1 - a^2 / 6 and 1 to the last bit where a^2 < 2^-53.
  const double a = pi * std::fabs(width);
  const double damping = a < 0x1p-27 ? 1 : (std::isfinite(a) ? std::sin(a) / a : 0);
  return {0.5 - 0.5 * damping * std::cos(2 * pi * f), pi * damping * std::sin(2 * pi * f)};
}

/// Of |2 (x mod 1) - 1|^sharpness: 1 at whole x, the narrower around them the sharper. `sharpness` is at least 1.
inline WaveMean crease_mean(double f, double width, double sharpness) {
  const auto value = [&](double phase) { return std::pow(std::fabs(2 * phase - 1), sharpness); };
  const double slope = 2 * f < 1 ? -2 * sharpness : 2 * sharpness;
  // The integral's difference would cancel where the wave is as good as straight.
  if (!(width > 0x1p-20)) return {value(f), slope * std::pow(std::fabs(2 * f - 1), sharpness - 1)};
  const double mean = 1 / (sharpness + 1);
  if (!std::isfinite(width)) return {mean, 0};
  const auto integral = [&](double phase) {
    const double x = 2 * phase - 1;
    return (1 + std::copysign(std::pow(std::fabs(x), sharpness + 1), x)) * mean / 2;
  };
  const double half = width / 2;
  const double end = f + half, start = f - half;
  const double periods = std::floor(end) - std::floor(start);
  return {std::clamp((periods * mean + (integral(fraction(end)) - integral(fraction(start)))) / width, 0.0, 1.0),
          (value(fraction(end)) - value(fraction(start))) / width};
}

/// `sharpness` is that of the crease.
inline WaveMean wave_mean(Wave wave, double f, double width, double sharpness) {
  if (wave == Wave::sine) return sine_mean(f, width);
  return wave == Wave::sawtooth ? sawtooth_mean(f, width) : crease_mean(f, width, sharpness);
}

/// Of what is 1 in even and -1 in odd cells of size 1, over an interval around a point at `place`, in [0, 1), of a
/// cell.
inline double square_mean(bool is_odd, double place, double width) {
  const double sign = is_odd ? -1 : 1;
  if (!(width > 0)) return sign;
  const double half = width / 2;
  if (width < 1) return sign * (1 - 2 * std::max(0.0, half - std::min(place, 1 - place)) / width);  // W1
  if (!std::isfinite(width)) return 0;
  const auto integral = [](double x) {  // from the start of such a cell: up to 1 and down again
    const double phase = 2 * fraction(x / 2);
    return phase < 1 ? phase : 2 - phase;
  };
  return sign * (integral(place + half) - integral(place - half)) / width;  // W2
}

}  // namespace sightline
