/// Roundings that a compiler drops, tiny numbers and NaN that flags do away with, and conversions.

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "sightline/math/rounding.h"
#include "sightline/noise/lattice.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/build_parts.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// ---- gcc12-slp-roundtrip: what lib/cmake/slp_canary.cpp asks, of many numbers

struct Double3 {
  double x, y, z;
};
struct Float3 {
  float x, y, z;
};
struct Seen {
  double at[6];
};

[[gnu::noinline]] void see(Double3 a, Double3 b, Seen& seen) { seen = {{a.x, a.y, a.z, b.x, b.y, b.z}}; }

[[gnu::noinline]] void round_trip(Double3 target, Double3 way, double scale, float* keep, Seen& seen) {
  const Double3 start{target.x * scale - way.x * 16., target.y * scale - way.y * 16., target.z * scale - way.z * 16.};
  const Float3 origin{static_cast<float>(start.x), static_cast<float>(start.y), static_cast<float>(start.z)};
  const Float3 direction{static_cast<float>(way.x), static_cast<float>(way.y), static_cast<float>(way.z)};
  const Double3 o{origin.x, origin.y, origin.z}, d{direction.x, direction.y, direction.z};
  keep[0] = origin.x * direction.x + origin.y * direction.y + origin.z * direction.z;
  keep[1] = static_cast<float>(o.x * d.x + o.y * d.y + o.z * d.z);
  see(o, d, seen);
}

/// The same without its roundings, as that vectorizer compiles it.
[[gnu::noinline]] void dropped_trip(Double3 target, Double3 way, double scale, Seen& seen) {
  see({target.x * scale - way.x * 16., target.y * scale - way.y * 16., target.z * scale - way.z * 16.}, way, seen);
}

/// By its bits alone: a float has 24.
bool is_float(double x) { return (std::bit_cast<std::uint64_t>(x) & 0x1fff'ffffu) == 0; }

void judge(Tally& tally, const Seen& seen) {
  for (const double x : seen.at) {
    tally.decide(is_float(x), [&] {
      return Example{"a double, rounded to float and back", "a number of 24 bits", all_digits(x)};
    });
  }
}

void run_round_trip(Trial& trial) {
  Random random(42);
  for (std::uint64_t i = 0, count = trial.count(20000); i < count; ++i) {
    Double3 target{0.1, 0.2, 0.3}, way{0.7, 0.6, 0.5};
    if (i > 0) {
      const Vec3d a = random_in_cube(random) + 2.0, b = random_in_cube(random) + 2.0;
      target = {a.x, a.y, a.z}, way = {b.x, b.y, b.z};
    }
    float keep[2];
    Seen seen;
    round_trip(target, way, 1.1, keep, seen);
    judge(trial.of("double to float and back, as this build compiles it"), seen);
    dropped_trip(target, way, 1.1, seen);
    judge(trial.naive("the same with its roundings dropped, as by GCC 12.2 -O2"), seen);
  }
}

Sketch draw_round_trip() {
  Sketch sketch{"The numbers of float and of double on a line, coarse and fine. Here 8 doubles lie between floats.",
                {}};
  sketch.line({0, 0}, {4, 0}, Role::aid);
  for (int i = 0; i <= 32; ++i) sketch.line({i / 8.0, 0}, {i / 8.0, i % 8 == 0 ? 0.5 : 0.15}, Role::shape);
  return sketch.dot({1.625, 0}, Role::aid)
      .dot({2, 0})
      .label({1.4, -0.3}, "x")
      .label({1.95, -0.3}, "(double) (float) x")
      .label({0.2, 0.9}, "dropped, it is x itself: rays are not those that float would trace", Role::naive);
}

// ---- fast-math-ftz

/// As a processor computes that is told to flush: -Ofast sets that for the whole program.
float flushed(float x) { return std::fabs(x) < std::numeric_limits<float>::min() ? 0 : x; }

/// As -ffast-math may turn comparisons round, since it may take for granted that there is no NaN.
bool turned_slabs(const solid::Box& box, const Ray<double>& ray) {
  double near = 0, far = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double inverse = 1 / ray.direction[i], a = (box.lo[i] - ray.origin[i]) * inverse,
                 b = (box.hi[i] - ray.origin[i]) * inverse;
    const double first = !(a <= b) ? b : a, last = !(a >= b) ? b : a;
    if (!(first <= near)) near = first;
    if (!(last >= far)) far = last;
  }
  return near <= far;
}

/// x of float is m steps of 2^-149.
void judge_tiny(Tally& tally, float x, std::uint32_t m) {
  tally.decide(std::bit_cast<std::uint32_t>(x) == m, [&] {
    return Example{"a result of " + std::to_string(m) + " times 2^-149", all_digits(std::ldexp(double(m), -149)),
                   all_digits(double(x))};
  });
}

void run_tiny(Trial& trial) {
  Random random(43);
  for (std::uint64_t i = 0, count = trial.count(20000); i < count; ++i) {
    const std::uint32_t m = i == 0 ? 71362 : random.below(1u << 22), n = random.below(1u << 22);
    volatile float a = std::bit_cast<float>(m), b = std::bit_cast<float>(n), one = 1, half = 0.5f;
    Tally& built = trial.of("denormal floats, as this build computes");
    judge_tiny(built, a * one, m);
    judge_tiny(built, a + b, m + n);
    judge_tiny(built, std::bit_cast<float>(2 * m) * half, m);
    judge_tiny(trial.of("next_up of denormal floats"), next_up(float(a)), m + 1);
    judge_tiny(trial.naive("flushed to zero"), flushed(flushed(a) * one), m);
  }
}

void run_fast_math(Trial& trial) {
  run_tiny(trial);
  // Rays along the axes, in the planes of faces: o - lo and d are 0, and 0 times infinity is NaN.
  const solid::Box box;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double at : {-1.0, 1.0}) {
      for (const double other : {-0.5, 0.5}) {
        for (const double zero : {0.0, -0.0}) {
          for (const double speed : {1.0, -1.0}) {
            Ray<double> ray{Vec3d(0), Vec3d(zero)};
            ray.direction[axis] = speed, ray.origin[axis] = -3 * speed;
            ray.origin[(axis + 1) % 3] = at, ray.origin[(axis + 2) % 3] = other;
            SolidQuestion(box, ray).ask_spans(trial, "box");
            SolidQuestion(box, ray).ask_first(trial, "box's first boundary");
            const bool is_hit = turned_slabs(box, ray);
            trial.naive("slabs with comparisons turned round").decide(is_hit, [&] {
              return Example{text_of(ray), "hit", is_hit ? "hit" : "miss"};
            });
          }
        }
      }
    }
  }
}

Sketch draw_fast_math() {
  Sketch sketch{"A box, and a ray in the plane of one of its faces: where the plane is met is 0 / 0.", {}};
  return sketch.rectangle({-1, -1}, {1, 1})
      .line({-3, 1}, {3, 1}, Role::ray)
      .dot({-1, 1})
      .dot({1, 1})
      .label({-0.9, 1.15}, "NaN < far is false: the axis does not count, and the ray hits")
      .label({-2.9, 0.6}, "turned round, NaN wins: miss", Role::naive);
}

// ---- float-int-cast

/// What x86 answers at run time to a number that does not fit.
int cast_at_run_time(double x) { return std::fabs(x) < 0x1p31 ? static_cast<int>(x) : std::numeric_limits<int>::min(); }
/// What the compiler answers where it knows the number.
int cast_when_folded(double x) {
  if (std::isnan(x)) return 0;
  if (std::fabs(x) < 0x1p31) return static_cast<int>(x);
  return x > 0 ? std::numeric_limits<int>::max() : std::numeric_limits<int>::min();
}

void judge_index(Tally& tally, double x, int count, int got) {
  // Where x is between, it fits.
  const int truth = !(x > 0) ? 0 : x >= count - 1 ? count - 1 : static_cast<int>(x);
  tally.decide(got == truth, [&] {
    return Example{all_digits(x) + " in " + std::to_string(count), std::to_string(truth), std::to_string(got)};
  });
}

void judge_key(Tally& tally, double x, std::uint32_t got) {
  const boost::multiprecision::cpp_int size(std::fabs(x));
  const auto low = static_cast<std::uint32_t>(boost::multiprecision::cpp_int(size & 0xffff'ffffu));
  const std::uint32_t truth = x < 0 ? 0u - low : low;
  tally.decide(got == truth, [&] {
    return Example{all_digits(x) + " mod 2^32", std::to_string(truth), std::to_string(got)};
  });
}

void run_float_to_int(Trial& trial) {
  Random random(44);
  const float first[] = {std::nanf(""), 3e9f, -3e9f, infinity, -infinity, 0x1p31f, -0.0f, 1e-40f, -0.5f, 3e38f};
  for (std::uint64_t i = 0, all = std::max<std::uint64_t>(trial.count(20000), std::size(first)); i < all; ++i) {
    const float x = i < std::size(first) ? first[i] : std::bit_cast<float>(random.next());  // any, NaN included
    const int count = 1 + static_cast<int>(random.below(1u << random.below(20)));
    judge_index(trial.of("clamp_to_index of float"), x, count, clamp_to_index(x, count));
    judge_index(trial.of("clamp_to_index of double"), x, count, clamp_to_index(double(x), count));
    judge_index(trial.naive("(int) x, then held in [0, n), at run time"), x, count,
                std::clamp(cast_at_run_time(x), 0, count - 1));
    judge_index(trial.naive("(int) x where the compiler knows x"), x, count, cast_when_folded(x));
    if (!std::isfinite(x)) continue;
    const double whole = std::floor(std::ldexp(double(x), static_cast<int>(random.below(60))));
    judge_key(trial.of("keys of the noise's lattice"), whole, far_key(whole, true));
    judge_key(trial.naive("(unsigned) (int) x, at run time"), whole,
              static_cast<std::uint32_t>(cast_at_run_time(whole)));
  }
}

Sketch draw_float_to_int() {
  Sketch sketch{"The cell of x in a grid of 8 cells: held within them, and as a processor converts what does not fit.",
                {}};
  for (int i = 0; i < 8; ++i) sketch.rectangle({double(i), 0}, {i + 1.0, 1});
  return sketch.line({-3, 0.5}, {12, 0.5}, Role::ray)
      .dot({11, 0.5}, Role::aid)
      .dot({7.5, 0.5})
      .dot({-2.5, 0.5}, Role::naive)
      .label({10.5, 0.8}, "x = 3e9")
      .label({6.8, 1.2}, "held: 7", Role::truth)
      .label({-3, 1.2}, "(int) x = -2147483648", Role::naive);
}

}  // namespace

HardCase build_round_trip() {
  return {
      .id = "gcc12-slp-roundtrip",
      .group = "build",
      .inputs =
          "(double) (float) x of six components next to each other; 0.1, 0.2, 0.3 and 0.7, 0.6, 0.5, and random ones",
      .expected = "six numbers of 24 bits",
      .why =
          "GCC 12.2's vectorizer for straight-line code takes a conversion down and up again for nothing, where float "
          "and "
          "double mix, and drops it. Rays are then others than those that float traces, and an oracle that is asked "
          "about them is wrong. The build tries this when configuring, and switches the vectorizer off.",
      .oracle = Oracle::closed_form,
      .reference = "g++ 12.2.0-14 of Debian 12; lib/cmake/slp_canary.cpp",
      .run = run_round_trip,
      .draw = draw_round_trip};
}

HardCase build_fast_math() {
  return {
      .id = "fast-math-ftz",
      .group = "build",
      .inputs = "1e-40f times 1, sums and halves of denormal floats; 48 rays along axes in the planes of a box's faces",
      .expected = "every denormal result to its last bit; every ray in the plane of a face hits",
      .why =
          "-Ofast sets the processor to flush what is below 1.2e-38 to 0, for the whole program, and lets the compiler "
          "take "
          "for granted that no NaN exists. Error bounds that count on gradual underflow are void, and slabs that "
          "were written so that NaN loses let it win.",
      .oracle = Oracle::rationals,
      .reference = "CDT, issue 172",
      .run = run_fast_math,
      .draw = draw_fast_math};
}

HardCase build_float_to_int() {
  return {.id = "float-int-cast",
          .group = "build",
          .inputs = "NaN, 3e9, infinities, -0.5 and random bits as floats, to cells of grids and keys of noise",
          .expected = "cells held within the grid, NaN in the first; keys modulo 2^32 of numbers of any size",
          .why =
              "What does not fit into an int is undefined: the compiler may answer 2147483647 where it knows the "
              "number, the "
              "processor -2147483648, and another one 0. So the cell on the far side becomes the first one, or an "
              "index out of all bounds, and differs between builds.",
          .oracle = Oracle::closed_form,
          .reference = "C++ standard, [conv.fpint]; UBSan, float-cast-overflow",
          .run = run_float_to_int,
          .draw = draw_float_to_int};
}

}  // namespace sightline::hard
