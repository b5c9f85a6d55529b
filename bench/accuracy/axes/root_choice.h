#pragma once
/// What solvers of all kinds have in common: a question has some real roots, and is answered by some.

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/accuracy/axis.h"
#include "bench/accuracy/error_sum.h"
#include "bench/accuracy/oracle.h"
#include "sightline/math/root_list.h"

namespace sightline::bench {

/// Distinct roots in ascending order.
struct FewRoots {
  int count = 0;
  std::array<double, 4> at{};
};

inline FewRoots in_order(double one, double other) {
  if (one > other) std::swap(one, other);
  return {2, {one, other}};
}

inline FewRoots few_of(const RootList& list) {
  FewRoots roots{list.count, {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(list.count); ++i) roots.at[i] = list.roots[i].t;
  return roots;
}

/// A decision is the number of roots; where it is right, each root's error counts, over size(question, root).
template <class Question, class Solve, class Size>
Choice root_choice(const std::string& name, std::shared_ptr<const std::vector<Question>> questions,
                   const std::vector<std::vector<True>>& truths, Solve solve, const Size& size) {
  ErrorSum sum;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const FewRoots roots = solve((*questions)[i]);
    const bool is_right = static_cast<std::size_t>(roots.count) == truths[i].size();
    sum.decide(is_right);
    for (std::size_t k = 0; is_right && k < truths[i].size(); ++k) {
      const double scale = size((*questions)[i], truths[i][k]);
      if (scale > 0) sum.add(truths[i][k].off(roots.at[k]) / scale);
    }
  }
  const auto pass = [questions, solve] {
    double all = 0;
    for (const Question& question : *questions) {
      const FewRoots roots = solve(question);
      all += roots.count + roots.at[0];
    }
    return all;
  };
  return {name, sum.errors(), pass};
}

}  // namespace sightline::bench
