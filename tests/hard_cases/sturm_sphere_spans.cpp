#include <memory>

#include "tests/hard_cases/solid_question.h"
#include "tests/math/sturm.h"

namespace sightline::hard {

TrueSpans sturm_sphere_spans(const solid::Sphere& sphere, const Ray<double>& ray) {
  using oracle::Rational;
  Rational a = 0, b = 0, c = -Rational(sphere.radius) * Rational(sphere.radius);
  for (int axis = 0; axis < 3; ++axis) {
    const Rational d(ray.direction[axis]), away = Rational(ray.origin[axis]) - Rational(sphere.center[axis]);
    a += d * d, b += 2 * d * away, c += away * away;
  }
  const oracle::Polynomial polynomial = oracle::polynomial_of({c, b, a});
  const auto chain = std::make_shared<const oracle::SturmChain>(polynomial);
  TrueSpans spans;
  if (oracle::chains_of(polynomial).size() > 1) return spans;  // a double root touches
  for (int i = 0; i < chain->count(); ++i) {
    spans.ends.emplace_back([chain, i](double x, double y) {
      const Rational at = Rational(x) + Rational(y);
      const int up_to = chain->count_to(at);
      if (up_to <= i) return 1;
      return up_to == i + 1 && chain->has_root(at) ? 0 : -1;
    });
  }
  spans.round_ends();
  return spans;
}

}  // namespace sightline::hard
