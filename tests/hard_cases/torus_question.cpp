#include "tests/hard_cases/torus_question.h"

#include "tests/csg/random_solid.h"

namespace sightline::hard {
namespace {

using oracle::Rational;
using Series = std::vector<Rational>;  // by powers of t

Series product(const Series& a, const Series& b) {
  Series result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}
void add(Series& a, const Series& b, const Rational& factor = 1) {
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
}

/// (a.a) (q.q + R^2 - r^2)^2 - 4 R^2 ((a.a) q.q - (q.a)^2) for q = o + t d - c.
Series torus_series(const Torus& torus, const Ray<double>& ray) {
  Series qq(3), qa(2);
  Rational aa = 0;
  for (int i = 0; i < 3; ++i) {
    const Rational a(torus.axis[i]);
    const Series q = {Rational(ray.origin[i]) - Rational(torus.center[i]), Rational(ray.direction[i])};
    add(qq, product(q, q));
    add(qa, q, a);
    aa += a * a;
  }
  const Rational major2 = Rational(torus.major) * Rational(torus.major);
  Series g = qq;
  g[0] += major2 - Rational(torus.minor) * Rational(torus.minor);
  Series f = product({aa}, product(g, g));
  add(f, qq, -4 * major2 * aa);
  add(f, product(qa, qa), 4 * major2);
  return f;
}

std::string text_of(const TorusAndRay& given) {
  return sightline::text_of(SolidTree(given.torus)) + ", " + sightline::text_of(given.ray);
}

Vec3d turned(const Vec3d& v, int by) { return {v[by % 3], v[(by + 1) % 3], v[(by + 2) % 3]}; }

}  // namespace

TorusAndRay varied(const TorusAndRay& given, Random& random) {
  const double size = 1 + random.below(12), speed = 1 + random.below(12), back = random.below(12);
  const int turn = static_cast<int>(random.below(3));
  const Vec3d move(random.below(9), random.below(9), random.below(9)), axis = turned(given.torus.axis, turn);
  const Vec3d way = turned(given.ray.direction, turn);
  return {{size * turned(given.torus.center, turn) + move, (1.0 + random.below(3)) * axis, size * given.torus.major,
           size * given.torus.minor},
          {size * turned(given.ray.origin, turn) + move - back * way, speed * way}};
}

TorusQuestion::TorusQuestion(const TorusAndRay& given)
    : given_(given),
      roots_(text_of(given), torus_series(given.torus, given.ray)),
      solid_(given.torus, given.ray, roots_.spans()) {}

void TorusQuestion::ask(Trial& trial) const {
  solid_.ask_spans(trial, "torus");
  solid_.ask_first(trial, "torus's first boundary");
  for (const Level level : {Level::precise, Level::exact}) {
    roots_.judge(trial.of("roots of the torus", level), torus_roots(given_.torus, given_.ray, level), level);
  }
}

void TorusQuestion::ask_structures(Trial& trial, const Vec3d& apart) const {
  std::vector<SolidTree> operands;
  for (int i = -4; i <= 4; ++i) {
    Torus torus = given_.torus;
    torus.center += double(i) * apart;
    operands.emplace_back(torus);
  }
  const UnionByStructure all(std::move(operands));
  SolidQuestion(all.tree(), given_.ray, roots_.spans()).ask_spans(trial, all);
}

std::array<double, 5> TorusQuestion::naive_polynomial() const {
  const Vec3d axis = glm::normalize(given_.torus.axis), o = given_.ray.origin - given_.torus.center,
              d = given_.ray.direction;
  const double major2 = given_.torus.major * given_.torus.major, minor2 = given_.torus.minor * given_.torus.minor;
  const double g2 = glm::dot(d, d), g1 = 2 * glm::dot(o, d), g0 = glm::dot(o, o) + major2 - minor2;
  const double along = glm::dot(d, axis), height = glm::dot(o, axis);
  return {g0 * g0 - 4 * major2 * (glm::dot(o, o) - height * height),
          2 * g0 * g1 - 4 * major2 * (g1 - 2 * along * height),
          g1 * g1 + 2 * g0 * g2 - 4 * major2 * (g2 - along * along), 2 * g1 * g2, g2 * g2};
}

}  // namespace sightline::hard
