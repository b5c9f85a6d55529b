#pragma once
/// Answers counted against the truth.

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace sightline::hard {

/// What an answer is beside the truth.
enum class Verdict {
  exact,         ///< The true decision, and every number the true one, rounded to nearest.
  within_bound,  ///< The true decision, and numbers as near the true ones as whoever answers promises.
  wrong,
};

/// One question, as a person reads it.
struct Example {
  std::string inputs;
  std::string expected;
  std::string got;
};

/// Answers of one structure or routine at one level.
class Tally {
 public:
  /// `error` is that of a number, relative to the true one, where there is one. `describe` returns an Example; it is
  /// called for the first answer of all, and for the first wrong one.
  template <std::invocable Describe>
  void add(Verdict verdict, double error, Describe&& describe) {
    ++counts_[static_cast<std::size_t>(verdict)];
    if (!std::isnan(worst_) && !(error <= worst_)) worst_ = error;  // NaN stays
    if (!first_) first_ = describe();
    if (verdict == Verdict::wrong && !first_wrong_) first_wrong_ = describe();
  }
  template <std::invocable Describe>
  void add(Verdict verdict, Describe&& describe) {
    add(verdict, 0, std::forward<Describe>(describe));
  }
  /// Of a decision, which is right or not.
  template <std::invocable Describe>
  void decide(bool is_right, Describe&& describe) {
    add(is_right ? Verdict::exact : Verdict::wrong, std::forward<Describe>(describe));
  }

  std::uint64_t count(Verdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }
  std::uint64_t asked() const { return counts_[0] + counts_[1] + counts_[2]; }
  /// The worst of its answers. Of no answer there is none: `wrong`.
  Verdict verdict() const {
    if (count(Verdict::wrong) > 0 || asked() == 0) return Verdict::wrong;
    return count(Verdict::within_bound) > 0 ? Verdict::within_bound : Verdict::exact;
  }
  double worst_error() const { return worst_; }
  const std::optional<Example>& first() const { return first_; }
  const std::optional<Example>& first_wrong() const { return first_wrong_; }

 private:
  std::uint64_t counts_[3] = {};
  double worst_ = 0;
  std::optional<Example> first_, first_wrong_;
};

}  // namespace sightline::hard
