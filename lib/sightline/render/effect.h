#pragma once
/// What a picture may need simulated, and how much of it was.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace sightline {

enum class Effect : std::uint8_t {
  meshes,
  instances,  ///< Meshes by two levels of structures; without, triangles of all are in one.
  solids,
  direct_light,
  hard_shadow,
  soft_shadow,  ///< Of area lights.
  mirror,
  glossy,
  refraction,
  absorption,  ///< Of light within what it passes through (Beer's law).
  emission,
  procedural_texture,
  image_texture,
  normal_map,
  ambient,
  ambient_occlusion,
  environment,  ///< Light from all around, beyond all surfaces.
  interreflection,
  fog,
  antialiasing,
  depth_of_field,
  motion_blur,
};
inline constexpr std::size_t effect_count = 22;

/// In the enum's order, as tools spell them.
inline constexpr std::array<std::string_view, effect_count> effect_names{
    "meshes",        "instances",    "solids",         "direct light",      "hard shadow", "soft shadow",
    "mirror",        "glossy",       "refraction",     "absorption",        "emission",    "procedural texture",
    "image texture", "normal map",   "ambient",        "ambient occlusion", "environment", "interreflection",
    "fog",           "antialiasing", "depth of field", "motion blur"};

constexpr std::size_t index_of(Effect effect) { return static_cast<std::size_t>(effect); }

/// Effects, each in or not. Usable as a template argument.
struct Effects {
  std::uint32_t bits = 0;

  constexpr Effects() = default;
  constexpr Effects(std::initializer_list<Effect> effects) {
    for (const Effect effect : effects) add(effect);
  }

  constexpr bool has(Effect effect) const { return bits >> index_of(effect) & 1; }
  constexpr void add(Effect effect) { bits |= 1u << index_of(effect); }
  constexpr void remove(Effect effect) { bits &= ~(1u << index_of(effect)); }
  constexpr bool has_all(Effects others) const { return (others.bits & ~bits) == 0; }
  constexpr int count() const { return std::popcount(bits); }

  friend constexpr bool operator==(Effects, Effects) = default;
  friend constexpr Effects operator|(Effects a, Effects b) {
    a.bits |= b.bits;
    return a;
  }
  friend constexpr Effects operator&(Effects a, Effects b) {
    a.bits &= b.bits;
    return a;
  }
};

}  // namespace sightline
