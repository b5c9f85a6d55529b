#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <string>
#include <vector>

#include "bench/accuracy/chance.h"
#include "bench/claims/course.h"
#include "bench/claims/rules.h"
#include "bench/claims/tools.h"

namespace sightline::bench {
namespace {

/// As a matrix stack of depth k has them: each turns, stretches by up to a quarter and moves; the first is applied
/// last.
template <class T>
using Chain = std::vector<glm::mat<4, 4, T>>;
template <class T>
using Points = std::vector<glm::vec<4, T>>;

/// Numbers of float, so that both precisions mean the same.
Chain<double> random_chain(std::size_t length, Chance& chance) {
  Chain<double> chain;
  for (std::size_t i = 0; i < length; ++i) {
    const glm::dquat turn = glm::angleAxis(chance.between(0, 3), chance.direction());
    glm::dmat4 matrix = glm::mat4_cast(turn);
    for (int column = 0; column < 3; ++column) matrix[column] *= chance.between(0.8, 1.25);
    matrix[3] = glm::dvec4(chance.point(1), 1);
    chain.push_back(glm::dmat4(glm::mat4(matrix)));
  }
  return chain;
}

template <class T>
Chain<T> rounded(const Chain<double>& chain) {
  return {chain.begin(), chain.end()};
}

template <class T>
glm::vec<4, T> one_by_one(const Chain<T>& chain, glm::vec<4, T> p) {
  for (std::size_t i = chain.size(); i-- > 0;) p = chain[i] * p;
  return p;
}

template <class T>
glm::mat<4, 4, T> product(const Chain<T>& chain) {
  glm::mat<4, 4, T> all = chain[0];
  for (std::size_t i = 1; i < chain.size(); ++i) all = all * chain[i];
  return all;
}

/// RMS of the distance from what double finds, whose own error is 2^-29 of float's.
double error_of(const Points<float>& found, const Points<double>& truth) {
  double squares = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 off = glm::dvec3(found[i]) - glm::dvec3(truth[i]);
    squares += glm::dot(off, off);
  }
  return std::sqrt(squares / static_cast<double>(found.size()));
}

void measure_chain(const Effort& effort, std::size_t length, Finding& finding, std::vector<Condition>& conditions) {
  Chance chance(effort.seed + length);
  const std::string name = std::to_string(length) + " matrices";
  effort.say(name);
  const Chain<double> wide = random_chain(length, chance);
  const Chain<float> chain = rounded<float>(wide);
  Points<float> points;
  for (int i = 0; i < 1024; ++i) points.emplace_back(glm::vec3(chance.point(1)), 1.0f);

  Points<double> truth;
  for (const glm::vec4& p : points) truth.push_back(one_by_one(wide, glm::dvec4(p)));
  Points<float> moved(points.size()), moved_at_once(points.size());
  const glm::mat4 whole = product(chain);
  std::vector<glm::mat4> products(256);
  const Line lines[] = {{[&] {
                           for (std::size_t i = 0; i < points.size(); ++i) moved[i] = one_by_one(chain, points[i]);
                           return static_cast<double>(moved.back().x);
                         },
                         static_cast<double>(points.size())},
                        {[&] {
                           for (std::size_t i = 0; i < points.size(); ++i) moved_at_once[i] = whole * points[i];
                           return static_cast<double>(moved_at_once.back().x);
                         },
                         static_cast<double>(points.size())},
                        {[&] {
                           for (glm::mat4& made : products) made = product(chain);
                           return static_cast<double>(products.back()[3].x);
                         },
                         static_cast<double>(products.size())}};
  const Times times = time_lines(effort, name, lines);
  const Figure gain{name + ": a point through all of them over through their product", times.ratio(0, 1), "x"};
  std::vector<double> pays;
  for (std::size_t round = 0; round < times.rounds(0).size(); ++round) {
    const double spared = times.rounds(0)[round] - times.rounds(1)[round];
    pays.push_back(spared > 0 ? times.rounds(2)[round] / spared : std::numeric_limits<double>::max());
  }
  const Figure from{name + ": points from which on the product pays", estimate(pays), ""};
  const double stepwise = error_of(moved, truth), at_once = error_of(moved_at_once, truth);
  finding.figures.insert(finding.figures.end(), {{name + ": a point through all of them", times.nanoseconds(0), "ns"},
                                                 {name + ": a point through the product", times.nanoseconds(1), "ns"},
                                                 {name + ": the product", times.nanoseconds(2), "ns"},
                                                 gain,
                                                 from,
                                                 exact_figure(name + ": error through the product over through all",
                                                              at_once / stepwise, "x")});
  conditions.push_back({Condition::Kind::needed, gain, Side::above, 1});
  conditions.push_back({Condition::Kind::wanted, from, Side::below, 1});
}

Finding measure_matrices(const Effort& effort) {
  Finding finding;
  std::vector<Condition> conditions;
  for (const std::size_t length : {2, 4, 8, 16}) measure_chain(effort, length, finding, conditions);
  conclude(finding, conditions,
           "A product has to be made before it is used, so it pays where several points go through it: a mesh, or the "
           "rays that meet an instance, but not a single point");
  return finding;
}

}  // namespace

const Claim matrices_claim{
    "matrices", "Matrices multiplied beforehand are faster than a matrix after the other.",
    "1024 points through chains of 2 to 16 matrices of 4 x 4 floats, as a matrix stack holds them: one after the "
    "other, and through their product; what the product takes by itself; and the error of both against double.",
    "Holds if a point takes longer through every chain than through its product; holds with a limit if the product, "
    "which has to be made first, does not pay for a single point.",
    measure_matrices};

}  // namespace sightline::bench
