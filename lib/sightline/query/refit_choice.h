#pragma once

#include <algorithm>

namespace sightline {

/// Whether the next frame of a moving scene is better served by refitting the structure or by building it anew, from
/// what both have cost, and tracing.
///
/// Refitting is cheap, but the tree fits the worse the more has moved, so that each frame takes longer to trace than
/// one after building. When what this has cost since the last building comes to what building costs more than
/// refitting, it is time to build: whatever comes next, all frames cost at most twice the best that foresight could
/// have done. The rule of Karlin, Manasse, Rudolph and Sleator, "Competitive snoopy caching", 1988 (to rent or to buy).
class RefitChoice {
 public:
  /// Seconds that something took, or any other measure of cost, such as nodes visited; the same for all three.
  void built(double cost) {
    building_ = cost;
    best_tracing_ = -1;
    lost_ = 0;
  }
  void refitted(double cost) { refitting_ = cost; }
  void traced(double cost) {
    if (best_tracing_ < 0) best_tracing_ = cost;  // of the frame after building
    lost_ += std::max(0.0, cost - best_tracing_);
  }

  bool prefers_refitting() const { return building_ >= 0 && lost_ < building_ - refitting_; }

 private:
  double building_ = -1, refitting_ = 0;  ///< The latest; -1 before the first.
  double best_tracing_ = -1, lost_ = 0;
};

}  // namespace sightline
