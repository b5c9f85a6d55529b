/// Rays that are nearly tangent to a torus.

#include <algorithm>
#include <complex>

#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_solid.h"
#include "tests/hard_cases/families/families.h"
#include "tests/math/sturm.h"

namespace sightline::hard {
namespace {

using oracle::Rational;
using Coefficients = std::vector<Rational>;  // lowest first

Coefficients times(const Coefficients& a, const Coefficients& b) {
  Coefficients product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  }
  return product;
}

void add(Coefficients& sum, const Rational& factor, const Coefficients& b) {
  for (std::size_t i = 0; i < b.size(); ++i) sum[i] += factor * b[i];
}

/// a.a (q.q + R^2 - r^2)^2 - 4 R^2 (a.a q.q - (q.a)^2), q from the center to the line's points.
Coefficients quartic(const Torus& torus, const Ray<double>& ray) {
  Coefficients qq(3), qa(2);
  Rational aa = 0;
  for (int i = 0; i < 3; ++i) {
    const Rational a(torus.axis[i]);
    const Coefficients q{Rational(ray.origin[i]) - Rational(torus.center[i]), Rational(ray.direction[i])};
    add(qq, 1, times(q, q));
    add(qa, a, q);
    aa += a * a;
  }
  const Rational major(torus.major), minor(torus.minor);
  Coefficients g = qq;
  g[0] += major * major - minor * minor;
  Coefficients f = times({aa}, times(g, g));
  add(f, -4 * major * major * aa, qq);
  add(f, 4 * major * major, times(qa, qa));
  return f;
}

/// By Sturm chains: how many roots there are, and how many up to a number. Of tangents, whose root is double, nothing
/// is asked here.
TrueEnds truth_of(const Torus& torus, const Ray<double>& ray) {
  const auto chain = std::make_shared<const oracle::SturmChain>(oracle::polynomial_of(quartic(torus, ray)));
  TrueEnds truth;
  for (int i = 0; i < chain->count(); ++i) {
    // The root number i is above x where no more than i roots are up to there.
    const auto is_above = [chain, i](const Rational& x) { return chain->count_to(x) <= i; };
    truth.ends.push_back({[=](double t) {
                            const double inf = std::numeric_limits<double>::infinity();
                            return is_above(oracle::boundary(t, -inf)) && !is_above(oracle::boundary(t, inf));
                          },
                          [=](double t, double bound) {
                            return is_above(Rational(t) - Rational(bound)) && !is_above(Rational(t) + Rational(bound));
                          },
                          is_above(Rational(0))});
  }
  return truth;
}

/// Ferrari's formula, "Ars Magna", 1545, by complex numbers in double; a root is real where its imaginary part is below
/// the usual constant.
int ferrari_count(const Coefficients& f) {
  using Complex = std::complex<double>;
  const auto c = [&](std::size_t i) { return (f[i] / f[4]).convert_to<double>(); };
  const double b = c(3), p = c(2) - 3 * b * b / 8, q = b * b * b / 8 - b * c(2) / 2 + c(1),
               r = -3 * b * b * b * b / 256 + b * b * c(2) / 16 - b * c(1) / 4 + c(0);
  // Of the resolvent y^3 - p y^2 / 2 - r y + r p / 2 - q^2 / 8, by Cardano.
  const double a2 = -p / 2, a1 = -r, a0 = r * p / 2 - q * q / 8;
  const double m = a1 / 3 - a2 * a2 / 9, n = (a1 * a2 - 3 * a0) / 6 - a2 * a2 * a2 / 27;
  const Complex root = std::sqrt(Complex(m * m * m + n * n));
  const Complex s = std::pow(n + root, 1.0 / 3), y = s + (s == 0.0 ? Complex(0) : -m / s) - a2 / 3;
  const Complex w = std::sqrt(2.0 * y - p), rest = w == 0.0 ? Complex(0) : q / (2.0 * w);
  int count = 0;
  for (const double side : {-1.0, 1.0}) {
    const Complex inner = std::sqrt(w * w - 4.0 * (y + side * rest));
    for (const Complex& x : {(side * w + inner) / 2.0, (side * w - inner) / 2.0})
      count += std::fabs(x.imag()) < 0.000001;
  }
  return count;
}

void ask_tangents(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const AnyFrame frame(random);
  const Torus torus{any_point(random), frame.z, 2, 1};
  std::vector<AskedRay> questions;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double angle = 6.25 * random.uniform_double(), up = any_point(random).x, turn = any_point(random).x;
    const Vec3d outward = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
    const Vec3d around = -std::sin(angle) * frame.x + std::cos(angle) * frame.y;
    // A point of the outer half, where the ring bends away to all sides, its normal, and a tangent.
    const Vec3d normal = std::cos(up) * outward + std::sin(up) * frame.z;
    const Vec3d across = -std::sin(up) * outward + std::cos(up) * frame.z;
    const Vec3d way = std::cos(turn) * around + std::sin(turn) * across;
    const double away = 1 + std::ldexp(i % 2 == 0 ? -1.0 : 1.0, -difficulty);
    const Ray<double> ray{torus.center + 2.0 * outward + away * normal - 5.0 * way, way};
    questions.push_back({ray, truth_of(torus, ray)});
  }
  ask_lists(torus, questions, trial);
  ask_structures(torus, questions, trial);
  for (const auto& [ray, truth] : questions) {
    const int found = ferrari_count(quartic(torus, ray));
    trial.naive("Ferrari in double")
        .decide(static_cast<std::size_t>(found) == truth.ends.size(), [&, &ray = ray, &truth = truth] {
          return Example{text_of(ray), std::to_string(truth.ends.size()) + " roots", std::to_string(found) + " roots"};
        });
  }
}

}  // namespace

Family torus_tangents() {
  return {"tangents",
          "Rays that nearly touch a ring, radii 2 and 1, on its outer half: where they enter and leave.",
          "rays are tangents moved by 2^-k, inward or outward",
          "k: 2^-k beside the tangent",
          1,
          46,
          Oracle::sturm_chains,
          ask_tangents};
}

}  // namespace sightline::hard
