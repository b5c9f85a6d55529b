#include "sightline/noise/noise.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>
#include <utility>

#include "bench/accuracy/chance.h"
#include "bench/claims/course.h"
#include "bench/claims/rules.h"
#include "bench/claims/spectrum.h"
#include "bench/claims/tools.h"

namespace sightline::bench {
namespace {

using Conditions = std::vector<Condition>;

Noise noise_of(NoiseKind kind, std::uint64_t seed, Ease ease = Ease::cubic) {
  return Noise({.kind = kind, .seed = seed, .ease = ease});
}

std::string text_of(NoiseKind kind) { return std::string(noise_infos[static_cast<std::size_t>(kind)].name); }

// ---- Band-limited

/// Shares of the power along lines in random directions, in percent.
void measure_band(const Effort& effort, Finding& finding, Conditions& conditions) {
  for (const auto kind : {NoiseKind::perlin, NoiseKind::improved, NoiseKind::value, NoiseKind::white}) {
    const std::string name = text_of(kind);
    effort.say("the spectrum of " + name);
    const Noise noise = noise_of(kind, effort.seed);
    Chance chance(effort.seed);
    std::vector<double> above, below, within;
    for (std::size_t line = 0; line < effort.count(200, 50); ++line) {
      const Vec3d from = chance.point(100), along = chance.direction();
      const BandShares shares = band_shares([&](double x) { return noise(from + x * along); });
      above.push_back(100 * shares.above);
      below.push_back(100 * shares.below);
      within.push_back(100 * shares.octaves);
    }
    const Figure high{name + ": power above two cycles a cell", estimate(above), "%"};
    const Figure low{name + ": power below a quarter of a cycle a cell", estimate(below), "%"};
    finding.figures.insert(finding.figures.end(),
                           {high, low, {name + ": power between a half and two cycles a cell", estimate(within), "%"}});
    if (kind != NoiseKind::perlin && kind != NoiseKind::improved) continue;
    conditions.push_back({Condition::Kind::needed, high, Side::below, 1});
    conditions.push_back({Condition::Kind::wanted, low, Side::below, 1});
  }
}

// ---- Bounded

/// The greatest magnitude: of many points, and from the best of them upward by ever smaller steps.
double greatest(const Noise& noise, std::size_t points, Chance& chance) {
  std::vector<std::pair<double, Vec3d>> best(8, {0, Vec3d(0)});
  for (std::size_t i = 0; i < points; ++i) {
    const Vec3d p = chance.point(1000);
    const double size = std::fabs(noise(p));
    const auto least = std::ranges::min_element(best, {}, [](const auto& entry) { return entry.first; });
    if (size > least->first) *least = {size, p};
  }
  double most = 0;
  for (auto& [size, at] : best) {
    for (double step = 0.125; step > 0x1p-30; step /= 2) {
      for (int tries = 0; tries < 24; ++tries) {
        const Vec3d p = at + step * chance.direction();
        const double there = std::fabs(noise(p));
        if (there > size) size = there, at = p;
      }
    }
    most = std::max(most, size);
  }
  return most;
}

void measure_bounds(const Effort& effort, Finding& finding, Conditions& conditions) {
  const std::pair<NoiseKind, double> bounds[] = {{NoiseKind::perlin, std::sqrt(0.75)}, {NoiseKind::improved, 1.0364}};
  for (const auto& [kind, bound] : bounds) {
    effort.say("extremes of " + text_of(kind));
    Chance chance(effort.seed);
    const double most = greatest(noise_of(kind, effort.seed), effort.count(2'000'000, 200'000), chance);
    const Figure share =
        exact_figure(text_of(kind) + ": greatest magnitude found, of its bound", 100 * most / bound, "%");
    finding.figures.insert(finding.figures.end(),
                           {exact_figure(text_of(kind) + ": greatest magnitude found", most), share});
    conditions.push_back({Condition::Kind::needed, share, Side::below, 100});
  }
}

// ---- Continuous

struct Jumps {
  double value = 0, slope = 0, curvature = 0;
};

/// Across lattice planes at right angles to x, where the pieces of the polynomial meet.
Jumps jumps_of(const Noise& noise, std::size_t points, Chance& chance) {
  constexpr double near = 0x1p-16;
  Jumps jumps;
  for (std::size_t i = 0; i < points; ++i) {
    Vec3d p = chance.point(100);
    p.x = std::round(p.x);
    const Vec3d before(std::nextafter(p.x, -std::numeric_limits<double>::infinity()), p.y, p.z);
    const auto here = noise.sample(p), there = noise.sample(before);
    jumps.value = std::max(jumps.value, std::fabs(here.value - there.value));
    jumps.slope = std::max(jumps.slope, std::fabs(here.gradient.x - there.gradient.x));
    const double after = noise.sample(p + Vec3d(near, 0, 0)).gradient.x - here.gradient.x;
    const double until = there.gradient.x - noise.sample(p - Vec3d(near, 0, 0)).gradient.x;
    jumps.curvature = std::max(jumps.curvature, std::fabs(after - until) / near);
  }
  return jumps;
}

void measure_jumps(const Effort& effort, Finding& finding, Conditions& conditions) {
  struct Row {
    std::string name;
    Noise noise;
  };
  const Row rows[] = {{"perlin, cubic ease", noise_of(NoiseKind::perlin, effort.seed, Ease::cubic)},
                      {"perlin, quintic ease", noise_of(NoiseKind::perlin, effort.seed, Ease::quintic)},
                      {"improved", noise_of(NoiseKind::improved, effort.seed)}};
  for (const Row& row : rows) {
    effort.say("jumps of " + row.name);
    Chance chance(effort.seed);
    const Jumps jumps = jumps_of(row.noise, effort.count(200'000, 20'000), chance);
    const Figure value = exact_figure(row.name + ": greatest jump of the value", jumps.value);
    const Figure slope = exact_figure(row.name + ": greatest jump of the slope, a cell", jumps.slope);
    const Figure curvature =
        exact_figure(row.name + ": greatest jump of the curvature, a cell squared", jumps.curvature);
    finding.figures.insert(finding.figures.end(), {value, slope, curvature});
    conditions.push_back({Condition::Kind::needed, value, Side::below, 0x1p-40});
    conditions.push_back({Condition::Kind::needed, slope, Side::below, 0x1p-40});
    conditions.push_back({Condition::Kind::wanted, curvature, Side::below, 0.01});
  }
}

// ---- Repeatable

double differing(const std::vector<double>& a, const std::vector<double>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += std::memcmp(&a[i], &b[i], sizeof(double)) != 0;
  return static_cast<double>(count);
}

std::vector<double> values_of(const Noise& noise, const std::vector<Vec3d>& points) {
  std::vector<double> values;
  for (const Vec3d& p : points) values.push_back(noise(p));
  return values;
}

void measure_repeats(const Effort& effort, Finding& finding, Conditions& conditions) {
  Chance chance(effort.seed);
  std::vector<Vec3d> points, shifted;
  for (std::size_t i = 0; i < effort.count(200'000, 20'000); ++i) {
    // Far enough from lattice planes, and with few enough digits, that a shift by 256 is exact.
    points.push_back(Vec3d(Vec3f(chance.point(100))));
    shifted.push_back(points.back() + Vec3d(256, 0, 0));
  }
  const double share = 100 / static_cast<double>(points.size());
  for (const auto kind : {NoiseKind::perlin, NoiseKind::improved}) {
    const std::string name = text_of(kind);
    effort.say("repeating " + name);
    const Noise noise = noise_of(kind, effort.seed + 1), again = noise_of(kind, effort.seed + 1),
                other = noise_of(kind, effort.seed + 2);
    const std::vector<double> first = values_of(noise, points);
    std::vector<double> threaded, batch(points.size());
    {
      const std::jthread beside([&] { values_of(again, shifted); });
      const std::jthread backward([&] {
        threaded = values_of(again, {points.rbegin(), points.rend()});
        std::ranges::reverse(threaded);
      });
    }
    again.values(std::span<const glm::dvec3>(points), std::span(batch));
    const Figure anew =
        exact_figure(name + ": values that differ anew, backward, on one of two threads", differing(first, threaded));
    const Figure many = exact_figure(name + ": values that differ many at once", differing(first, batch));
    const Figure seeds = exact_figure(name + ": points at which another seed differs",
                                      share * differing(first, values_of(other, points)), "%");
    const Figure period = exact_figure(name + ": points at which 256 cells farther differs",
                                       share * differing(first, values_of(noise, shifted)), "%");
    finding.figures.insert(finding.figures.end(), {anew, many, seeds, period});
    conditions.push_back({Condition::Kind::needed, anew, Side::below, 1});
    conditions.push_back({Condition::Kind::needed, many, Side::below, 1});
    conditions.push_back({Condition::Kind::needed, seeds, Side::above, 99});
    conditions.push_back({Condition::Kind::wanted, period, Side::above, 99});
  }
}

Finding measure_noise(const Effort& effort) {
  Finding finding;
  Conditions conditions;
  measure_band(effort, finding, conditions);
  measure_bounds(effort, finding, conditions);
  measure_jumps(effort, finding, conditions);
  measure_repeats(effort, finding, conditions);
  conclude(
      finding, conditions,
      "Each is so, but none without its limit: a line through noise of space has low frequencies as well (Cook and "
      "DeRose, 2005), a cubic ease leaves edges in the curvature (Perlin, 2002), and a table of 256 repeats");
  return finding;
}

}  // namespace

const Claim noise_claim{
    "noise", "Perlin's noise is band-limited, bounded, continuous and repeatable.",
    "The power along random lines through noise of space, by frequency, with value and white noise beside it; the "
    "greatest magnitude that search and climbing find; what jumps where cells meet; and whether values are the same "
    "anew, backward, on one of two threads and many at once, and others with another seed or 256 cells farther.",
    "Holds if less than 1 % of the power lies above two cycles a cell, no magnitude reaches the bound, neither value "
    "nor slope jumps by 2^-40, no bit differs when asked again and another seed gives other values; holds with a limit "
    "if 1 % lies below a quarter of a cycle, the curvature jumps, or values return after 256 cells.",
    measure_noise};

}  // namespace sightline::bench
