/// Lab 02: what is asked of a student's wood.

#include <algorithm>
#include <cmath>

#include "labs/check/text.h"
#include "labs/labs.h"
#include "sightline/math/vec.h"
#include "sightline/noise/noise.h"

namespace sightline::labs {
namespace {

/// As the student's file has it.
struct Grain {
  double texture_frequency, noise_frequency, noise_amplitude;
};

// Everything is made of small quarters and halves: exact in every order, and no tolerance is needed.
Grain grain_of(const Case& at) {
  return {std::abs(at.head[3]) / 2.0, std::abs(at.head[4]) / 2.0, std::abs(at.head[5]) / 2.0};
}
Vec3d point_of(const Case& at) { return {at.head[0] / 2.0, at.head[1] / 2.0, at.head[2] / 2.0}; }
double noise_of(const Case& at) { return at.head[6] / 16.0; }

/// Modulo 1, in thirty-seconds: whole numbers.
double true_grain(const Case& at) {
  const int f = at.head[3], rings = f * f * (at.head[0] * at.head[0] + at.head[2] * at.head[2]);
  const int all = 2 * rings + std::abs(at.head[5]) * at.head[6];
  return (all % 32 + 32) % 32 / 32.0;
}

std::string describe(const Case& at) {
  const Grain g = grain_of(at);
  return "point " + text_of(point_of(at)) + ", texture frequency " + number(g.texture_frequency) +
         ", noise frequency " + number(g.noise_frequency) + ", amplitude " + number(g.noise_amplitude) + ", noise " +
         number(noise_of(at));
}

Check make_check(std::string name, std::string section, std::string why, std::vector<std::string> hints,
                 std::function<std::optional<Trouble>(const Case&, Subject&)> ask) {
  return {std::move(name), std::move(section),
          std::move(why),  std::move(hints),
          {7, 0, 0, 9},    300,
          false,           std::move(ask),
          describe,        {}};
}

std::optional<Trouble> compare(double got, double expected) {
  if (got == expected) return std::nullopt;
  return Trouble{number(expected), number(got)};
}
std::optional<Trouble> compare(const Vec3d& got, const Vec3d& expected) {
  if (got == expected) return std::nullopt;
  return Trouble{text_of(expected), text_of(got)};
}

ImagePanel board(Subject& subject) {
  constexpr int size = 256;
  const Grain wood{2, 1.5, 1};
  std::vector<Vec3d> points;
  for (int i = 0; i < size * size; ++i) points.emplace_back((i % size - 128) / 64.0, (i / size) / 96.0, 0.4);
  const Noise noise({.kind = NoiseKind::improved});
  std::vector<double> values;
  for (const Vec3d& p : subject.ask<std::vector<Vec3d>>("points", wood, points)) values.push_back(noise(p));
  const auto colors = subject.ask<std::vector<Vec3d>>("colors", wood, points, values, Vec3d(0.70, 0.42, 0.17),
                                                      Vec3d(0.26, 0.11, 0.035));
  if (colors.size() != points.size()) throw SubjectTrouble(SubjectTrouble::Kind::nonsense, "too few colors");
  ImagePanel image{size, size, {}};
  for (const Vec3d& color : colors) {
    for (int k = 0; k < 3; ++k) {
      image.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::sqrt(std::clamp(color[k], 0.0, 1.0)))));
    }
  }
  return image;
}

}  // namespace

Lab volumetric_texture_lab() {
  Lab lab{"02", "volumetric-texture", "Wood", {"wood.h"}, {}, {}, ""};
  lab.checks = {
      make_check("ring", "1. Rings around an axis", "Around another axis a plank shows circles where it has stripes.",
                 {"The distance to the y axis does not know y.", "Frequency times distance, all of it squared."},
                 [](const Case& at, Subject& subject) {
                   const int f = at.head[3];
                   const double expected = f * f * (at.head[0] * at.head[0] + at.head[2] * at.head[2]) / 16.0;
                   return compare(subject.ask<double>("ring", grain_of(at), point_of(at)), expected);
                 }),
      make_check("fraction", "2. Where a ring begins", "Negative fractions are colors darker than black.",
                 {"What is it of -0.25? The next whole number below is -1."},
                 [](const Case& at, Subject& subject) {
                   const int quarters = at.head[0] * 9 + at.head[1];
                   return compare(subject.ask<double>("fraction", quarters / 4.0), (quarters % 4 + 4) % 4 / 4.0);
                 }),
      make_check("noise-point", "3. Noise moves the rings", "Bumps of another size make marble of wood.",
                 {"The noise has a frequency of its own."},
                 [](const Case& at, Subject& subject) {
                   const double f = std::abs(at.head[4]);
                   return compare(subject.ask<Vec3d>("noise-point", grain_of(at), point_of(at)),
                                  Vec3d(at.head[0] * f, at.head[1] * f, at.head[2] * f) / 4.0);
                 }),
      make_check("grain", "3. Noise moves the rings", "Added after the fraction, noise dirties rings, and bends none.",
                 {"Ring number and noise first, the fraction last."},
                 [](const Case& at, Subject& subject) {
                   return compare(subject.ask<double>("grain", grain_of(at), point_of(at), noise_of(at)),
                                  true_grain(at));
                 }),
      make_check("color", "4. Colors", "The wrong way round, rings get darker toward the axis.",
                 {"At 0 early, at 1 late."}, [](const Case& at, Subject& subject) {
                   const Vec3d early(at.head[0], at.head[1], at.head[2]), late(at.head[3], at.head[4], at.head[5]);
                   const double s = std::abs(at.head[6]) % 5 / 4.0;
                   return compare(subject.ask<Vec3d>("color", early, late, s), (1 - s) * early + s * late);
                 })};
  lab.checks[1].describe = [](const Case& at) { return "x = " + number((at.head[0] * 9 + at.head[1]) / 4.0); };
  lab.checks[4].describe = [](const Case& at) {
    return "early " + text_of(Vec3d(at.head[0], at.head[1], at.head[2])) + ", late " +
           text_of(Vec3d(at.head[3], at.head[4], at.head[5])) + ", grain " + number(std::abs(at.head[6]) % 5 / 4.0);
  };
  lab.picture = [](Subject& subject) {
    return Drawing{"Wood", "A board cut beside the axis.", {{"", board(subject)}}};
  };
  return lab;
}

}  // namespace sightline::labs
