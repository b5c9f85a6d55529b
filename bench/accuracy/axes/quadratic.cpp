#include <array>
#include <memory>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/axes/root_choice.h"
#include "bench/accuracy/chance.h"
#include "sightline/csg/settle.h"
#include "sightline/math/quadratic.h"

namespace sightline::bench {
namespace {

/// Of a t^2 + 2 b t + c.
struct Coefficients {
  double a, b, c;
};

/// -b +- sqrt(b^2 - a c), over a.
template <class T>
FewRoots textbook(const Coefficients& of) {
  const T a = static_cast<T>(of.a), b = static_cast<T>(of.b), c = static_cast<T>(of.c), discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return {};
  if (discriminant == 0) return {1, {-b / a}};
  const T root = std::sqrt(discriminant);
  return in_order((-b - root) / a, (-b + root) / a);
}

/// The larger root without cancellation, the other by the product of both (Kahan, 2004); with_fma: the discriminant to
/// one rounding as well.
template <class T, bool with_fma>
FewRoots stable(const Coefficients& of) {
  const T a = static_cast<T>(of.a), b = static_cast<T>(of.b), c = static_cast<T>(of.c);
  T discriminant = b * b - a * c;
  if constexpr (with_fma) {
    const T product = a * c;
    discriminant = std::fma(b, b, -product) + std::fma(-a, c, product);
  }
  if (!(discriminant >= 0)) return {};
  if (discriminant == 0) return {1, {-b / a}};
  const T q = -(b + std::copysign(std::sqrt(discriminant), b));
  return in_order(q / a, c / q);
}

template <class N>
FewRoots ours(const Coefficients& of) {
  if constexpr (std::is_floating_point_v<N>) {
    return few_of(quadratic_roots(static_cast<N>(of.a), static_cast<N>(of.b), static_cast<N>(of.c)));
  } else {  // wider numbers where these do not tell enough
    const RootList list = quadratic_roots(DoubleBall(of.a), DoubleBall(of.b), DoubleBall(of.c));
    if (is_accurate(list, Level::watertight)) return few_of(list);
    return few_of(quadratic_roots(WideBall(DoubleDouble(of.a), 0), WideBall(DoubleDouble(of.b), 0),
                                  WideBall(DoubleDouble(of.c), 0)));
  }
}

enum class Kind { apart, close, close_doubles };

Panel panel_of(const Effort& effort, Kind kind) {
  const bool is_close = kind != Kind::apart, are_doubles = kind == Kind::close_doubles;
  Chance chance(effort.seed);
  const auto count = effort.count(40'000, 8'000);
  auto questions = std::make_shared<std::vector<Coefficients>>();
  // Floats, so that every choice is given the same polynomial; or doubles for those of doubles.
  const auto as_float = [&](double x) { return are_doubles ? x : static_cast<double>(static_cast<float>(x)); };
  const double closest = are_doubles ? 0x1p-40 : 0x1p-26;
  while (questions->size() < count) {
    const double near = chance.sign() * chance.scale(0.1, 10);
    const double far =
        is_close ? near * (1 + chance.sign() * chance.scale(closest, 0x1p-6)) : chance.sign() * chance.scale(0.1, 1e6);
    const double a = as_float(chance.sign() * chance.scale(0.1, 10));
    questions->push_back({a, as_float(-a * (near + far) / 2), as_float(a * near * far)});
  }
  std::vector<std::vector<True>> truths;
  for (const Coefficients& of : *questions) truths.push_back(true_quadratic_roots(of.a, of.b, of.c));
  Panel panel{are_doubles ? "close, doubles"
              : is_close  ? "close roots"
                          : "roots apart",
              are_doubles ? "coefficients of 53 bits, roots 2^-40 to 2^-6 of themselves apart, or just not there"
              : is_close  ? "coefficients of 24 bits, roots 2^-26 to 2^-6 of themselves apart, or just not there"
                          : "coefficients of 24 bits, roots of 0.1 to 1e6",
              "quadratic",
              "of a root, as a share of it",
              is_close ? ErrorKind::wrong : ErrorKind::maximum,
              static_cast<double>(count)};
  const auto add = [&]<class Solve>(const std::string& name, Solve solve) {
    panel.choices.push_back(root_choice(name, std::shared_ptr<const std::vector<Coefficients>>(questions), truths,
                                        solve,
                                        [](const Coefficients&, const True& root) { return std::fabs(root.high); }));
  };
  if (!are_doubles) add("textbook float", [](const Coefficients& of) { return textbook<float>(of); });
  add("textbook double", [](const Coefficients& of) { return textbook<double>(of); });
  if (!are_doubles) add("Kahan float", [](const Coefficients& of) { return stable<float, false>(of); });
  add("Kahan double", [](const Coefficients& of) { return stable<double, false>(of); });
  if (!are_doubles) add("Kahan fma float", [](const Coefficients& of) { return stable<float, true>(of); });
  add("Kahan fma double", [](const Coefficients& of) { return stable<double, true>(of); });
  if (!are_doubles) add("ours float", [](const Coefficients& of) { return ours<float>(of); });
  add("ours double", [](const Coefficients& of) { return ours<double>(of); });
  add("ours watertight", [](const Coefficients& of) { return ours<DoubleBall>(of); });
  return panel;
}

}  // namespace

Axis quadratic_axis() {
  return {"quadratic", "how the roots of a quadratic are found", [](const Effort& effort) {
            return std::vector{panel_of(effort, Kind::apart), panel_of(effort, Kind::close),
                               panel_of(effort, Kind::close_doubles)};
          }};
}

}  // namespace sightline::bench
