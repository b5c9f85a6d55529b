#pragma once
/// Which rays to area lamps a picture can do without, and by how much that may scatter it.
///
/// A ray is sent with a probability p only. What it finds, v of the light f, counts as g + (v - g) / p of f, and one
/// that stays at home as g: a guess of v. The first samples of a pixel send all their rays; where these agree the
/// others take what they found for g, and need few rays to keep that true.
///   C1  Unbiased: p and g may depend on everything but the draw that decides, and the mean over that is v f.
///   C2  With b the square of the error that a ray may add to its sample, p = 1 / (1 + b / (q f^2)) adds the expected
///       square (1 / p - 1) (v - g)^2 f^2 <= b (v - g)^2 / q. Where nothing is known g = 1/2, and (v - g)^2 <= 1/4 = q.
///       Where n rays have found the same, and a share s of the lamp says otherwise, that was likely by (1 - s)^n, and
///       the others err by s: in the mean by no more than q, the largest value of s (1 - s)^n, at s = 1 / (n + 1).
///   C3  Squares of the rays of a pixel's sample come to no more than S E^2, of S samples whose errors are independent:
///       so the standard error that is added to the pixel is at most E, whatever is seen. Draws are more even than
///       independent ones, so it is less. A pixel that stops after s samples has sqrt(S / s) times as much. Surfaces at
///       the same depth of a sample share draws: what these add together may be more where they err alike.
///   C4  No ray is less likely than 1 in 4, so that what a surprise adds is no more than four lights: rare large ones
///       would be specks that the eye sees, though their mean square is small.
/// Rays that were sent as a trial choose those that follow, but no trial is thrown away for it: Kirk and Arvo,
/// "Unbiased Sampling Techniques for Image Synthesis", 1991, show what is wrong with stopping once trials agree.
/// Shirley, Wang and Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", 1996, on choosing rays.

#include <algorithm>
#include <cstdint>

#include "sightline/texture/color.h"

namespace sightline {

/// What a pixel's first samples found of each lamp: two bits a lamp, for lit and for dark parts of it.
class LampsSeen {
 public:
  static constexpr std::uint32_t most_lamps = 16;  ///< Of further ones nothing is known.
  static constexpr std::uint32_t trials = 8;       ///< Samples that send all rays.

  LampsSeen() = default;
  explicit LampsSeen(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits() const { return bits_; }

  void add(std::uint32_t lamp, bool is_lit, bool is_dark) {
    if (lamp < most_lamps) bits_ |= (std::uint32_t{is_lit} | std::uint32_t{is_dark} << 1) << 2 * lamp;
  }
  /// Takes in those of a sample. One that has not asked a lamp says nothing of it for the others either.
  void add(LampsSeen sample) {
    const std::uint32_t asked = (sample.bits_ | sample.bits_ >> 1) & 0x5555'5555u, silent = 0x5555'5555u & ~asked;
    bits_ |= sample.bits_ | silent | silent << 1;
  }
  bool is_always_lit(std::uint32_t lamp) const { return of(lamp) == 1; }
  bool is_always_dark(std::uint32_t lamp) const { return of(lamp) == 2; }

 private:
  std::uint32_t of(std::uint32_t lamp) const { return lamp < most_lamps ? bits_ >> 2 * lamp & 3 : 0; }

  std::uint32_t bits_ = 0;
};

/// A ray's probability, and what is taken for granted of it.
struct ShadowChoice {
  float guess = 0;
  double probability = 1;
};

/// \param light what arrives if nothing is in between, f; of it the luminance counts.
/// \param allowed b of C2. 0 sends all.
inline ShadowChoice choose_shadow_ray(const Color& light, double allowed, LampsSeen seen, std::uint32_t lamp) {
  constexpr double n = LampsSeen::trials, ratio = n / (n + 1);
  constexpr double ratio2 = ratio * ratio, ratio4 = ratio2 * ratio2, doubt = ratio4 * ratio4 / (n + 1);
  static_assert(LampsSeen::trials == 8);
  if (!(allowed > 0)) return {};
  const double f = 0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z;
  const bool is_lit = seen.is_always_lit(lamp), is_known = is_lit || seen.is_always_dark(lamp);
  const double square = (is_known ? doubt : 0.25) * f * f;
  return {is_known ? float(is_lit) : 0.5f, std::max(0.25, square / (square + allowed))};  // C4
}

}  // namespace sightline
