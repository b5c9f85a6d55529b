#pragma once
/// Cases of every kind that the tool must show, answered by nobody.

#include <array>
#include <stdexcept>
#include <string>

#include "tests/hard_cases/hard_case.h"

namespace sightline::stability {

using hard::HardCase, hard::Oracle, hard::Role, hard::Sketch, hard::Trial, hard::Verdict;

inline constexpr std::array all_levels{Level::fast, Level::watertight, Level::precise, Level::exact};

inline hard::Example example_of(const std::string& got) { return {"o = (0, 0, -3) & more", "t < 2", got}; }

inline void add(hard::Tally& tally, Verdict verdict, std::uint64_t count, double error = 0) {
  for (std::uint64_t i = 0; i < count; ++i) {
    tally.add(verdict, error, [&] { return example_of(verdict == Verdict::wrong ? "nothing" : "t = 2"); });
  }
}

inline Sketch fake_sketch() {
  Sketch sketch{"A sphere and a ray that grazes it, <not> to scale.", {}};
  sketch.circle({0, 0}, 1).line({-3, 1}, {3, 1}, Role::ray).dot({0, 1}, Role::truth).dot({0.5, 1}, Role::naive);
  sketch.label({0, 1}, "true: touches").label({0.5, 1}, "naive: misses, or hits twice", Role::naive);
  sketch.line({-3, 0}, {3, 0}, Role::aid).label({-3, 1}, "ray", Role::ray).label({1, 0}, "r = 1", Role::shape);
  return sketch;
}

/// Right everywhere; naive code fails in 3 of 4.
inline HardCase right_case() {
  return {.id = "ball-right",
          .group = "ball",
          .inputs = "r = 1 & \"far\" <away>",
          .expected = "√3",
          .why = "The square of a large number takes the digits of a small one.",
          .oracle = Oracle::rationals,
          .reference = "Kahan 2004",
          .run =
              [](Trial& trial) {
                for (const Level level : all_levels) {
                  for (const char* who : {"kd-tree", "grid"}) add(trial.of(who, level), Verdict::exact, 3);
                }
                add(trial.naive("naive"), Verdict::exact, 1);
                add(trial.naive("naive"), Verdict::wrong, 3);
                add(trial.naive("less naive"), Verdict::exact, 9);
                add(trial.naive("less naive"), Verdict::wrong, 1);
              },
          .draw = fake_sketch};
}

/// Wrong at fast, within bounds at watertight; asks 200.
inline HardCase fast_case() {
  return {.id = "ball-fast",
          .group = "ball",
          .inputs = "many rays",
          .expected = "hits",
          .why = "Rounding.",
          .oracle = Oracle::sturm_chains,
          .run =
              [](Trial& trial) {
                add(trial.of("sphere", Level::fast), Verdict::exact, trial.count(190));
                add(trial.of("sphere", Level::fast), Verdict::wrong, trial.count(10), 0.5);
                add(trial.of("sphere", Level::watertight), Verdict::within_bound, 7, 0x1p-53);
                add(trial.of("sphere", Level::precise), Verdict::exact, 7);
                add(trial.of("sphere", Level::exact), Verdict::exact, 7);
              },
          .draw = fake_sketch};
}

/// Without levels, a policy.
inline HardCase policy_case() {
  return {.id = "box-tie",
          .group = "box",
          .inputs = "two at once",
          .expected = "the lower id",
          .why = "Either is right.",
          .oracle = Oracle::closed_form,
          .is_policy = true,
          .run = [](Trial& trial) { add(trial.of("all"), Verdict::exact, 5); },
          .draw = fake_sketch};
}

/// One of three structures is wrong at the default.
inline HardCase wrong_case() {
  return {.id = "box-wrong",
          .group = "box",
          .inputs = "a corner",
          .expected = "a hit",
          .why = "0 * infinity",
          .oracle = Oracle::brute_force,
          .run =
              [](Trial& trial) {
                for (const char* who : {"kd-tree", "grid", "bsp-tree"}) {
                  add(trial.of(who, Level::watertight), Verdict::exact, 4);
                }
                add(trial.of("grid", Level::watertight), Verdict::wrong, 1);
              },
          .draw = fake_sketch};
}

inline HardCase failing_case() {
  return {.id = "box-throws",
          .group = "box",
          .inputs = "nothing",
          .expected = "nothing",
          .why = "It throws.",
          .oracle = Oracle::metamorphic,
          .run = [](Trial&) { throw std::runtime_error("out of rays"); },
          .draw = fake_sketch};
}

inline const std::array<HardCase, 3>& good_table() {
  static const std::array table{right_case(), fast_case(), policy_case()};
  return table;
}
inline const std::array<HardCase, 5>& bad_table() {
  static const std::array table{right_case(), fast_case(), policy_case(), wrong_case(), failing_case()};
  return table;
}

}  // namespace sightline::stability
