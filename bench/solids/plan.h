#pragma once

#include <string>
#include <vector>

#include "sightline/csg/solid.h"
#include "sightline/math/level.h"

namespace sightline::bench {

/// How ours are asked: a line of the table.
struct SolidAsking {
  std::string name;  ///< "watertight", or "watertight, use_bounds off".
  Level level = Level::watertight;
  SolidOptions options;
  bool in_packets = true;  ///< Rays go in packets, where the structure takes those; else one by one.
};

struct SolidPlan {
  std::vector<std::string> scenes;  ///< Names of solid_scenes; all where empty.
  std::vector<Level> levels{Level::watertight};
  SolidOptions options;
  bool has_single = false;   ///< Beside each level also rays one by one.
  bool is_ablation = false;  ///< Beside each level also every switch off, and all, at the first level.
  std::string accelerator;   ///< Empty for bih over solids, and box-tree over operands.
  bool has_povray = true;    ///< Where it is installed.
  int width = 800, height = 600;
  int rounds = 9;
  double row_seconds = 20;  ///< A line that would take longer for all its rounds takes part in fewer.
  int reference_step = 8;   ///< Of the rows of a picture, every so many are held against the reference.
  std::string spoiled;      ///< The name of a line of which one pixel is made wrong on purpose; usually empty.
  std::string json;
};

std::vector<SolidAsking> askings_of(const SolidPlan& plan);

}  // namespace sightline::bench
