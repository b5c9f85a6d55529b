#pragma once
/// A polynomial with rational coefficients, its real roots by Sturm's chains, and answers held against them.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sightline/math/root_list.h"
#include "tests/hard_cases/solid_question.h"
#include "tests/math/sturm.h"

namespace sightline::hard {

class RootQuestion {
 public:
  /// Coefficients are from the lowest on. `inputs` is for people.
  RootQuestion(std::string inputs, const std::vector<oracle::Rational>& coefficients);

  struct TrueRoot {
    TrueNumber number;
    double nearest;
    int multiplicity;
    double condition;  ///< How far relative changes of a quartic's coefficients, times this, move a simple root.
  };
  const std::vector<TrueRoot>& roots() const { return roots_; }

  /// The polynomial being negative inside: roots that only touch are not among these.
  TrueSpans spans() const;

  /// Number and multiplicities have to be true. Each t counts as within the bound
  ///   fast     off by no more than 2^-19 of itself, 32 roundings of float: nothing is promised,
  ///   watertight  off by no more than 2^-46 of itself (lib/README.md),
  ///   precise  off by no more than its own radius, which is proven (root_list.h), and which in turn may be no more
  ///   than
  ///            2^-40 of the farthest root or, of a quartic, 2^-46 times the root's condition,
  ///   exact    where rounding to nearest has put it, and the list says that it is certain.
  void judge(Tally& tally, const RootList& list, Level level) const;

  /// Of other code, which promises nothing: as for `fast`, and equal roots count once.
  void judge_naive(Tally& tally, std::vector<double> found) const;

 private:
  Verdict verdict_of(const Root& root, std::size_t i, Level level) const;
  std::string text() const;

  std::string inputs_;
  std::vector<TrueRoot> roots_;
  bool begins_negative_ = false;
};

/// Coefficients as they are, from the highest on.
std::vector<oracle::Rational> rationals_of(std::span<const double> highest_first);

}  // namespace sightline::hard
