#include "sightline/texture/tangent_frame.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>

#include "sightline/math/random.h"

namespace sightline {
namespace {

using boost::multiprecision::cpp_rational;
constexpr double tiny = 0x1p-50;

Vec3d random_direction(Random& random) {
  for (;;) {
    Vec3d v;
    for (int axis = 0; axis < 3; ++axis) v[axis] = 2 * random.uniform_double() - 1;
    if (normalize_safely(v)) return v;
  }
}

void expect_orthonormal(const TangentFrame& frame) {
  const std::array axes{frame.tangent, frame.bitangent, frame.normal};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(glm::dot(axes[std::size_t(i)], axes[std::size_t(k)]), i == k ? 1 : 0, tiny) << i << ' ' << k;
    }
  }
}

TEST(NormalizeSafely, KnowsEveryDirection) {
  for (const double scale : {1.0, 1e-320, 0x1p-1074, 1e-200, 1e200, 1e308}) {
    Vec3d v(scale, -scale, scale);
    EXPECT_TRUE(normalize_safely(v));
    EXPECT_NEAR(glm::length(v - Vec3d(1, -1, 1) / std::sqrt(3.0)), 0, tiny) << scale;
  }
  for (const double none : {0.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    Vec3d v(none, 0, 0);
    EXPECT_FALSE(normalize_safely(v));
  }
}

/// frame-pole: no normal is special, and frames around their neighbours are orthonormal as well.
TEST(HardCases, FramePole) {
  for (const double z : {-1.0, 1.0}) {
    expect_orthonormal(frame_around({0, 0, z}));
    expect_orthonormal(frame_around({0.0, -0.0, z}));
    for (int exponent = -60; exponent < 0; ++exponent) {
      Vec3d n(std::ldexp(1, exponent), -std::ldexp(0.7, exponent), z);
      normalize_safely(n);
      expect_orthonormal(frame_around(n));
    }
  }
  for (const double zero : {0.0, -0.0}) expect_orthonormal(frame_around({0.6, 0.8, zero}));
  EXPECT_EQ(frame_around({0, 0, 1}).tangent, Vec3d(1, 0, 0));
  EXPECT_EQ(frame_around({0, 0, 1}).bitangent, Vec3d(0, 1, 0));
  Random random(1);
  for (int i = 0; i < 10'000; ++i) {
    const TangentFrame frame = frame_around(random_direction(random));
    expect_orthonormal(frame);
    EXPECT_FALSE(frame.is_mirrored());
  }
}

/// Directions along the normal have nothing at right angles to it but rounding, which is no direction.
TEST(TangentFrame, TakesNoDirectionFromRounding) {
  Random random(6);
  for (int i = 0; i < 20'000; ++i) {
    Vec3d n = random_direction(random);
    n.x = std::ldexp(n.x, -static_cast<int>(random.below(60))),
    n.y = std::ldexp(n.y, -static_cast<int>(random.below(60)));
    normalize_safely(n);
    const double length = 1 + random.uniform_double();
    expect_orthonormal(frame_along(n, length * n, n));
    expect_orthonormal(frame_along(n, Vec3d(0), -length * n));
  }
}

using Corners = std::array<Vec3d, 3>;
using Uvs = std::array<glm::dvec2, 3>;

TEST(TangentFrame, FollowsTheImage) {
  // In the plane z = 0 with (u, v) = (x, y) turned by an angle, the tangent is turned as far.
  const Corners corners{Vec3d(0, 0, 0), Vec3d(2, 0.5, 0), Vec3d(-0.3, 1, 0)};
  for (int i = 0; i < 64; ++i) {
    const double angle = i * 0.1, c = std::cos(angle), s = std::sin(angle);
    Uvs uv;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d& p = corners[k];
      uv[k] = {5 + 3 * (c * p.x + s * p.y), 3 * (-s * p.x + c * p.y)};
    }
    const TangentFrame frame = triangle_frame({0, 0, 1}, corners, uv);
    expect_orthonormal(frame);
    EXPECT_NEAR(glm::length(frame.tangent - Vec3d(c, s, 0)), 0, 1e-14);
    EXPECT_NEAR(glm::length(frame.bitangent - Vec3d(-s, c, 0)), 0, 1e-14);
    EXPECT_FALSE(frame.is_mirrored());
    const Vec3d v(0.3, -0.4, 0.5);
    EXPECT_NEAR(glm::length(frame.to_local(frame.to_world(v)) - v), 0, tiny);
  }
}

TEST(TangentFrame, IsAroundTheShadingNormal) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    Corners corners;
    Uvs uv;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = 10.0 * random_direction(random);
      uv[k] = {random.uniform_double(), random.uniform_double()};
    }
    const Vec3d n = random_direction(random);
    const TangentFrame frame = triangle_frame(n, corners, uv);
    expect_orthonormal(frame);
    EXPECT_EQ(frame.normal, n);
    // u grows along the tangent, v to the bitangent's side: dp = du Pu + dv Pv on both edges gives Pu and Pv.
    const glm::dmat2 map(uv[1] - uv[0], uv[2] - uv[0]);
    const glm::dmat2 back = glm::inverse(map);
    const Vec3d first = corners[1] - corners[0], second = corners[2] - corners[0];
    const Vec3d pu = first * back[0][0] + second * back[0][1], pv = first * back[1][0] + second * back[1][1];
    EXPECT_GT(glm::dot(frame.tangent, pu), 0);
    EXPECT_GT(glm::dot(frame.bitangent, pv), 0) << i;
  }
}

/// nm-degenerate-uv
TEST(HardCases, DegenerateUv) {
  Random random(3);
  const Corners corners{Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)};
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const std::array<Uvs, 7> degenerate{{
      {{{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}},
      {{{0, 0}, {1, 1}, {2, 2}}},
      {{{0, 0}, {1, 0}, {1, 0}}},
      {{{0.1, 0.1}, {0.1, 0.2}, {0.1, 0.9}}},
      {{{0, 0}, {0.1, 0.3}, {0.2, 0.6}}},
      {{{nan, 0}, {1, 0}, {0, 1}}},
      {{{0, 0}, {infinity, 0}, {0, 1}}},
  }};
  for (const Uvs& uv : degenerate) {
    const Vec3d n = random_direction(random);
    const TangentFrame frame = triangle_frame(n, corners, uv);
    expect_orthonormal(frame);
    EXPECT_EQ(frame.tangent, frame_around(n).tangent);
  }
  // Of a triangle without area, or seen along its tangent, a frame is left all the same.
  const Uvs uv{{{0, 0}, {1, 0}, {0, 1}}};
  expect_orthonormal(triangle_frame({0, 0, 1}, {Vec3d(1), Vec3d(1), Vec3d(1)}, uv));
  expect_orthonormal(triangle_frame({1, 0, 0}, corners, uv));
  expect_orthonormal(triangle_frame({0, 1, 0}, corners, uv));
}

TEST(TangentFrame, DecidesThinImagesExactly) {
  Random random(4);
  int thin = 0;
  for (int i = 0; i < 20'000; ++i) {
    // Points on a line, moved by the last place of one coordinate or not at all.
    Uvs uv;
    const glm::dvec2 from(random.uniform_double(), random.uniform_double());
    const glm::dvec2 along(random.uniform_double(), random.uniform_double());
    for (glm::dvec2& at : uv) at = from + (random.uniform_double() - 0.5) * along;
    const cpp_rational area =
        (cpp_rational(uv[1].x) - cpp_rational(uv[0].x)) * (cpp_rational(uv[2].y) - cpp_rational(uv[0].y)) -
        (cpp_rational(uv[1].y) - cpp_rational(uv[0].y)) * (cpp_rational(uv[2].x) - cpp_rational(uv[0].x));
    EXPECT_EQ(uv_orientation(uv), area.sign());
    const glm::dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    const double naive = a.x * b.y - a.y * b.x;
    thin += (naive > 0) - (naive < 0) != area.sign();
  }
  EXPECT_GT(thin, 100) << "rounding would decide otherwise";
}

/// nm-mirrored-uv: the bitangent flips, so that what is lit from above stays so.
TEST(HardCases, MirroredUv) {
  const Corners corners{Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)};
  const TangentFrame plain = triangle_frame({0, 0, 1}, corners, {{{0, 0}, {1, 0}, {0, 1}}});
  const TangentFrame left = triangle_frame({0, 0, 1}, corners, {{{1, 0}, {0, 0}, {1, 1}}});
  const TangentFrame down = triangle_frame({0, 0, 1}, corners, {{{0, 1}, {1, 1}, {0, 0}}});
  const TangentFrame turned = triangle_frame({0, 0, 1}, corners, {{{1, 1}, {0, 1}, {1, 0}}});
  EXPECT_EQ(plain.tangent, Vec3d(1, 0, 0));
  EXPECT_EQ(plain.bitangent, Vec3d(0, 1, 0));
  EXPECT_EQ(left.tangent, Vec3d(-1, 0, 0));
  EXPECT_EQ(left.bitangent, Vec3d(0, 1, 0)) << "v grows upward still";
  EXPECT_EQ(down.tangent, Vec3d(1, 0, 0));
  EXPECT_EQ(down.bitangent, Vec3d(0, -1, 0));
  EXPECT_EQ(turned.tangent, Vec3d(-1, 0, 0));
  EXPECT_EQ(turned.bitangent, Vec3d(0, -1, 0));
  EXPECT_FALSE(plain.is_mirrored());
  EXPECT_TRUE(left.is_mirrored());
  EXPECT_TRUE(down.is_mirrored());
  EXPECT_FALSE(turned.is_mirrored());
  EXPECT_EQ(left.to_world({0.6, 0, 0.8}), Vec3d(-0.6, 0, 0.8)) << "a dent's right side is on the left";
  // Seen from below, the same image is a mirrored one.
  const TangentFrame below = triangle_frame({0, 0, -1}, corners, {{{0, 0}, {1, 0}, {0, 1}}});
  EXPECT_EQ(below.tangent, Vec3d(1, 0, 0));
  EXPECT_EQ(below.bitangent, Vec3d(0, 1, 0));
  EXPECT_TRUE(below.is_mirrored());
}

/// nm-nonuniform: an ellipsoid's normals are known, those of the plane x + y = 0 as well.
TEST(HardCases, NonuniformScale) {
  const glm::dmat3 scale(Vec3d(100, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1));
  const double half = std::sqrt(0.5);
  const Vec3d moved = transform_normal(scale, {half, half, 0});
  // The tangent (1, -1, 0) becomes (100, -1, 0), and its normal is (1, 100, 0).
  EXPECT_NEAR(moved.x, 1 / std::sqrt(10'001.0), 0x1p-56);
  EXPECT_NEAR(moved.y, 100 / std::sqrt(10'001.0), 0x1p-51);
  EXPECT_LE(std::fabs(glm::dot(moved, Vec3d(100, -1, 0))), 0x1p-50);
  const Vec3d naive = glm::normalize(scale * Vec3d(half, half, 0));
  EXPECT_GT(std::acos(glm::dot(moved, naive)) * 57.3, 88) << "the case is hard";

  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const Vec3d n = random_direction(random);
    const Vec3d axes(std::ldexp(1, static_cast<int>(random.below(40)) - 20), 100, random.below(2) == 0 ? 1 : -1);
    const glm::dmat3 m(Vec3d(axes.x, 0, 0), Vec3d(0, axes.y, 0), Vec3d(0, 0, axes.z));
    Vec3d expected = n / axes;
    ASSERT_TRUE(normalize_safely(expected));
    EXPECT_NEAR(glm::length(transform_normal(m, n) - expected), 0, tiny);
    // Whatever the matrix, a normal stays at right angles to what was in the surface, on its outer side.
    glm::dmat3 any;
    for (int column = 0; column < 3; ++column) any[column] = random_direction(random);
    const TangentFrame frame = frame_around(n);
    const Vec3d out = transform_normal(any, n);
    EXPECT_NEAR(glm::dot(out, any * frame.tangent), 0, 1e-9);
    EXPECT_NEAR(glm::dot(out, any * frame.bitangent), 0, 1e-9);
    EXPECT_GT(glm::dot(out, any * n), 0) << "mirrored or not";
  }
  const glm::dmat3 small(1e-120);
  EXPECT_EQ(transform_normal(small, {0, 1, 0}), Vec3d(0, 1, 0));
  EXPECT_EQ(transform_normal(glm::dmat3(0), {0, 1, 0}), Vec3d(0, 1, 0));
  const glm::dmat3 flat(Vec3d(1, 0, 0), Vec3d(0, 0, 0), Vec3d(0, 0, 1));
  EXPECT_EQ(transform_normal(flat, {0.6, 0.8, 0}), Vec3d(0, 1, 0));
}

}  // namespace
}  // namespace sightline
