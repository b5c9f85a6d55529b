#pragma once

#include <array>
#include <string_view>

namespace sightline {

/// How accurate a query is, and so what it costs.
enum class Level {
  fast,        ///< Float throughout. Signs of edge functions are rounded: a ray may slip between two triangles, or hit
               ///< both, where it passes within a few rounding errors of their edge. Hits differ by that little.
  watertight,  ///< Decisions are exact, so no ray slips through; t, u and v are rounded once, to the ray's precision.
};

struct LevelInfo {
  Level level;
  std::string_view name;
  std::string_view help;
};
inline constexpr std::array<LevelInfo, 2> level_infos{{
    {Level::fast, "fast", "float throughout: near edges a ray may slip through or hit twice"},
    {Level::watertight, "watertight", "exact decisions: no ray slips through; the default"},
}};

}  // namespace sightline
