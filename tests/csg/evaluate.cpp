#include "tests/csg/evaluate.h"

#include "sightline/csg/evaluator.h"

namespace sightline {
namespace {

/// Calls use(evaluator) of a level.
template <class Use>
auto with_evaluator(const Solid& solid, const Ray<double>& ray, Level level, Use&& use) {
  const auto at = [&]<Level l>(std::integral_constant<Level, l>) {
    NoSolidProbe probe;
    SolidEvaluator<l> evaluator(solid, ray, probe);
    return use(evaluator);
  };
  switch (level) {
    case Level::fast:
      return at(std::integral_constant<Level, Level::fast>());
    case Level::watertight:
      return at(std::integral_constant<Level, Level::watertight>());
    case Level::precise:
      return at(std::integral_constant<Level, Level::precise>());
    case Level::exact:
      break;
  }
  return at(std::integral_constant<Level, Level::exact>());
}

}  // namespace

Spans spans_of(const Solid& solid, const Ray<double>& ray, Level level) {
  return with_evaluator(solid, ray, level, [](auto& evaluator) {
    const SpanList list = evaluator.spans();
    const auto boundaries = evaluator[list];
    return Spans{list.begins_inside, {boundaries.begin(), boundaries.end()}};
  });
}

std::optional<Boundary> first_of(const Solid& solid, const Ray<double>& ray, double t_min, double t_max, Level level) {
  return with_evaluator(solid, ray, level, [&](auto& evaluator) { return evaluator.first(t_min, t_max); });
}

}  // namespace sightline
