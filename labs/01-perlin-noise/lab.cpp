/// Lab 01: what is asked of a student's noise.

#include <algorithm>
#include <array>
#include <cmath>

#include "labs/check/text.h"
#include "labs/labs.h"
#include "sightline/math/vec.h"
#include "sightline/noise/noise.h"

namespace sightline::labs {
namespace {

/// A sum of eight corners rounds some forty times, with numbers of at most 2: 2^-46 is all that orders of operations
/// can differ by, several times over.
bool is_close(double got, double expected) { return std::fabs(got - expected) <= 0x1p-46; }

std::optional<Trouble> compare(double got, double expected) {
  if (is_close(got, expected)) return std::nullopt;
  return Trouble{number(expected), number(got)};
}

/// The library's, with Perlin's permutation.
double true_noise(const Vec3d& p) {
  static const Noise noise({.kind = NoiseKind::improved});
  return noise(p);
}

/// Sixteenths: differences to lattice points are exact.
Vec3d point_of(const Case& at) { return Vec3d(at.head[0], at.head[1], at.head[2]) / 16.0; }

/// Noise along x through a point, two cells to each side.
Drawing draw_line(const Vec3d& p, Subject& subject) {
  ChartPanel panel{"x", "noise", false, false, {{"expected", Role::right, {}}, {"got", Role::wrong, {}}}};
  for (int i = -64; i <= 64; ++i) {
    const Vec3d here(p.x + i / 32.0, p.y, p.z);
    panel.curves[0].points.push_back({here.x, true_noise(here)});
    const double got = subject.ask<double>("noise", here);
    if (std::isfinite(got)) panel.curves[1].points.push_back({here.x, got});
  }
  return {"Noise along x", "y = " + number(p.y) + ", z = " + number(p.z), {{"", std::move(panel)}}};
}

Check fade_check() {
  Check check{"fade",
              "1. From 0 to 1 without a corner",
              "Another curve shows the lattice: creases along cell borders as soon as noise moves a normal.",
              {"It goes through (0, 0), (1/2, 1/2) and (1, 1).", "6 t^5 - 15 t^4 + 10 t^3; mind the signs."},
              {1, 0, 0, 16},
              60,
              false,
              {},
              {},
              {}};
  check.describe = [](const Case& at) { return "t = " + std::to_string(std::abs(at.head[0])) + "/16"; };
  check.ask = [](const Case& at, Subject& subject) {
    const int k = std::abs(at.head[0]);
    const double expected = double(6 * k * k * k * k * k - 240 * k * k * k * k + 2560 * k * k * k) / 0x1p20;
    return compare(subject.ask<double>("fade", k / 16.0), expected);
  };
  check.draw = [](const Case&, Subject& subject) {
    ChartPanel panel{"t", "fade(t)", false, false, {{"expected", Role::right, {}}, {"got", Role::wrong, {}}}};
    for (int i = 0; i <= 64; ++i) {
      const double t = i / 64.0;
      panel.curves[0].points.push_back({t, 10 * t * t * t - 15 * t * t * t * t + 6 * t * t * t * t * t});
      panel.curves[1].points.push_back({t, subject.ask<double>("fade", t)});
    }
    return Drawing{"The fade", "", {{"", std::move(panel)}}};
  };
  return check;
}

Check hash_check() {
  Check check{"lattice-hash",
              "2. A random number for every lattice point",
              "Where neighbors have related numbers, noise has stripes; where -1 is no index, the program crashes.",
              {"Look up x, add y, look up, add z, look up: every sum is reduced to 0 ... 255 before it is an index.",
               "In C++ -1 % 256 is -1; -1 & 255 is 255."},
              {3, 0, 0, 600},
              200,
              false,
              {},
              {},
              {}};
  check.describe = [](const Case& at) {
    return "lattice point (" + std::to_string(at.head[0]) + " " + std::to_string(at.head[1]) + " " +
           std::to_string(at.head[2]) + ")";
  };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto table = subject.ask<std::array<std::uint8_t, 256>>("permutation");
    std::size_t expected = 0;
    for (const int coordinate : at.head) {
      expected = table[(expected + static_cast<std::size_t>(coordinate + 1024)) % 256];
    }
    const int got = subject.ask<int>("lattice-hash", at.head[0], at.head[1], at.head[2]);
    if (got == static_cast<int>(expected)) return std::nullopt;
    return Trouble{std::to_string(expected), std::to_string(got)};
  };
  return check;
}

Check gradient_check() {
  Check check{"gradient-dot",
              "3. Twelve gradients",
              "With a gradient missing or counted twice, noise leans to one side.",
              {"Only the four lowest bits count: hash & 15.",
               "Each row of the table has two signs and two axes; the third axis does not count at all."},
              {4, 0, 0, 255},
              400,
              false,
              {},
              {},
              {}};
  const auto way = [](const Case& at) { return Vec3d(at.head[1], at.head[2], at.head[3]); };
  check.describe = [way](const Case& at) {
    return "hash " + std::to_string(std::abs(at.head[0])) + ", way " + text_of(way(at));
  };
  check.ask = [way](const Case& at, Subject& subject) -> std::optional<Trouble> {
    static const std::array<Vec3d, 16> gradients{{{1, 1, 0},
                                                  {-1, 1, 0},
                                                  {1, -1, 0},
                                                  {-1, -1, 0},
                                                  {1, 0, 1},
                                                  {-1, 0, 1},
                                                  {1, 0, -1},
                                                  {-1, 0, -1},
                                                  {0, 1, 1},
                                                  {0, -1, 1},
                                                  {0, 1, -1},
                                                  {0, -1, -1},
                                                  {1, 1, 0},
                                                  {0, -1, 1},
                                                  {-1, 1, 0},
                                                  {0, -1, -1}}};
    const int hash = std::abs(at.head[0]);
    const double expected = glm::dot(gradients[static_cast<std::size_t>(hash % 16)], way(at));  // exact
    const double got = subject.ask<double>("gradient-dot", hash, way(at));
    if (got == expected) return std::nullopt;
    return Trouble{number(expected), number(got)};
  };
  return check;
}

Check noise_check(std::string name, std::string why, std::vector<std::string> hints, int scale) {
  Check check{
      std::move(name), "4. Eight corners", std::move(why), std::move(hints), {3, 0, 0, 80}, 300, false, {}, {}, {}};
  const auto point = [scale](const Case& at) { return point_of(at) * double(scale); };
  check.describe = [point](const Case& at) { return "noise at " + text_of(point(at)); };
  check.ask = [point](const Case& at, Subject& subject) {
    return compare(subject.ask<double>("noise", point(at)), true_noise(point(at)));
  };
  check.draw = [point](const Case& at, Subject& subject) { return draw_line(point(at), subject); };
  return check;
}

/// Along x, noise of a cell is (1 - s) A + s B with lines A and B and s = fade. At its ends s' = s'' = 0, so that the
/// curvature is 0, and |f'''| <= 60 |B - A| + 18 |B' - A'| <= 60 * 4 + 18 * 2. The second difference over h is at most
/// 2 h^3 / 6 of that: 92 h^3.
Check smooth_check() {
  Check check{"smooth",
              "4. Eight corners",
              "The eye sees a corner in the brightness, and light sees one in its slope: the lattice shows.",
              {"Are both cells that meet here given the same corners, and the ways from these corners?",
               "Interpolate by fade(t), not by t; the ways themselves are not faded."},
              {3, 0, 0, 80},
              200,
              false,
              {},
              {},
              {}};
  constexpr double h = 0x1p-10;
  const auto border = [](const Case& at) { return Vec3d(at.head[0], at.head[1] / 16.0, at.head[2] / 16.0); };
  check.describe = [border](const Case& at) { return "the border between two cells at " + text_of(border(at)); };
  check.ask = [border](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Vec3d p = border(at), step(h, 0, 0);
    const auto noise = [&](const Vec3d& q) { return subject.ask<double>("noise", q); };
    const double middle = noise(p), bend = noise(p + step) - 2 * middle + noise(p - step);
    if (std::fabs(bend) <= 92 * h * h * h) return std::nullopt;
    return Trouble{"slopes to the left and to the right that differ by at most " + number(92 * h * h),
                   "slopes that differ by " + number(std::fabs(bend) / h)};
  };
  check.draw = [border](const Case& at, Subject& subject) { return draw_line(border(at), subject); };
  return check;
}

Check sum_check(bool is_turbulent) {
  const std::string question = is_turbulent ? "turbulence" : "fractal-sum";
  Check check{question,
              is_turbulent ? "6. Turbulence" : "5. Octaves",
              is_turbulent ? "Creases make marble's veins and flames' edges; without |...| there are none."
                           : "With a wrong amplitude stone looks like fog, or like sand.",
              {is_turbulent ? "The absolute value of each octave, not of the sum."
                            : "Each octave has twice the frequency and half the amplitude of the one before.",
               "The first octave is noise(p) itself."},
              {4, 0, 0, 48},
              200,
              false,
              {},
              {},
              {}};
  const auto octaves = [](const Case& at) { return std::abs(at.head[3]) % 7; };
  check.describe = [octaves](const Case& at) {
    return std::to_string(octaves(at)) + " octaves at " + text_of(point_of(at));
  };
  check.ask = [=](const Case& at, Subject& subject) {
    double expected = 0;
    for (int k = octaves(at) - 1; k >= 0; --k) {
      const double value = true_noise(std::ldexp(1, k) * point_of(at));
      expected += std::ldexp(is_turbulent ? std::fabs(value) : value, -k);
    }
    return compare(subject.ask<double>(question, point_of(at), octaves(at)), expected);
  };
  return check;
}

Check budget_check() {
  Check check{"budget",
              "5. Octaves",
              "Noise is asked for at every point of every picture: twice the corners is twice the time.",
              {"A cell has eight corners. Is anything asked for twice?"},
              {4, 0, 0, 48},
              100,
              true,
              {},
              {},
              {}};
  const auto octaves = [](const Case& at) { return std::abs(at.head[3]) % 7; };
  check.describe = [octaves](const Case& at) {
    return "a sum of " + std::to_string(octaves(at)) + " octaves at " + text_of(point_of(at));
  };
  check.ask = [octaves](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto most = static_cast<std::uint64_t>(8 * octaves(at));
    const auto got = subject.ask<std::uint64_t>("hash-count", point_of(at), octaves(at));
    if (got <= most) return std::nullopt;
    return Trouble{"at most " + std::to_string(most) + " lattice points hashed", std::to_string(got)};
  };
  return check;
}

ImagePanel slice(Subject& subject, int octaves, bool is_turbulent) {
  constexpr int size = 256, pixels = 48;
  const auto values = subject.ask<std::vector<double>>("slice", octaves, is_turbulent, size, pixels);
  if (values.size() != std::size_t(size) * size) {
    throw SubjectTrouble(SubjectTrouble::Kind::nonsense, std::to_string(values.size()) + " pixels");
  }
  ImagePanel image{size, size, {}};
  for (const double value : values) {
    const double shown = std::clamp(is_turbulent ? value : (value + 1) / 2, 0.0, 1.0);
    image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(std::lround(255 * shown)));
  }
  return image;
}

}  // namespace

Lab perlin_noise_lab() {
  Lab lab{"01", "perlin-noise", "Perlin noise", {"noise.h"}, {}, {}, ""};
  lab.checks = {
      fade_check(),
      hash_check(),
      gradient_check(),
      noise_check("lattice-zero", "Noise is 0 at lattice points, which is why it has no lower frequencies.",
                  {"At a lattice point the way to that corner is (0 0 0), and the fades are 0."}, 16),
      noise_check("noise", "Left of 0, or in another order of corners, noise that is nearly right still has seams.",
                  {"Which cell is -0.5 in? Casting to int goes toward 0, floor() does not.",
                   "The way of a corner goes from the corner to the point: t - (i, j, k).",
                   "Interpolate along x between corners that differ in x alone, then along y, then along z."},
                  1),
      smooth_check(),
      sum_check(false),
      sum_check(true),
      budget_check()};
  lab.picture = [](Subject& subject) {
    return Drawing{"Perlin noise",
                   "One octave, a sum of six, turbulence of six: eight corners and a curve.",
                   {{"noise", slice(subject, 1, false)},
                    {"fractal sum", slice(subject, 6, false)},
                    {"turbulence", slice(subject, 6, true)}}};
  };
  return lab;
}

}  // namespace sightline::labs
