#pragma once
/// What real arithmetic gives, from the same numbers that the choices are given: sums and products of floats and
/// doubles of moderate size are exact in 1200 bits, and quotients and roots are off by less than 2^-1000 of themselves.
/// Signs of sums of products are therefore decided, not estimated; roots of quartics are counted by Sturm's theorem in
/// rational numbers.

#include <array>
#include <optional>
#include <vector>

#include "sightline/math/aabb.h"
#include "sightline/math/ray.h"
#include "sightline/shape/torus.h"
#include "sightline/shape/triangle.h"

namespace sightline::bench {

/// A real number as the sum of two doubles: known to 2^-106 of itself.
struct True {
  double high = 0, low = 0;

  double off(double x) const { return (x - high) - low; }
  explicit operator double() const { return high; }
  friend bool operator<(const True& a, const True& b) { return a.high < b.high || (a.high == b.high && a.low < b.low); }
};

struct TrueCrossing {
  True t, u, v;
};

/// Edges and corners belong to the triangle; one without area or seen edge-on is missed. The whole line counts.
std::optional<TrueCrossing> true_crossing(const Triangle& triangle, const Ray<double>& ray);

/// Whether the ray meets the closed box within [t_min, t_max].
bool truly_meets(const Aabb& box, const Ray<double>& ray);

/// Of a t^2 + 2 b t + c with a != 0, in ascending order; a double one once.
std::vector<True> true_quadratic_roots(double a, double b, double c);

/// Where the line meets a sphere, in ascending order; one where it touches.
std::vector<True> true_sphere_roots(const Vec3d& center, double radius, const Ray<double>& ray);

/// Where the line meets the torus of this minor radius around the origin, with axis z and major radius 1, each once.
std::vector<True> true_torus_roots(double minor, const Ray<double>& ray);

/// Where the origin comes to by `count` steps, each a turn by this quaternion of whole numbers and then a move.
std::array<True, 3> true_walk(const std::array<int, 4>& turn, const Vec3d& move, std::size_t count);

}  // namespace sightline::bench
