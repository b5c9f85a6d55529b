#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bench/accuracy/axis.h"

namespace sightline::bench {

/// Adds up what differs from the truth.
class ErrorSum {
 public:
  void add(double error) {
    largest_ = std::max(largest_, std::fabs(error));
    if (!std::isfinite(error)) largest_ = std::numeric_limits<double>::infinity();
    squares_ += error * error;
    ++numbers_;
  }
  void decide(bool is_right) {
    wrong_ += !is_right;
    ++decisions_;
  }

  Errors errors() const {
    Errors errors;
    if (numbers_ > 0) {
      errors.maximum = largest_;
      errors.rms = std::sqrt(squares_ / static_cast<double>(numbers_));
    }
    errors.wrong = wrong_, errors.decisions = decisions_;
    if (decisions_ > 0)
      errors.wrong_per_million = million * static_cast<double>(wrong_) / static_cast<double>(decisions_);
    return errors;
  }

  static constexpr double million = 1'000'000;

 private:
  double largest_ = 0, squares_ = 0;
  std::size_t numbers_ = 0, wrong_ = 0, decisions_ = 0;
};

}  // namespace sightline::bench
