#include "tests/hard_cases/solver_question.h"

#include <algorithm>
#include <cmath>

#include "sightline/math/algebraic_root.h"
#include "sightline/math/quartic.h"
#include "tests/hard_cases/naive_quartic.h"

namespace sightline::hard {
namespace {

constexpr double least = std::numeric_limits<double>::denorm_min();

std::string text_of(std::span<const double> highest_first) {
  std::string text;
  for (const double c : highest_first) text += (text.empty() ? "" : ", ") + all_digits(c);
  return text;
}

RootList exact_list(std::span<const double> highest_first) {
  ExactPolynomial polynomial;
  for (auto c = highest_first.rbegin(); c != highest_first.rend(); ++c) polynomial.emplace_back(*c);
  RootList list;
  for (const AlgebraicRoot& root : real_roots(polynomial)) {
    const double t = root.nearest();
    list.add({t, 0x1p-53 * std::fabs(t) + least, root.multiplicity()});
  }
  return list;
}

/// float has no conversion from double that is not narrowing.
template <class N>
N number(double x) {
  if constexpr (std::is_same_v<N, float>)
    return static_cast<float>(x);
  else
    return N(x);
}

template <class N>
RootList quadratic_list(const Quadratic& k) {
  return quadratic_roots(number<N>(k[0]), number<N>(0.5 * k[1]), number<N>(k[2]));
}

template <class N>
RootList quartic_list(const Quartic& k) {
  std::array<N, 5> lowest_first;
  for (std::size_t i = 0; i < 5; ++i) lowest_first[i] = number<N>(k[4 - i]);
  return quartic_roots(lowest_first);
}

}  // namespace

void ask_quadratic(Trial& trial, const Quadratic& k) {
  const auto& [a, b, c] = k;
  const RootQuestion question(text_of(k), rationals_of(k));
  const Ray<double> along_x{{0, 0, 0}, {1, 0, 0}};
  SolidQuestion(solid::Quadric{{a, 0, 0, 0, 0, 0, b, 0, 0, c}}, along_x, question.spans()).ask_spans(trial, "quadric");
  const std::string_view who = "roots of quadratics";
  question.judge(trial.of(who, Level::fast), quadratic_list<float>(k), Level::fast);
  question.judge(trial.of(who, Level::watertight), quadratic_list<double>(k), Level::watertight);
  RootList list = quadratic_list<DoubleBall>(k);
  if (!list.is_certain) list = quadratic_list<WideBall>(k);
  if (!list.is_certain) list = exact_list(k);  // as solids go on where bounds do not decide (csg/settle.cpp)
  question.judge(trial.of(who, Level::precise), list, Level::precise);
  question.judge(trial.of(who, Level::exact), exact_list(k), Level::exact);
}

RootQuestion quartic_question(const Quartic& k) { return RootQuestion(text_of(k), rationals_of(k)); }

RootQuestion ask_quartic(Trial& trial, const Quartic& k) {
  RootQuestion question = quartic_question(k);
  const std::string_view who = "roots of quartics";
  question.judge(trial.of(who, Level::fast), quartic_list<float>(k), Level::fast);
  RootList list = quartic_list<DoubleBall>(k);
  if (!list.is_certain) list = quartic_list<WideBall>(k);
  question.judge(trial.of(who, Level::precise), list, Level::precise);
  question.judge(trial.of(who, Level::exact), exact_list(k), Level::exact);
  return question;
}

void judge_school(Trial& trial, const Quadratic& k) {
  const auto& [a, b, c] = k;
  std::vector<double> found;
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant < 0)) {
    found = {(-b - std::sqrt(discriminant)) / (2 * a), (-b + std::sqrt(discriminant)) / (2 * a)};
  }
  RootQuestion(text_of(k), rationals_of(k)).judge_naive(trial.naive("the formula from school, in double"), found);
}

void judge_ferrari(Trial& trial, const RootQuestion& question, const Quartic& k) {
  question.judge_naive(trial.naive("Ferrari's way, in double"),
                       naive_quartic_roots<double>({k[4], k[3], k[2], k[1], k[0]}));
}

Quartic nudged(const Quartic& coefficients, Random& random) {
  Quartic k = coefficients;
  for (double& c : k) c += c * 0x1p-52 * (double(random.below(9)) - 4);
  return k;
}

}  // namespace sightline::hard
