/// Long products of rotations.

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "sightline/scene/matrix_stack.h"
#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/families.h"

namespace sightline::hard {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;
using WideMatrix = std::array<std::array<Wide, 3>, 3>;

/// Rodrigues' formula in fifty digits.
WideMatrix rotation(const Vec3d& axis, const Wide& angle) {
  const Wide x(axis.x), y(axis.y), z(axis.z), length = sqrt(Wide(x * x + y * y + z * z));
  const std::array<Wide, 3> n{x / length, y / length, z / length};
  const Wide c = cos(angle), s = sin(angle);
  const WideMatrix turn{{{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}}};
  WideMatrix matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) matrix[i][k] = n[i] * n[k] * (1 - c) + (i == k ? c : Wide(0)) + s * turn[i][k];
  }
  return matrix;
}

/// The largest difference of an entry.
template <class Entry>
double distance(const WideMatrix& truth, Entry&& entry) {
  Wide worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) worst = std::max(worst, Wide(abs(truth[i][k] - Wide(entry(i, k)))));
  }
  return static_cast<double>(worst);
}

using FloatMatrix = std::array<std::array<float, 3>, 3>;

FloatMatrix product(const FloatMatrix& a, const FloatMatrix& b) {
  FloatMatrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) c[i][k] = a[i][0] * b[0][k] + a[i][1] * b[1][k] + a[i][2] * b[2][k];
  }
  return c;
}

void judge(Tally& tally, bool is_exact, bool is_within, double off) {
  const Verdict verdict = is_exact ? Verdict::exact : is_within ? Verdict::within_bound : Verdict::wrong;
  tally.add(verdict, off, [&] {
    return Example{"a product of rotations", "the rotation", "off by " + text_of_number(off)};
  });
}

void ask_chain(std::uint64_t length, Random& random, Trial& trial) {
  const Vec3d axis = any_direction(random);
  constexpr double degrees = 0.0625;
  MatrixStack stack;
  const Transform step = Transform::rotation(axis, degrees);
  for (std::uint64_t i = 0; i < length; ++i) stack.multiply(step);
  const Wide radians = Wide(degrees) * boost::math::constants::pi<Wide>() / 180;
  const WideMatrix truth = rotation(axis, radians * length);
  // A step's entries are off by at most four roundings, and a product of two adds three of sums below 2: of each entry
  // seven times 2^-53, over three columns.
  const double bound = static_cast<double>(length) * 21 * 0x1p-53;
  const auto off_of = [&](const Affine& matrix, bool is_transposed) {
    return distance(
        truth, [&](std::size_t i, std::size_t k) { return matrix.rows[is_transposed ? k : i][is_transposed ? i : k]; });
  };
  const double off = off_of(stack.current().matrix(), false), off_inverse = off_of(stack.current().inverse(), true);
  judge(trial.of("matrix stack"), off < 0x1p-54, off <= bound, off);
  judge(trial.of("its inverse"), off_inverse < 0x1p-54, off_inverse <= bound, off_inverse);
  const Transform before = stack.current();
  {
    const MatrixStack::Scope scope = stack.scope();
    for (std::uint64_t i = 0; i < length; ++i) stack.multiply(step);
  }
  judge(trial.of("push and pop"), stack.current() == before, false, 0);

  const WideMatrix exact_step = rotation(axis, radians);
  FloatMatrix narrow{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, turn{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) turn[i][k] = static_cast<float>(exact_step[i][k]);
  }
  for (std::uint64_t i = 0; i < length; ++i) narrow = product(narrow, turn);
  const double off_narrow = distance(truth, [&](std::size_t i, std::size_t k) { return narrow[i][k]; });
  judge(trial.naive("product in float, to 2^-10"), false, off_narrow <= 0x1p-10, off_narrow);
}

void ask_chains(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const auto length = static_cast<std::uint64_t>(std::llround(std::pow(10.0, difficulty)));
  // The work of all difficulties is to be alike.
  const std::uint64_t most = std::max<std::uint64_t>(1, std::min<std::uint64_t>(count, count * 1000 / length));
  for (std::uint64_t i = 0; i < most; ++i) ask_chain(length, random, trial);
}

}  // namespace

Family matrix_chains() {
  return {"chains",
          "Products of equal rotations, their inverse, and what push and pop keep: entries, by Rodrigues' formula.",
          "products of 10^k rotations by 1/16 of a degree",
          "k: 10^k products",
          0,
          6,
          Oracle::more_digits,
          ask_chains};
}

}  // namespace sightline::hard
