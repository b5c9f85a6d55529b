#pragma once

#include <array>
#include <string_view>

namespace sightline {

/// How accurate an answer is, and so what it costs.
enum class Level {
  fast,        ///< Float throughout. Signs are rounded: a ray may slip between two triangles, or hit both, where it
               ///< passes within a few rounding errors of their edge. Hits differ by that little.
  watertight,  ///< No ray slips through. Of triangles decisions are exact, and t, u and v are rounded once, to the
               ///< ray's precision; curved surfaces and solids are computed in double.
  precise,  ///< Each number has a proven bound; what a double cannot tell, some 100 bits decide. Closer ones are one.
  exact,    ///< What those bits cannot tell is decided exactly, and t is correctly rounded.
};

struct LevelInfo {
  Level level;
  std::string_view name;
  std::string_view help;
};
inline constexpr std::array<LevelInfo, 4> level_infos{{
    {Level::fast, "fast", "float throughout: near edges a ray may slip through or hit twice"},
    {Level::watertight, "watertight", "no ray slips through; the default"},
    {Level::precise, "precise", "proven bounds, and some 100 bits where a double cannot tell"},
    {Level::exact, "exact", "every decision exact, every number correctly rounded"},
}};

/// Those that rays of float know among triangles; rays of double know `precise` and `exact` (query/tracer.h).
inline constexpr std::array<Level, 2> triangle_levels{Level::fast, Level::watertight};

constexpr const LevelInfo& info_of(Level level) { return level_infos[static_cast<std::size_t>(level)]; }

}  // namespace sightline
