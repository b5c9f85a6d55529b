/// Quadratic equations whose roots are close together, of all sizes: quadrics along an axis.

#include <algorithm>

#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_solid.h"
#include "tests/hard_cases/families/families.h"
#include "tests/hard_cases/families/naive.h"

namespace sightline::hard {
namespace {

/// a (x - r) (x - s) as coefficients, rounded: what is asked are the roots of those.
void ask_quadratics(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto size = [&](int most) {
      return static_cast<int>(random.below(2 * static_cast<std::uint32_t>(most))) - most;
    };
    const double a = std::ldexp(0.5 + random.uniform_double(), size(40));
    const double r = std::ldexp(0.5 + random.uniform_double(), size(40)) * (i % 3 == 0 ? -1 : 1);
    const double s = r * (1 + std::ldexp(1.0, -difficulty));
    const double b = -a * (r + s), c = a * r * s;
    const solid::Quadric quadric{{a, 0, 0, 0, 0, 0, b, 0, 0, c}};
    const Ray<double> ray{Vec3d(0), Vec3d(1, 0, 0)};
    const std::vector<AskedRay> question{{ray, true_spans(quadric, ray)}};
    ask_lists(quadric, question, trial);
    const std::size_t expected = question[0].truth.ends.size();  // a double root only touches
    const auto tell = [&](std::string_view who, int found) {
      const std::size_t ends = found == 2 ? 2 : 0;
      trial.naive(who).decide(ends == expected, [&] {
        return Example{text_of_number(a) + " t^2 + " + text_of_number(b) + " t + " + text_of_number(c),
                       std::to_string(expected) + " simple roots", std::to_string(ends)};
      });
    };
    tell("school formula in float",
         school_root_count(static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)));
    tell("school formula in double", school_root_count(a, b, c));
  }
}

}  // namespace

Family quadratics() {
  return {
      "quadratics",
      "Roots of a t^2 + b t + c, that are close together and between 2^-40 and 2^40: how many there are, and where.",
      "the roots differ by 2^-k of themselves, so that the discriminant is 2^-2k of what it is the difference of",
      "k: roots 2^-k apart",
      1,
      40,
      Oracle::rationals,
      ask_quadratics};
}

}  // namespace sightline::hard
