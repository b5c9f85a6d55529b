#include "tests/hard_cases/solid_question.h"

#include <bit>
#include <charconv>
#include <cmath>

#include "sightline/query/tracer.h"
#include "tests/csg/evaluate.h"
#include "tests/csg/exact_solid.h"
#include "tests/csg/random_solid.h"

namespace sightline::hard {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whether x of type T is the one nearest to the number, the even one of two.
template <class T>
bool is_nearest_of_type(const TrueNumber& number, T x) {
  if (!std::isfinite(x)) return false;
  const auto half = [](T y) { return 0.5 * static_cast<double>(y); };
  const T below = std::nextafter(x, -std::numeric_limits<T>::infinity()),
          above = std::nextafter(x, std::numeric_limits<T>::infinity());
  if (!std::isfinite(below) || !std::isfinite(above)) return false;
  const int over_lo = number(half(x), half(below)), over_hi = number(half(x), half(above));
  const bool is_even = std::bit_cast<std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>(x) % 2 == 0;
  return (over_lo > 0 || (over_lo == 0 && is_even)) && (over_hi < 0 || (over_hi == 0 && is_even));
}

/// By halving what is between doubles, in their order.
double nearest_double(const TrueNumber& number) {
  const int side = number(0, 0);
  if (side == 0) return 0;
  std::uint64_t lo = 0, hi = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::max());
  while (hi - lo > 1) {
    const std::uint64_t middle = lo + (hi - lo) / 2;
    (side * number(side * std::bit_cast<double>(middle), 0) >= 0 ? lo : hi) = middle;
  }
  const double down = side * std::bit_cast<double>(lo), up = side * std::bit_cast<double>(hi);
  return is_nearest_of_type(number, down) ? down : up;
}

/// By at most so much.
bool is_off_by(const TrueNumber& truth, double t, double bound) {
  return std::isfinite(t) && truth(t, -bound) >= 0 && truth(t, bound) <= 0;
}

double error_of(double t, double truth) { return t == truth ? 0 : std::fabs((t - truth) / truth); }

}  // namespace

bool is_nearest(const TrueNumber& number, float x) { return is_nearest_of_type(number, x); }
bool is_nearest(const TrueNumber& number, double x) { return is_nearest_of_type(number, x); }

void TrueSpans::round_ends() {
  for (const TrueNumber& end : ends) nearest.push_back(nearest_double(end));
}

TrueSpans true_solid_spans(const SolidTree& tree, const Ray<double>& ray) {
  const oracle::ExactSpans exact = oracle::exact_spans(tree, ray);
  TrueSpans spans{exact.begins_inside, {}, {}};
  for (const oracle::Root& root : exact.ends) {
    spans.ends.emplace_back([root](double a, double b) { return root.compare(oracle::Binary(a) + oracle::Binary(b)); });
  }
  spans.round_ends();
  return spans;
}

UnionByStructure::UnionByStructure(std::vector<SolidTree> operands) : tree_(Operation::unite, std::move(operands)) {
  for (const AcceleratorInfo& info : accelerator_infos()) all_.push_back({info.name, Solid(tree_, {}, info.name)});
}

UnionByStructure among_others(const std::function<SolidTree(const Vec3d& at)>& solid, double apart) {
  std::vector<SolidTree> operands;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) operands.push_back(solid({apart * x, apart * y, 0}));
  }
  return UnionByStructure(std::move(operands));
}

SolidQuestion::SolidQuestion(SolidTree tree, const Ray<double>& ray, TrueSpans truth)
    : tree_(std::move(tree)), solid_(tree_), ray_(ray), truth_(std::move(truth)) {}

std::optional<std::size_t> SolidQuestion::first_end() const {
  for (std::size_t i = 0; i < truth_.ends.size(); ++i) {
    if (truth_.ends[i](0, 0) > 0) return i;
  }
  return std::nullopt;
}

void SolidQuestion::ask_spans(Trial& trial, std::string_view who) const {
  std::vector<double> ends;
  for (const Level level : all_levels) {
    const Spans spans = spans_of(solid_, ray_, level);
    ends.clear();
    for (const Boundary& boundary : spans.boundaries) ends.push_back(boundary.t);
    judge(trial.of(who, level), spans.begins_inside, ends, level, &SolidQuestion::verdict_of);
  }
}

void SolidQuestion::ask_spans(Trial& trial, const UnionByStructure& solids) const {
  std::vector<double> ends;
  for (const auto& [structure, solid] : solids.all()) {
    for (const Level level : all_levels) {
      const Spans spans = spans_of(solid, ray_, level);
      ends.clear();
      for (const Boundary& boundary : spans.boundaries) ends.push_back(boundary.t);
      judge(trial.of(structure, level), spans.begins_inside, ends, level, &SolidQuestion::verdict_of);
    }
  }
}

void SolidQuestion::ask_first(Trial& trial, std::string_view who) const {
  for (const Level level : all_levels) {
    const std::optional<Boundary> first = first_of(solid_, ray_, 0, infinity, level);
    judge_first(trial.of(who, level), first ? std::optional(first->t) : std::nullopt, level,
                &SolidQuestion::verdict_of);
  }
}

void SolidQuestion::judge_crossings(Tally& tally, std::span<const double> ends) const {
  judge(tally, truth_.begins_inside, ends, Level::exact, &SolidQuestion::verdict_of_crossing);
}

void SolidQuestion::judge_spans(Tally& tally, std::span<const double> ends) const {
  judge(tally, truth_.begins_inside, ends, Level::fast, &SolidQuestion::verdict_of_naive);
}

void SolidQuestion::judge_first(Tally& tally, std::optional<double> t) const {
  judge_first(tally, t, Level::fast, &SolidQuestion::verdict_of_naive);
}

void SolidQuestion::judge(Tally& tally, bool begins_inside, std::span<const double> ends, Level level,
                          Rule rule) const {
  Verdict verdict = Verdict::exact;
  double error = 0;
  if (begins_inside != truth_.begins_inside || ends.size() != truth_.ends.size()) {
    verdict = Verdict::wrong;
  } else {
    for (std::size_t i = 0; i < ends.size(); ++i) {
      verdict = std::max(verdict, (this->*rule)(i, ends[i], level));
      error = std::max(error, error_of(ends[i], truth_.nearest[i]));
    }
  }
  tally.add(verdict, error, [&] { return example(all_digits(truth_.nearest), ends); });
}

void SolidQuestion::judge_first(Tally& tally, std::optional<double> t, Level level, Rule rule) const {
  const std::optional<std::size_t> first = first_end();
  Verdict verdict = first.has_value() == t.has_value() ? Verdict::exact : Verdict::wrong;
  double error = 0;
  if (first && t) {
    verdict = (this->*rule)(*first, *t, level);
    error = error_of(*t, truth_.nearest[*first]);
  }
  tally.add(verdict, error, [&] {
    return example(first ? all_digits(truth_.nearest[*first]) : "none",
                   t ? std::span<const double>(&*t, 1) : std::span<const double>());
  });
}

Verdict SolidQuestion::verdict_of(std::size_t end, double t, Level level) const {
  const TrueNumber& truth = truth_.ends[end];
  if (level == Level::fast ? is_nearest(truth, static_cast<float>(t)) && t == static_cast<float>(t)
                           : t == truth_.nearest[end]) {
    return Verdict::exact;
  }
  double bound = std::fabs(t) * (level == Level::watertight ? 0x1p-46 : 0x1p-52);
  if (level == Level::fast) {
    bound = 0x1p-19 * (solid_.is_bounded() ? reach() : std::fabs(t));
  }
  return level != Level::exact && is_off_by(truth, t, bound) ? Verdict::within_bound : Verdict::wrong;
}

Verdict SolidQuestion::verdict_of_crossing(std::size_t end, double t, Level) const {
  if (t == truth_.nearest[end]) return Verdict::exact;
  return is_off_by(truth_.ends[end], t, 0x1p-35 * reach()) ? Verdict::within_bound : Verdict::wrong;
}

Verdict SolidQuestion::verdict_of_naive(std::size_t end, double t, Level) const {
  const TrueNumber& truth = truth_.ends[end];
  if (t == truth_.nearest[end] || is_nearest(truth, static_cast<float>(t))) return Verdict::exact;
  return is_off_by(truth, t, 0x1p-19 * std::fabs(t)) ? Verdict::within_bound : Verdict::wrong;
}

Example SolidQuestion::example(const std::string& expected, std::span<const double> got) const {
  return {text_of(tree_) + ", " + text_of(ray_), expected, all_digits(got)};
}

std::string all_digits(double x) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

std::string all_digits(std::span<const double> numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : ", ") + all_digits(x);
  return text.empty() ? "none" : text;
}

}  // namespace sightline::hard
