#pragma once

#include "sightline/query/level.h"

namespace sightline::bench {

/// How ours are asked.
struct Asking {
  Level level = Level::watertight;
  bool is_stream = false;  ///< All rays at hand together, instead of one after the other.
};

}  // namespace sightline::bench
