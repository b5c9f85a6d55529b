#include "tests/hard_cases/root_question.h"

#include <algorithm>
#include <cmath>

namespace sightline::hard {
namespace {

using oracle::Rational;
using Chains = std::vector<oracle::SturmChain>;

/// Between the i-th root and the next one, or the i-th itself.
Rational separator(const oracle::SturmChain& chain, int i, double here, double next) {
  Rational lo(std::nextafter(here, -INFINITY)), hi(std::nextafter(next, INFINITY));
  for (;;) {
    const Rational middle = (lo + hi) / 2;
    const int count = chain.count_to(middle);
    if (count == i + 1) return middle;
    (count <= i ? lo : hi) = middle;
  }
}

bool is_off_by(const TrueNumber& truth, double t, double bound) {
  return std::isfinite(t) && truth(t, -bound) >= 0 && truth(t, bound) <= 0;
}

/// Of a root at the level precise, as a share of the farthest.
constexpr double most_radius = 0x1p-40;
/// Of a simple root of a quartic, of what the coefficients' own digits leave open.
constexpr double most_of_coefficients = 0x1p-46;

/// The sum of |c_i t^i| over |p'(t)|: how far relative changes of the coefficients, times this, move the root at t.
double condition_of(const std::vector<Rational>& coefficients, double t) {
  const Rational at(t);
  Rational power = 1, sum = 0, slope = 0;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    sum += abs(coefficients[i] * power);
    if (i + 1 < coefficients.size()) slope += Rational(i + 1) * coefficients[i + 1] * power;
    power *= at;
  }
  return slope == 0 ? 0 : static_cast<double>(Rational(sum / abs(slope)));
}

double error_of(double t, double truth) { return t == truth ? 0 : std::fabs((t - truth) / truth); }

}  // namespace

RootQuestion::RootQuestion(std::string inputs, const std::vector<Rational>& coefficients) : inputs_(std::move(inputs)) {
  const oracle::Polynomial polynomial = oracle::polynomial_of(coefficients);
  const auto chains = std::make_shared<const Chains>(oracle::chains_of(polynomial));
  begins_negative_ = !polynomial.empty() && (polynomial.back() < 0) == (polynomial.size() % 2 == 1);
  if (chains->empty()) return;
  TrueSpans distinct;
  for (int i = 0; i < (*chains)[0].count(); ++i) {
    distinct.ends.emplace_back([chains, i](double x, double y) {
      const Rational at = Rational(x) + Rational(y);
      const int up_to = (*chains)[0].count_to(at);
      if (up_to <= i) return 1;
      return up_to == i + 1 && (*chains)[0].has_root(at) ? 0 : -1;
    });
  }
  distinct.round_ends();
  std::vector<int> before(chains->size(), 0);
  for (std::size_t i = 0; i < distinct.ends.size(); ++i) {
    const bool is_last = i + 1 == distinct.ends.size();
    const Rational upto =
        is_last ? Rational(0)
                : separator((*chains)[0], static_cast<int>(i), distinct.nearest[i], distinct.nearest[i + 1]);
    int multiplicity = 0;
    for (std::size_t m = 0; m < chains->size(); ++m) {
      const int count = is_last ? (*chains)[m].count() : (*chains)[m].count_to(upto);
      multiplicity += count - before[m];
      before[m] = count;
    }
    const bool is_conditioned = coefficients.size() > 3 && multiplicity == 1;
    roots_.push_back({distinct.ends[i], distinct.nearest[i], multiplicity,
                      is_conditioned ? condition_of(coefficients, distinct.nearest[i]) : 0});
  }
}

TrueSpans RootQuestion::spans() const {
  TrueSpans spans{begins_negative_, {}, {}};
  for (const TrueRoot& root : roots_) {
    if (root.multiplicity % 2 == 0) continue;
    spans.ends.push_back(root.number);
    spans.nearest.push_back(root.nearest);
  }
  return spans;
}

Verdict RootQuestion::verdict_of(const Root& root, std::size_t i, Level level) const {
  const auto& [number, nearest, multiplicity, condition] = roots_[i];
  const double t = root.t;
  if (root.multiplicity != multiplicity) return Verdict::wrong;
  if (level == Level::fast ? t == static_cast<float>(nearest) : t == nearest) return Verdict::exact;
  const double size = std::fabs(t);
  // What a root says of itself may not be much beside the farthest of all, nor beside what its coefficients leave open.
  const double farthest = std::max(std::fabs(roots_.front().nearest), std::fabs(roots_.back().nearest));
  const double bound = level == Level::fast ? 0x1p-19 * size
                       : level == Level::watertight
                           ? 0x1p-46 * size
                           : std::min(root.radius, std::max(most_radius * farthest, most_of_coefficients * condition));
  return level != Level::exact && is_off_by(number, t, bound) ? Verdict::within_bound : Verdict::wrong;
}

void RootQuestion::judge(Tally& tally, const RootList& list, Level level) const {
  const auto found = std::span(list.roots).first(static_cast<std::size_t>(list.count));
  Verdict verdict = level == Level::exact && !list.is_certain ? Verdict::wrong : Verdict::exact;
  double error = 0;
  if (found.size() != roots_.size()) verdict = Verdict::wrong;
  for (std::size_t i = 0; i < found.size() && verdict != Verdict::wrong; ++i) {
    verdict = std::max(verdict, verdict_of(found[i], i, level));
    error = std::max(error, error_of(found[i].t, roots_[i].nearest));
  }
  tally.add(verdict, error, [&] {
    std::string got;
    for (const Root& root : found) {
      got += (got.empty() ? "" : ", ") + all_digits(root.t) + " x" + std::to_string(root.multiplicity);
    }
    return Example{inputs_, text(), (got.empty() ? "none" : got) + (list.is_certain ? "" : ", not certain")};
  });
}

void RootQuestion::judge_naive(Tally& tally, std::vector<double> found) const {
  std::ranges::sort(found);
  const auto [rest, end] = std::ranges::unique(found);
  found.erase(rest, end);
  Verdict verdict = found.size() == roots_.size() ? Verdict::exact : Verdict::wrong;
  double error = 0;
  for (std::size_t i = 0; i < found.size() && verdict != Verdict::wrong; ++i) {
    verdict = std::max(verdict, verdict_of({found[i], 0, roots_[i].multiplicity}, i, Level::fast));
    error = std::max(error, error_of(found[i], roots_[i].nearest));
  }
  tally.add(verdict, error, [&] { return Example{inputs_, text(), all_digits(found)}; });
}

std::string RootQuestion::text() const {
  std::string expected;
  for (const TrueRoot& root : roots_) {
    expected += (expected.empty() ? "" : ", ") + all_digits(root.nearest) + " x" + std::to_string(root.multiplicity);
  }
  return expected.empty() ? "none" : expected;
}

std::vector<Rational> rationals_of(std::span<const double> highest_first) {
  return {highest_first.rbegin(), highest_first.rend()};
}

}  // namespace sightline::hard
