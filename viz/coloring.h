#pragma once

#include <string>

#include "viz/color_ramp.h"
#include "viz/partition.h"

namespace sightline::viz {

/// What the colors of a picture of cells mean: a small number of levels, each with a color and a label.
///   Depth, where cells of several depths are shown; otherwise the candidates of a leaf, in powers of two.
class Coloring {
 public:
  explicit Coloring(const Partition& partition);

  bool is_by_depth() const { return is_by_depth_; }
  std::string title() const;
  int lowest() const { return lowest_; }
  int highest() const { return highest_; }
  int level_of(const Cell& cell) const;
  std::string label(int level) const;
  /// Where the level lies in the ramp, 0 to 1.
  double share(int level) const;
  Rgb color(int level) const { return ramp(share(level)); }

 private:
  bool is_by_depth_;
  int lowest_ = 0;
  int highest_ = 0;
};

}  // namespace sightline::viz
