#include "viz/coloring.h"

#include <algorithm>
#include <bit>

namespace sightline::viz {

Coloring::Coloring(const Partition& partition)
    : is_by_depth_(partition.shallowest != partition.deepest),
      lowest_(partition.shallowest),
      highest_(partition.deepest) {
  if (is_by_depth_ || partition.cells.empty()) return;
  const auto [least, most] =
      std::minmax_element(partition.cells.begin(), partition.cells.end(),
                          [&](const Cell& a, const Cell& b) { return level_of(a) < level_of(b); });
  lowest_ = level_of(*least);
  highest_ = level_of(*most);
}

std::string Coloring::title() const { return is_by_depth_ ? "depth" : "candidates in leaf"; }

/// Candidates: 0, 1, 2, 3-4, 5-8, ... are the levels 0, 1, 2, 3, 4, ...
int Coloring::level_of(const Cell& cell) const {
  if (is_by_depth_) return cell.depth;
  const std::uint32_t count = cell.range.count;
  return count == 0 ? 0 : 1 + static_cast<int>(std::bit_width(count - 1));
}

std::string Coloring::label(int level) const {
  if (is_by_depth_ || level <= 2) return std::to_string(level);
  const long long highest = 1LL << (level - 1);
  return std::to_string(highest / 2 + 1) + " to " + std::to_string(highest);
}

double Coloring::share(int level) const {
  return highest_ == lowest_ ? 0.35 : double(level - lowest_) / (highest_ - lowest_);
}

}  // namespace sightline::viz
