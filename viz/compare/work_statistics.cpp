#include "viz/compare/work_statistics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace sightline::viz {
namespace {

/// Nearest rank, of numbers in any order, which are put into another.
template <class T>
T percentile(std::vector<T>& numbers, std::size_t percent) {
  const std::size_t rank = (numbers.size() * percent + 99) / 100;
  const auto at = numbers.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
  std::nth_element(numbers.begin(), at, numbers.end());
  return *at;
}

}  // namespace

WorkStatistics statistics_of(std::span<const std::uint32_t> work) {
  WorkStatistics statistics;
  statistics.rays = work.size();
  if (work.empty()) return statistics;
  for (const std::uint32_t steps : work) statistics.total += steps;
  std::vector<std::uint32_t> sorted(work.begin(), work.end());
  statistics.median = percentile(sorted, 50);
  statistics.percentile_99 = percentile(sorted, 99);
  statistics.highest = *std::ranges::max_element(sorted);
  statistics.idle = std::erase(sorted, 0u);
  if (!sorted.empty()) statistics.busy_median = percentile(sorted, 50);
  return statistics;
}

std::vector<std::int64_t> differences(std::span<const std::uint32_t> work, std::span<const std::uint32_t> against) {
  if (work.size() != against.size()) throw std::invalid_argument("work of as many rays is needed");
  std::vector<std::int64_t> result;
  result.reserve(work.size());
  for (std::size_t i = 0; i < work.size(); ++i) result.push_back(std::int64_t(work[i]) - std::int64_t(against[i]));
  return result;
}

DifferenceStatistics statistics_of(std::span<const std::int64_t> differences) {
  DifferenceStatistics statistics;
  for (const std::int64_t difference : differences) {
    ++(difference < 0 ? statistics.less : difference > 0 ? statistics.more : statistics.equal);
    statistics.total += difference;
  }
  if (differences.empty()) return statistics;
  // Of an even number the two in the middle, rounded toward 0: so that swapping the structures turns the sign alone.
  std::vector<std::int64_t> sorted(differences.begin(), differences.end());
  std::ranges::sort(sorted);
  statistics.median = (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]) / 2;
  return statistics;
}

double scale_for(std::span<const std::int64_t> differences) {
  std::vector<std::int64_t> sizes;
  for (const std::int64_t difference : differences) sizes.push_back(std::abs(difference));
  return sizes.empty() ? 10 : std::max(10.0, double(percentile(sizes, 99)));
}

double difference_share(double difference, double scale) {
  const double share = std::log1p(std::fabs(difference) / 2) / std::log1p(scale / 2);
  return std::copysign(std::fmin(share, 1), difference);
}

std::vector<HistogramBin> histogram_of(std::span<const std::uint32_t> work, std::uint32_t highest) {
  std::vector<HistogramBin> bins;
  for (std::uint64_t low = 0; low <= highest;) {
    const std::uint64_t width = low < 4 ? 1 : std::bit_floor(low) / 4;
    bins.push_back({static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low + width - 1), 0});
    low += width;
  }
  for (const std::uint32_t steps : work) {
    if (steps > highest) throw std::invalid_argument("more work than the histogram has bins for");
    const auto bin = std::ranges::upper_bound(bins, steps, {}, &HistogramBin::low) - 1;
    ++bin->rays;
  }
  return bins;
}

}  // namespace sightline::viz
