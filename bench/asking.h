#pragma once

#include <string>
#include <string_view>

#include "sightline/math/level.h"

namespace sightline::bench {

/// How ours are asked.
struct Asking {
  Level level = Level::watertight;
  bool is_stream = false;  ///< All rays at hand together, instead of one after the other.

  friend bool operator==(const Asking&, const Asking&) = default;
};

inline std::string_view name_of(Level level) { return info_of(level).name; }

/// What a report calls `label` asked like that: "kd-tree" at the default level, one ray after the other, and
/// "kd-tree fast stream" otherwise.
inline std::string name_of(const std::string& label, const Asking& asking) {
  const std::string level = asking.level == Level::watertight ? "" : ' ' + std::string(name_of(asking.level));
  return label + level + (asking.is_stream ? " stream" : "");
}

}  // namespace sightline::bench
