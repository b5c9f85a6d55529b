/// Long products of matrices, and the way back.

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include "sightline/math/random.h"
#include "sightline/math/transform.h"
#include "sightline/scene/matrix_stack.h"
#include "tests/hard_cases/matrix_parts.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/math/exact.h"

namespace sightline::hard {
namespace {

using exact::Rational;

// ---- mat-chain

constexpr double step_in_degrees = 0.0572957795130823;  // a thousandth, in radians
const Vec3d step_axis(1, 2, 3);

void judge_volume(Tally& tally, const Rational& determinant, std::uint64_t steps, double bound) {
  const auto off = static_cast<double>(determinant - 1);
  const Verdict verdict = off == 0 ? Verdict::exact : std::fabs(off) <= bound ? Verdict::within_bound : Verdict::wrong;
  tally.add(verdict, std::fabs(off), [&] {
    return Example{std::to_string(steps) + " turns", "determinant 1", "1 + " + all_digits(off)};
  });
}

/// Of the linear part, exactly.
Rational determinant_of(const glm::mat4& m) {
  Affine same;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) same.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = m[k][i];
  }
  return exact::Map(same).determinant();
}

void run_chain(Trial& trial) {
  const std::uint64_t steps = trial.count(1'000'000);
  const Transform step = Transform::rotation(step_axis, step_in_degrees);
  const glm::mat4 narrow_step = glm::rotate(glm::mat4(1), 0.001f, glm::normalize(Vec3f(step_axis)));
  MatrixStack stack;
  glm::mat4 narrow(1);
  for (std::uint64_t i = 0; i < steps; ++i) stack.multiply(step), narrow = narrow * narrow_step;
  // Each step adds what the rotation itself is off, and three roundings of sums that are at most sqrt(3) long a row: 9
  // units in the norm of matrices, which changes a determinant of 1 by 16 at most.
  const auto own = static_cast<double>(abs(Rational(exact::Map(step.matrix()).determinant() - 1)));
  const double bound = static_cast<double>(steps) * (own + 16 * 0x1p-53);
  const Transform& turned = stack.current();
  judge_volume(trial.of("MatrixStack"), exact::Map(turned.matrix()).determinant(), steps, bound);
  judge_volume(trial.of("MatrixStack, the inverse"), exact::Map(turned.inverse()).determinant(), steps, bound);
  judge_volume(trial.naive("4 x 4 matrices of float"), determinant_of(narrow), steps, 0x1p-19);
}

Sketch draw_chain() {
  Sketch sketch{"A square turned again and again by a matrix of float; its growth is exaggerated.", {}};
  for (int i = 0; i <= 5; ++i) {
    const double angle = 0.3 * i, size = 1 + 0.08 * i;
    std::vector<glm::dvec2> corners;
    for (int k = 0; k < 4; ++k) {
      const double at = angle + 1.5708 * k;
      corners.emplace_back(size * std::cos(at), size * std::sin(at));
    }
    sketch.polygon(std::move(corners), i == 0 ? Role::shape : Role::naive);
  }
  return sketch.circle({0, 0}, 1, Role::truth)
      .label({-1.3, 1.6}, "determinant 1 + 0.046 after a million turns in float", Role::naive)
      .label({-1.3, -1.7}, "truth: the same square, turned", Role::truth);
}

// ---- mat-pop-inverse

Transform random_step(Random& random) {
  const Vec3d a = random_in_cube(random);
  switch (random.below(3)) {
    case 0:
      return Transform::translation(a);
    case 1:
      return Transform::rotation({a.x, a.y, 1}, 360 * a.z);
    default:
      return Transform::scaling({1 + 0.5 * a.x, -1 + 0.5 * a.y, 1});
  }
}

glm::mat4 narrow_matrix(const Affine& map) {
  glm::mat4 m(1);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k)
      m[k][i] = static_cast<float>(map.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]);
  }
  return m;
}

void run_pop_inverse(Trial& trial) {
  Random random(101);
  MatrixStack stack;
  for (int i = 0; i < 10; ++i) stack.multiply(random_step(random));
  const Transform kept = stack.current();
  const glm::mat4 narrow_kept = narrow_matrix(kept.matrix());
  glm::mat4 narrow = narrow_kept;
  for (std::uint64_t i = 0, count = trial.count(100'000); i < count; ++i) {
    const Transform step = random_step(random);
    {
      const auto scope = stack.scope();
      stack.multiply(step);
    }
    trial.of("MatrixStack").decide(stack.current() == kept, [&] {
      return Example{"push, a step and pop for the " + std::to_string(i + 1) + "th time", "the same bits", "others"};
    });
    const glm::mat4 narrow_step = narrow_matrix(step.matrix());
    narrow = narrow * narrow_step * glm::inverse(narrow_step);
    trial.naive("the step's inverse, in float").decide(narrow == narrow_kept, [&] {
      return Example{"a step and its inverse for the " + std::to_string(i + 1) + "th time",
                     all_digits(double(narrow_kept[0][0])), all_digits(double(narrow[0][0]))};
    });
  }
}

Sketch draw_pop_inverse() {
  Sketch sketch{"Where one comes back to by undoing steps, drawn 10^5 times as far off as it is.", {}};
  sketch.dot({0, 0}).label({-0.3, -0.4}, "pushed, and popped", Role::truth);
  glm::dvec2 at(0);
  for (int i = 0; i < 6; ++i) {
    const glm::dvec2 next = at + glm::dvec2(0.35 + 0.05 * (i % 3), 0.18 - 0.12 * (i % 2));
    sketch.line(at, at + glm::dvec2(0.1, 1.4), Role::ray).line(at + glm::dvec2(0.1, 1.4), next, Role::naive);
    at = next;
  }
  return sketch.dot(at, Role::naive).label({1, -0.3}, "a step, its inverse, a step, its inverse ...", Role::naive);
}

// ---- mat-far-translate

void run_far_translate(Trial& trial) {
  Random random(102);
  for (std::uint64_t i = 0, count = trial.count(3000); i < count; ++i) {
    const double by_power = std::ldexp(1.0, 20 + static_cast<int>(random.below(30)));
    const double far = i == 0 ? 1e7 : i % 2 == 0 ? by_power + random.below(1000) : 1e7 + random.below(1u << 20);
    const Vec3d p = i == 0 ? Vec3d(0.125) : 0.125 * random_lattice_vector(random, 64), by(far, -far, far / 2);
    const std::string inputs = vector_text(p) + ", there and back by " + vector_text(by);
    const auto judge = [&](Tally& tally, const Vec3d& got) {
      // Sums of at most 50 bits before the point and 4 behind: the true way there and back leads to p.
      tally.decide(exact::point(got) == exact::point(p), [&] {
        return Example{inputs, vector_text(p), vector_text(got)};
      });
    };
    const Transform there = Transform::translation(by);
    judge(trial.of("Transform, by points"), there.inverted().point(there.point(p)));
    // However far: what is put together beforehand is nothing.
    const Transform farther = Transform::translation(1e9 * by + 0.1);
    judge(trial.of("Transform, as a product"), (farther.inverted() * farther).point(p));
    MatrixStack stack;
    stack.translate(1e9 * by + 0.1);
    stack.translate(-(1e9 * by + 0.1));
    judge(trial.of("MatrixStack"), stack.current().point(p));
    judge(trial.naive("p + by - by in float"), Vec3d(Vec3f(p) + Vec3f(by) - Vec3f(by)));
  }
}

Sketch draw_far_translate() {
  Sketch sketch{"Floats around 10^7 are whole numbers: 0.125 has no place among them.", {}};
  sketch.line({-0.5, 0}, {3.5, 0}, Role::aid);
  for (int i = 0; i <= 3; ++i) {
    sketch.line({static_cast<double>(i), -0.15}, {static_cast<double>(i), 0.15}, Role::shape);
    sketch.label({i - 0.2, -0.5}, i == 0 ? "1e7" : "+" + std::to_string(i));
  }
  return sketch.dot({0.125, 0})
      .dot({0, 0}, Role::naive)
      .label({0.2, 0.3}, "1e7 + 0.125: in double", Role::truth)
      .label({-0.5, 0.8}, "rounded to 1e7; taken back, 0", Role::naive);
}

}  // namespace

HardCase matrix_chain() {
  return {.id = "mat-chain",
          .group = "matrix",
          .inputs = "a million turns by 0.001 about (1, 2, 3), one multiplied onto the other",
          .expected = "determinant 1, within a million times 16 roundings of double and what one turn is off",
          .why =
              "A turn rounded to float is no turn: its determinant is off by some 1e-8, always to the same side, and a "
              "million of them grow the scene by 4.6 percent. Double makes it 1e9 times as small; turning anew from "
              "the whole angle avoids it.",
          .oracle = Oracle::closed_form,
          .reference = {},
          .is_policy = false,
          .run = run_chain,
          .draw = draw_chain};
}

HardCase matrix_pop_inverse() {
  return {.id = "mat-pop-inverse",
          .group = "matrix",
          .inputs = "10^5 times: keep the matrix, move, turn or scale, and take it back",
          .expected = "the same bits each time",
          .why =
              "M S S^-1 is not M: each product rounds, and the inverse of a rounded step does, too. The drift is small "
              "a time and adds up. A stack copies what it keeps, and undoes nothing.",
          .oracle = Oracle::metamorphic,
          .reference = {},
          .is_policy = false,
          .run = run_pop_inverse,
          .draw = draw_pop_inverse};
}

HardCase matrix_far_translate() {
  return {
      .id = "mat-far-translate",
      .group = "matrix",
      .inputs = "(0.125, 0.125, 0.125) and other eighths, there and back by 1e7 to 2^50; as products by 1e9 times that",
      .expected = "the place itself",
      .why =
          "Floats have 24 bits. Beyond 2^24 they are whole numbers, and an eighth added to 1e7 is lost at once: a "
          "far scene collapses onto a grid. In double there are 53, and two translations multiplied first are "
          "none at all.",
      .oracle = Oracle::rationals,
      .reference = {},
      .is_policy = false,
      .run = run_far_translate,
      .draw = draw_far_translate};
}

}  // namespace sightline::hard
