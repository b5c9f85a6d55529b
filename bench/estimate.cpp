#include "bench/estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <utility>

namespace sightline::bench {
namespace {

/// Decimal exponent of the first significant digit.
int magnitude(double value) { return static_cast<int>(std::floor(std::log10(std::fabs(value)))); }

std::string fixed_text(double value, int decimals) {
  if (decimals < 0) {
    const double unit = std::pow(10.0, -decimals);
    return fixed_text(std::round(value / unit) * unit, 0);
  }
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", std::min(decimals, 12), value);
  return buffer;
}

}  // namespace

Estimate estimate(std::vector<double> samples) {
  if (samples.empty()) throw std::invalid_argument("no samples to estimate from");
  std::sort(samples.begin(), samples.end());
  const std::size_t n = samples.size();
  Estimate result;
  result.median = n % 2 == 1 ? samples[n / 2] : 0.5 * (samples[n / 2 - 1] + samples[n / 2]);

  double choose = std::pow(0.5, static_cast<double>(n));  // C(n, k - 1) / 2^n
  double outside = choose;                                // on one side, for k = 1
  std::size_t k = 1;
  while (k + 1 <= (n + 1) / 2) {
    choose *= static_cast<double>(n - k + 1) / static_cast<double>(k);
    if (1 - 2 * (outside + choose) < 0.95) break;
    outside += choose;
    ++k;
  }
  result.low = samples[k - 1];
  result.high = samples[n - k];
  result.confidence = n == 1 ? 0 : 1 - 2 * outside;
  return result;
}

Estimate estimate_of_share(std::size_t yes, std::size_t count) {
  if (count == 0 || yes > count) throw std::invalid_argument("a share needs answers");
  constexpr double z = 1.959963984540054;  // the normal distribution's 97.5th percentile
  const double n = static_cast<double>(count), share = static_cast<double>(yes) / n, most = 1 + z * z / n;
  const double middle = (share + z * z / (2 * n)) / most;
  const double half = z / most * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  // What rounds must not leave the share itself out.
  return {share, std::min(share, std::max(0.0, middle - half)), std::max(share, std::min(1.0, middle + half)), 0.95};
}

std::optional<Estimate> estimate_of_present(std::vector<double> samples) {
  std::erase_if(samples, [](double x) { return std::isnan(x); });
  if (samples.empty()) return std::nullopt;
  return estimate(std::move(samples));
}

std::optional<Estimate> paired_ratio(const std::vector<double>& over, const std::vector<double>& under) {
  std::vector<double> ratios(over.size());
  for (std::size_t i = 0; i < over.size(); ++i) ratios[i] = over[i] / under[i];
  return estimate_of_present(std::move(ratios));
}

std::vector<double> geometric_means(const std::vector<std::vector<double>>& series) {
  std::size_t longest = 0;
  for (const auto& samples : series) longest = std::max(longest, samples.size());
  std::vector<double> means(longest);
  for (std::size_t i = 0; i < longest; ++i) {
    double logarithms = 0;
    for (const auto& samples : series) {
      logarithms += i < samples.size() ? std::log(samples[i]) : std::numeric_limits<double>::quiet_NaN();
    }
    means[i] = std::exp(logarithms / static_cast<double>(series.size()));
  }
  return means;
}

std::string measured_text(const Estimate& value, int significant) {
  if (value.median == 0 || !std::isfinite(value.median)) return number_text(value.median, significant);
  int decimals = significant - 1 - magnitude(value.median);
  const double half_width = 0.5 * (value.high - value.low);
  if (half_width > 0) decimals = std::min(decimals, -magnitude(half_width));
  return fixed_text(value.median, std::max(decimals, -magnitude(value.median)));
}

std::string number_text(double value, int significant) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return value > 0 ? "inf" : value < 0 ? "-inf" : "nan";
  return fixed_text(value, std::max(0, significant - 1 - magnitude(value)));
}

std::string count_text(std::size_t count) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

}  // namespace sightline::bench
