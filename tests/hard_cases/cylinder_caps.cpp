/// Cylinders along their axis, at their rims and in the planes of their caps.

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "tests/csg/random_solid.h"
#include "tests/hard_cases/cylinder_parts.h"
#include "tests/hard_cases/naive_sphere.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/hard_cases/solid_question.h"

namespace sightline::hard {
namespace {

/// Around z between -1 and 1, as a first lesson has it: the side by the formula from school, the caps by division, and
/// what is in both.
template <class T>
std::vector<double> naive_cylinder(T radius, const Ray<T>& ray) {
  const Vec3<T>&o = ray.origin, &d = ray.direction;
  const T a = d.x * d.x + d.y * d.y, b = 2 * (o.x * d.x + o.y * d.y), c = o.x * o.x + o.y * o.y - radius * radius;
  const T discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return {};
  const T root = std::sqrt(discriminant), side0 = (-b - root) / (2 * a), side1 = (-b + root) / (2 * a);
  const T low = (-1 - o.z) / d.z, high = (1 - o.z) / d.z;
  const T enter = std::max(side0, std::min(low, high)), leave = std::min(side1, std::max(low, high));
  if (enter >= leave) return {};
  return {double(enter), double(leave)};
}

/// The same by points: each root whose own point is on its face counts.
std::vector<double> naive_points(float radius, const Ray<float>& ray) {
  const Vec3f &o = ray.origin, &d = ray.direction;
  std::vector<double> found;
  const float a = d.x * d.x + d.y * d.y, b = 2 * (o.x * d.x + o.y * d.y), c = o.x * o.x + o.y * o.y - radius * radius;
  const float root = std::sqrt(b * b - 4 * a * c);
  for (const float t : {(-b - root) / (2 * a), (-b + root) / (2 * a)}) {
    if (std::fabs(o.z + t * d.z) <= 1) found.push_back(t);
  }
  for (const float cap : {-1.0f, 1.0f}) {
    const float t = (cap - o.z) / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
    if (x * x + y * y <= radius * radius) found.push_back(t);
  }
  std::ranges::sort(found);
  return found;
}

solid::Cylinder upright(const Vec3d& at = Vec3d(0), double radius = 1) {
  return {at - Vec3d(0, 0, 1), at + Vec3d(0, 0, 1), radius};
}

Sketch& draw_side_view(Sketch& sketch) {
  return sketch.rectangle({-1, -1}, {1, 1}).line({0, -1.6}, {0, 1.6}, Role::aid);
}

// ---- cyl-parallel

void run_parallel(Trial& trial) {
  const UnionByStructure all = among_others([](const Vec3d& at) { return SolidTree(upright(at)); }, 3);
  Random random(61);
  const auto count = trial.count(500);
  for (std::uint64_t i = 0; i < count; ++i) {
    // In steps of 1/64, inside, outside, and now and then on the side itself.
    const Vec3d at = random_lattice_vector(random, 80) / 64.0;
    const double speed = std::ldexp(1.0, static_cast<int>(random.below(40)) - 20);
    const Ray<double> ray{{i % 5 == 0 ? 0 : at.x, i % 5 == 0 ? 1 : at.y, -5}, {0, 0, speed}};
    const SolidQuestion question(upright(), ray);
    question.ask_spans(trial, "cylinder");
    question.judge_spans(trial.naive("the formula from school, in double"), naive_cylinder<double>(1, ray));
    SolidQuestion(all.tree(), ray).ask_spans(trial, all);
    // Any axis in whole numbers.
    Vec3d axis = random_lattice_vector(random, 9);
    if (axis == Vec3d(0)) axis.x = 1;
    const Vec3d base = random_lattice_vector(random, 9);
    SolidQuestion(solid::Cylinder{base, base + axis, 1 + 0.25 * random.below(20)},
                  {base + 0.25 * random_lattice_vector(random, 9), -speed * axis})
        .ask_spans(trial, "cylinder");
  }
}

Sketch draw_parallel() {
  Sketch sketch{"A cylinder from the side, and a ray along its axis: only the caps are met.", {}};
  return draw_side_view(sketch)
      .line({0.5, -5}, {0.5, 3}, Role::ray)
      .dot({0.5, -1})
      .dot({0.5, 1})
      .label({0.6, -1.3}, "4")
      .label({0.6, 1.2}, "6")
      .label({1.1, 0}, "side: a = b = 0, t = 0 / 0", Role::naive);
}

// ---- cyl-rim

void run_rim(Trial& trial) {
  Random random(62);
  const auto count = trial.count(1000);
  for (std::uint64_t i = 0; i < count; ++i) {
    // Points of the rim in whole numbers: 3, 4, 5.
    const double x = i % 2 ? 3 : -4, y = i % 2 ? -4 : 3;
    const Vec3d rim(x, y, i % 4 < 2 ? 1 : -1), way = random_lattice_vector(random, 1000);
    if (way.x == 0 && way.y == 0) continue;
    const Ray<double> ray{rim - way, way};
    const solid::Cylinder cylinder = upright(Vec3d(0), 5);
    const SolidQuestion question(cylinder, ray);
    question.ask_spans(trial, "cylinder");
    question.judge_spans(trial.naive("roots whose points are on their faces, in float"),
                         naive_points(5, ray_in_float(ray)));
    // A rim that no double is on: as near as they come.
    const double angle = 6.28 * random.uniform_double();
    const Vec3d eye = 3.0 * random_in_cube(random) + Vec3d(0, 0, 4),
                near = Vec3d(0.7 * std::cos(angle), 0.7 * std::sin(angle), 1);
    SolidQuestion(upright(Vec3d(0), 0.7), {eye, near - eye}).ask_spans(trial, "cylinder");
  }
}

Sketch draw_rim() {
  Sketch sketch{"A cylinder from the side, and a ray to its rim, where side and cap meet.", {}};
  return draw_side_view(sketch)
      .line({2.5, 2.5}, {-1.5, -1.5}, Role::ray)
      .dot({1, 1})
      .dot({-1, -1})
      .label({1.2, 0.8}, "side: just above 1? cap: just outside?", Role::naive)
      .label({-2.2, -1.5}, "or both, or none", Role::naive);
}

// ---- cyl-cap-plane

void run_cap_plane(Trial& trial) {
  const UnionByStructure all = among_others([](const Vec3d& at) { return SolidTree(upright(at)); }, 3);
  Random random(63);
  const auto count = trial.count(600);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double height = i % 2 ? 1 : -1;
    Vec3d from = random_lattice_vector(random, 40) / 8.0, way = random_lattice_vector(random, 20);
    from.z = height, way.z = 0;
    if (way == Vec3d(0)) way.x = 1;
    const Ray<double> ray{from, way};
    const SolidQuestion question(upright(), ray);
    question.ask_spans(trial, "cylinder");
    SolidQuestion(~SolidTree(upright()), ray).ask_spans(trial, "complement of the cylinder");
    question.judge_spans(trial.naive("the formula from school, in double"), naive_cylinder<double>(1, ray));
    SolidQuestion(all.tree(), ray).ask_spans(trial, all);
    // One ulp aside there is nothing, or the cylinder alone.
    for (const double aside : {std::nextafter(height, 0), std::nextafter(height, 2 * height)}) {
      SolidQuestion(upright(), {{from.x, from.y, aside}, way}).ask_spans(trial, "cylinder");
    }
  }
}

Sketch draw_cap_plane() {
  Sketch sketch{"A cylinder from the side, and a ray in the plane of its upper cap.", {}};
  return draw_side_view(sketch)
      .line({-3, 1}, {3, 1}, Role::ray)
      .dot({-1, 1})
      .dot({1, 1})
      .label({-0.9, 1.15}, "the cap belongs to the solid: in from 2 to 4")
      .label({-2.9, 0.6}, "cap: t = 0 / 0", Role::naive);
}

// ---- cyl-aabb

using Rational = boost::multiprecision::cpp_rational;

/// Whether a face of the box is at or beyond the cylinder's extent: end + r sqrt(1 - a_i^2 / |a|^2).
bool is_held(const solid::Cylinder& cylinder, int i, int side, const Rational& face) {
  Rational length2 = 0;
  for (int k = 0; k < 3; ++k) {
    const Rational a = Rational(cylinder.top[k]) - Rational(cylinder.base[k]);
    length2 += a * a;
  }
  const Rational along = Rational(cylinder.top[i]) - Rational(cylinder.base[i]), r(cylinder.radius);
  for (const Vec3d& end : {cylinder.base, cylinder.top}) {
    const Rational reach = side * (face - Rational(end[i]));
    if (reach < 0 || reach * reach * length2 < r * r * (length2 - along * along)) return false;
  }
  return true;
}

/// Holds it; and a box that is smaller by 4 floats on any side does not.
Verdict verdict_of(const solid::Cylinder& cylinder, const Aabb& box) {
  Verdict verdict = Verdict::exact;
  for (int i = 0; i < 3; ++i) {
    for (const int side : {-1, 1}) {
      float face = side < 0 ? box.lo[i] : box.hi[i];
      if (!std::isfinite(face) || !is_held(cylinder, i, side, Rational(face))) return Verdict::wrong;
      if (!is_held(cylinder, i, side, Rational(std::nextafter(face, -side * INFINITY)))) continue;
      verdict = Verdict::within_bound;
      // bounds_of rounds outward, and computes in double: 2^-20 of the largest number is room for all of it.
      const double size = std::fabs(double(face)) + cylinder.radius + max_norm(cylinder.base) + max_norm(cylinder.top);
      if (is_held(cylinder, i, side, Rational(face - side * size * 0x1p-20))) return Verdict::wrong;
    }
  }
  return verdict;
}

std::string box_text(const Aabb& box) { return vector_text(Vec3d(box.lo)) + " to " + vector_text(Vec3d(box.hi)); }

/// For an axis that is trusted to be of length 1.
Aabb naive_bounds(const solid::Cylinder& cylinder) {
  const Vec3f a(cylinder.top - cylinder.base), base(cylinder.base), top(cylinder.top);
  const auto r = static_cast<float>(cylinder.radius);
  const Vec3f extent(r * std::sqrt(1 - a.x * a.x), r * std::sqrt(1 - a.y * a.y), r * std::sqrt(1 - a.z * a.z));
  return {glm::min(base, top) - extent, glm::max(base, top) + extent};
}

void run_bounds(Trial& trial) {
  Random random(64);
  const auto count = trial.count(1000);
  for (std::uint64_t i = 0; i < count; ++i) {
    // As normalizing may leave it: a step of float longer than 1, along an axis or any way.
    Vec3d axis(0);
    axis[static_cast<int>(i % 3)] = i % 2 ? 1 + 0x1p-23 : -1 - 0x1p-23;
    if (i % 4 == 3) axis = Vec3d(glm::normalize(Vec3f(random_on_sphere(random))));
    const Vec3d base = i % 8 < 4 ? Vec3d(0) : Vec3d(random_lattice_vector(random, 100));
    const solid::Cylinder cylinder{base, base + axis, 1 + 0.5 * random.below(8)};
    const auto judge = [&](Tally& tally, const Aabb& box) {
      tally.add(verdict_of(cylinder, box), [&] {
        return Example{text_of(SolidTree(cylinder)), "a box around it, no larger than rounding makes it",
                       box_text(box)};
      });
    };
    judge(trial.of("bounds of the solid"), Solid(cylinder).bounds());
    judge(trial.naive("r sqrt(1 - a_i^2), in float"), naive_bounds(cylinder));
  }
}

Sketch draw_bounds() {
  Sketch sketch{"A cylinder along x, and its box. The axis is longer than 1 by one step of float.", {}};
  return sketch.rectangle({0, -1}, {1, 1})
      .rectangle({-0.04, -1.04}, {1.04, 1.04}, Role::truth)
      .line({0, 0}, {1, 0}, Role::aid)
      .label({1.1, 0}, "x: r sqrt(1 - (1 + ulp)^2) = NaN", Role::naive)
      .label({1.1, 0.9}, "the box", Role::truth);
}

}  // namespace

HardCase cylinder_parallel() {
  return {.id = "cyl-parallel",
          .group = "cylinder",
          .inputs = "radius 1, z from -1 to 1, o = (x, y, -5) in steps of 1/64, d = (0, 0, 2^k); and any whole axis",
          .expected = "caps at 4 and 6, divided by the length of d, where x^2 + y^2 <= 1; else none",
          .why =
              "Along the axis the distance from it does not change: a and b are 0, and the side's roots are 0 / 0. "
              "The NaN goes through min and max in a way that hangs on the order of their arguments. Whether the "
              "ray is in is the sign of c, alone.",
          .oracle = Oracle::rationals,
          .run = run_parallel,
          .draw = draw_parallel};
}

HardCase cylinder_rim() {
  return {
      .id = "cyl-rim",
      .group = "cylinder",
      .inputs = "whole rays through rim points like (3, 4, 1) of radius 5, and random ones at the rim of radius 0.7",
      .expected = "in and out, once each, as real arithmetic has it for the closed solid; nothing where it touches",
      .why =
          "Side and cap are each cut off where the other one begins, by a point that has been rounded. Both may "
          "claim the rim, or none, and then a ray enters without leaving. One number decides for both: which "
          "root is greater.",
      .oracle = Oracle::rationals,
      .run = run_rim,
      .draw = draw_rim};
}

HardCase cylinder_cap_plane() {
  return {
      .id = "cyl-cap-plane",
      .group = "cylinder",
      .inputs = "radius 1, z from -1 to 1; rays in the plane of a cap, in steps of 1/8, and one ulp above and below",
      .expected =
          "the solid is closed, so a ray in its cap is in it, between the roots of the side; its "
          "complement is open: out there",
      .why =
          "The ray never crosses the cap: t is 0 / 0, or infinite, and comparisons with it are false. Some codes "
          "miss, some hit twice. More than one answer makes sense, but all ways to ask must give the same.",
      .oracle = Oracle::rationals,
      .is_policy = true,
      .run = run_cap_plane,
      .draw = draw_cap_plane};
}

HardCase cylinder_bounds() {
  return {
      .id = "cyl-aabb",
      .group = "cylinder",
      .inputs = "unit axes that are longer than 1 by an ulp of float, along x, y, z, and random normalized ones",
      .expected = "a finite box that holds the cylinder: r sqrt(1 - a_i^2 / |a|^2) around its ends, rounded outward",
      .why =
          "1 - a_i^2 is below 0 by a rounding, its root is NaN, and a box of NaN is never hit: the cylinder has "
          "gone. What cannot be negative has to be computed in a way that cannot be negative, as by the squares "
          "of the other two.",
      .oracle = Oracle::rationals,
      .run = run_bounds,
      .draw = draw_bounds};
}

}  // namespace sightline::hard
