#include "sightline/math/slerp.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sightline/math/random.h"

namespace sightline {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;
using WideQuat = std::array<Wide, 4>;

Wide dot(const WideQuat& a, const WideQuat& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

WideQuat wide(const glm::dquat& q) {
  WideQuat made{q.w, q.x, q.y, q.z};
  const Wide length = sqrt(dot(made, made));
  for (Wide& x : made) x /= length;
  return made;
}

/// Shoemake's formula, in 50 digits.
WideQuat oracle(const glm::dquat& from, const glm::dquat& to, double share) {
  const WideQuat a = wide(from);
  WideQuat b = wide(to);
  Wide cosine = dot(a, b);
  if (cosine < 0) {
    for (Wide& x : b) x = -x;
    cosine = -cosine;
  }
  if (cosine >= 1) return a;
  const Wide angle = acos(cosine);
  WideQuat mixed;
  for (std::size_t i = 0; i < 4; ++i) {
    mixed[i] = (a[i] * sin((1 - Wide(share)) * angle) + b[i] * sin(Wide(share) * angle)) / sin(angle);
  }
  return mixed;
}

glm::dquat random_quat(Random& random) {
  const auto number = [&] { return 2 * random.uniform_double() - 1; };
  return {number(), number(), number(), number()};
}

bool is_same(const glm::dquat& a, const glm::dquat& b) { return a.w == b.w && a.x == b.x && a.y == b.y && a.z == b.z; }

/// Up to sign. Both ends are off by 6 roundings, the angle and the sines by as many.
void expect_near(const glm::dquat& made, const WideQuat& truth) {
  const WideQuat found{made.w, made.x, made.y, made.z};
  const int sign = dot(found, truth) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 4; ++i) ASSERT_LE(abs(found[i] - sign * truth[i]), Wide(0x1p-48));
}

TEST(Slerp, IsShoemakes) {
  Random random(1);
  for (int round = 0; round < 3000; ++round) {
    const glm::dquat a = random_quat(random);
    glm::dquat b = random_quat(random);
    if (round % 3 == 1) b = a + b * std::ldexp(1.0, -static_cast<int>(random.below(60)));   // almost the same
    if (round % 3 == 2) b = -a + b * std::ldexp(1.0, -static_cast<int>(random.below(60)));  // almost antipodal
    const double share = round % 10 == 0 ? 0 : round % 10 == 1 ? 1 : random.uniform_double();
    expect_near(slerp(a, b, share), oracle(a, b, share));
  }
}

/// slerp-antipodal: q and -q, of whatever length, are one rotation.
TEST(Slerp, SignsMakeNoDifference) {
  Random random(2);
  for (int round = 0; round < 1000; ++round) {
    const glm::dquat a = random_quat(random), b = round % 2 == 0 ? random_quat(random) : a;
    const double share = random.uniform_double();
    const glm::dquat made = slerp(a, b, share);
    for (const glm::dquat& other :
         {slerp(-a, b, share), slerp(a, -b, share), slerp(-a, -b, share), slerp(a * 4.0, b, share)}) {
      ASSERT_TRUE(is_same(made, other));
    }
  }
  const glm::dquat q(0.5, -0.5, 0.5, 0.5);
  EXPECT_TRUE(is_same(slerp(q, -q, 0.3), q));
  // Half a turn apart: two ways are equally short, and signs do not choose between them.
  const glm::dquat none(1, 0, 0, 0), half(0, 0, 0, 1);
  EXPECT_TRUE(is_same(slerp(none, half, 0.25), slerp(none, -half, 0.25)));
  EXPECT_TRUE(is_same(slerp(-none, half, 0.25), slerp(none, half, 0.25)));
}

TEST(Slerp, TakesAllLengthsButZero) {
  const glm::dquat tiny(0x1p-1070, 0, 0, 0), huge(0, 0x1p+1020, 0, 0x1p+1020);
  expect_near(slerp(tiny, huge, 0.5), oracle({1, 0, 0, 0}, {0, 1, 0, 1}, 0.5));
  EXPECT_THROW(slerp({0, 0, 0, 0}, huge, 0.5), std::invalid_argument);
  EXPECT_THROW(slerp(huge, {NAN, 0, 0, 1}, 0.5), std::invalid_argument);
  EXPECT_THROW(slerp(huge, {1, std::numeric_limits<double>::infinity(), 0, 1}, 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace sightline
