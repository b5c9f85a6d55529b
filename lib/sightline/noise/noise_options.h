#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "sightline/noise/ease.h"

namespace sightline {

enum class NoiseKind { perlin, improved, value, white };

struct NoiseInfo {
  NoiseKind kind;
  std::string_view name;
  std::string_view description;
};
inline constexpr std::array<NoiseInfo, 4> noise_infos{{
    {NoiseKind::perlin, "perlin", "random unit gradients on the lattice, as courses teach Perlin's noise"},
    {NoiseKind::improved, "improved", "twelve gradients by Perlin's permutation, of 2002"},
    {NoiseKind::value, "value", "random values on the lattice: blocky, for contrast"},
    {NoiseKind::white, "white", "another value at every point: not coherent at all"},
}};

struct NoiseOptions {
  NoiseKind kind = NoiseKind::perlin;
  std::uint64_t seed = 0;    ///< `improved` has Perlin's own permutation with 0, and shuffles it otherwise.
  Ease ease = Ease::cubic;   ///< Of `perlin` and `value`; `improved` is quintic.
  std::uint32_t period = 0;  ///< After as many lattice points the noise repeats: a power of two, or 0 for never.
                             ///  `improved` always repeats after 256; `white` never does.
};

}  // namespace sightline
