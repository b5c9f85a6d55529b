#pragma once
/// Work per ray in figures.

#include <cstdint>
#include <span>
#include <vector>

namespace sightline::viz {

/// A percentile is the least work that at least so many of all rays do not exceed.
struct WorkStatistics {
  std::uint64_t rays = 0, total = 0;
  std::uint32_t median = 0, percentile_99 = 0, highest = 0;
  std::uint64_t idle = 0;         ///< Rays that take no step at all.
  std::uint32_t busy_median = 0;  ///< Of the others.

  double mean() const { return rays == 0 ? 0 : double(total) / double(rays); }
};
WorkStatistics statistics_of(std::span<const std::uint32_t> work);

/// Of a structure's work less another's, ray by ray.
struct DifferenceStatistics {
  std::uint64_t less = 0, equal = 0, more = 0;  ///< Rays.
  std::int64_t total = 0, median = 0;

  std::uint64_t rays() const { return less + equal + more; }
  double mean() const { return rays() == 0 ? 0 : double(total) / double(rays()); }
};
std::vector<std::int64_t> differences(std::span<const std::uint32_t> work, std::span<const std::uint32_t> against);
DifferenceStatistics statistics_of(std::span<const std::int64_t> differences);

/// What all but one ray in a hundred differ by at most, either way; at least 10.
double scale_for(std::span<const std::int64_t> differences);
/// From -1 to 1, as even in ratios as a scale with 0 in its middle can be; what lies beyond is held at its ends.
double difference_share(double difference, double scale);

/// Rays whose work is from `low` to `high`, both included.
struct HistogramBin {
  std::uint32_t low = 0, high = 0;
  std::uint64_t rays = 0;
};
/// 0, 1, 2, 3, then four bins to each doubling, as far as `highest`: the same bins for all that share it. Every ray is
/// in one bin; none does more work than `highest`.
std::vector<HistogramBin> histogram_of(std::span<const std::uint32_t> work, std::uint32_t highest);

}  // namespace sightline::viz
