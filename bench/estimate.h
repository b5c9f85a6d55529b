#pragma once
/// What a series of measurements says: the median, and how sure it is.

#include <optional>
#include <string>
#include <vector>

namespace sightline::bench {

/// The median of independent samples with a distribution-free confidence interval: the true median lies between the
/// k-th smallest and the k-th largest of n samples unless fewer than k of them fall on one side of it, and each falls
/// on either side with probability 1/2. So no normality is assumed, which times do not have.
///   low <= median <= high, and both are samples.
struct Estimate {
  double median = 0;
  double low = 0;
  double high = 0;
  double confidence = 0;  ///< That the true median lies in [low, high]; below 0.95 only where these are min and max.
};

/// The narrowest interval of that kind with a confidence of 0.95; that of smallest and largest where none has it.
/// \throws std::invalid_argument without samples.
Estimate estimate(std::vector<double> samples);

/// Of `count` independent yes-or-no answers of which `yes` were yes: their share, with Wilson's interval of a
/// confidence of 0.95, which holds where all are no as well. Wilson, "Probable Inference, the Law of Succession, and
/// Statistical Inference", 1927. \throws std::invalid_argument without answers, or with more that are yes than there
/// are.
Estimate estimate_of_share(std::size_t yes, std::size_t count);

/// estimate() of those samples that are not NaN; nothing without any.
std::optional<Estimate> estimate_of_present(std::vector<double> samples);

/// How much longer one took than the other, each by index in the same round; nothing where they never met (NaN).
std::optional<Estimate> paired_ratio(const std::vector<double>& over, const std::vector<double>& under);

/// By index, the geometric mean of what the series have there: NaN where one of them has NaN or ends earlier. One row
/// of independent samples from each series is one sample of the mean, so estimate() holds for the result. Of positive
/// numbers; empty without series.
std::vector<double> geometric_means(const std::vector<std::vector<double>>& series);

/// A number with as many digits as its interval bears, at most `significant`: 0.2137 within +-0.03 is "0.21".
std::string measured_text(const Estimate& value, int significant = 3);

/// A number that is known exactly, to `significant` digits, without an exponent.
std::string number_text(double value, int significant = 3);

/// 47794 as "47,794".
std::string count_text(std::size_t count);

}  // namespace sightline::bench
