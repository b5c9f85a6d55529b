/// Noise far from the origin, where a coordinate's fraction has ever fewer bits.

#include <cmath>

#include "sightline/noise/noise.h"
#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/families.h"
#include "tests/noise/lattice_oracle.h"

namespace sightline::hard {
namespace {

/// Some dozen roundings of numbers below 1, each at most half a last place.
constexpr int roundings = 16;

template <class T>
void judge(Tally& tally, T got, const test::Wide& truth, const glm::dvec3& p) {
  const test::Wide off = abs(test::Wide(got) - truth);
  const bool is_exact = got == static_cast<T>(truth);
  const bool is_within = off <= roundings * test::Wide(std::numeric_limits<T>::epsilon() / 2);
  const Verdict verdict = is_exact ? Verdict::exact : is_within ? Verdict::within_bound : Verdict::wrong;
  tally.add(verdict, [&] {
    return Example{text_of_number(p.x) + " " + text_of_number(p.y) + " " + text_of_number(p.z),
                   text_of_number(static_cast<double>(truth)), text_of_number(static_cast<double>(got))};
  });
}

/// The same gradients, but fractions and sums in float from a point in float.
float float_noise(const Noise& noise, const glm::dvec3& where) {
  const glm::vec3 p(where), low = glm::floor(p), f = p - low;
  const glm::vec3 s = f * f * (3.0f - 2.0f * f);
  float corner[8];
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 offset(i & 1, i >> 1 & 1, i >> 2);
    corner[i] = glm::dot(glm::vec3(noise.sample(glm::dvec3(low + offset)).gradient), f - offset);
  }
  for (int axis = 0, step = 4; axis < 3; ++axis, step /= 2) {
    for (int i = 0; i < step; ++i) corner[i] = corner[2 * i] + s[axis] * (corner[2 * i + 1] - corner[2 * i]);
  }
  return corner[0];
}

void ask_noise(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const double far = std::ldexp(1.0, difficulty);
  for (const NoiseKind kind : {NoiseKind::perlin, NoiseKind::improved, NoiseKind::value}) {
    const Noise noise({.kind = kind, .seed = 1});
    const test::LatticeOracle<3> oracle(noise);
    const std::string name(noise_infos[static_cast<std::size_t>(kind)].name);
    for (std::uint64_t i = 0; i < (count + 2) / 3; ++i) {
      // Eight bits of a fraction, which double has as far as 2^44.
      const auto coordinate = [&] { return std::floor(far * any_point(random).x) + (1 + random.below(255)) / 256.0; };
      const double x = far + coordinate(), y = coordinate(), z = coordinate();
      const glm::dvec3 p(x, y, z);
      const auto truth_at = [&](const glm::dvec3& q) {
        return oracle(std::array<test::Wide, 3>{test::Wide(q.x), test::Wide(q.y), test::Wide(q.z)});
      };
      const test::Wide truth = truth_at(p);
      judge(trial.of(name + ", double"), noise(p), truth, p);
      const glm::vec3 narrow(p);
      judge(trial.of(name + ", float"), noise(narrow), truth_at(glm::dvec3(narrow)), glm::dvec3(narrow));
      if (kind != NoiseKind::perlin) continue;
      const float naive = float_noise(noise, p);
      trial.naive("of points in float, to 1/256").decide(abs(truth - naive) < test::Wide(1) / 256, [&] {
        return Example{text_of_number(x), text_of_number(static_cast<double>(truth)), text_of_number(naive)};
      });
    }
  }
}

}  // namespace

Family far_noise() {
  return {"far-noise",
          "Noise at points whose coordinates are whole numbers and an eighth bit's fraction: its value by definition.",
          "lattice coordinates of about 2^k",
          "k: lattice coordinate 2^k",
          0,
          43,
          Oracle::more_digits,
          ask_noise};
}

}  // namespace sightline::hard
