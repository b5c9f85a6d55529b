#pragma once

#include <cstdint>

namespace sightline {

inline constexpr std::uint32_t most_samples = 1u << 20, most_bounces = 1000;

/// How a scene is meant to be rendered; who renders may do otherwise.
struct RenderHints {
  std::uint32_t samples = 1;     ///< Of a pixel, 1 to most_samples; one alone goes through its middle.
  std::uint32_t depth = 8;       ///< Surfaces that light may come by after the first, up to most_bounces.
  bool interreflection = false;  ///< Light that surfaces scatter lights others.
  double cut_off = 1.0 / 512;    ///< Rays that could add less than this share to a pixel are not traced. Half a step
                                 ///< of 8 bits; 0 traces all. Hall and Greenberg, "A Testbed for Realistic Image
                                 ///< Synthesis", 1983.
  double shadow_error = 0x1p-8;  ///< That rays to area lights which are left out may add to a pixel's luminance, as its
                                 ///< standard error; 0 leaves out none (render/shadow_choice.h).
};

}  // namespace sightline
