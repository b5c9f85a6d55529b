/// Spheres hit and missed by a hair, and touched.

#include <array>
#include <cmath>

#include "sightline/csg/face_roots.h"
#include "sightline/math/random.h"
#include "tests/csg/evaluate.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/naive_sphere.h"
#include "tests/hard_cases/outward_float.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/hard_cases/solid_question.h"
#include "tests/hard_cases/sphere_parts.h"

namespace sightline::hard {
namespace {

/// In float, from 16 away, to pass the center of the unit sphere at `impact`: as nearly as floats can.
Ray<double> passing_ray(double impact, Random& random) {
  const Vec3d side = random_on_sphere(random), direction = glm::normalize(glm::cross(side, random_on_sphere(random)));
  return ray_of_floats(impact * side - 16.0 * direction, direction);
}

void judge_count(Tally& tally, const SolidQuestion& question, const Ray<double>& ray, bool is_hit) {
  const bool truth = !question.truth().ends.empty();
  tally.decide(is_hit == truth, [&] {
    return Example{"unit sphere, " + text_of(ray), truth ? "hit" : "miss", is_hit ? "hit" : "miss"};
  });
}

// ---- sph-graze

bool school_hits(const Ray<float>& ray) { return !naive_sphere_roots(Vec3f(0), 1.0f, ray).empty(); }

/// The discriminant alone done well, by Kahan's difference of products; its parts are rounded as before.
bool fused_discriminant_hits(const Ray<float>& ray) {
  const float a = glm::dot(ray.direction, ray.direction), b = glm::dot(ray.origin, ray.direction);
  const float c = glm::dot(ray.origin, ray.origin) - 1;
  const float product = a * c, rest = std::fma(a, c, -product);
  return std::fma(b, b, -product) - rest >= 0;
}

bool closest_point_hits(const Ray<float>& ray) {
  const float a = glm::dot(ray.direction, ray.direction), b = glm::dot(ray.origin, ray.direction);
  const Vec3f closest = ray.origin - (b / a) * ray.direction;
  return 1 - glm::dot(closest, closest) >= 0;
}

void run_graze(Trial& trial) {
  Random random(11);
  const auto count = trial.count(120);
  for (int k = 10; k <= 26; ++k) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const Ray<double> ray = passing_ray(1 + (i % 2 ? 1 : -1) * std::ldexp(1.0, -k), random);
      const SolidQuestion question(solid::Sphere{}, ray);
      question.ask_spans(trial, "sphere");
      const Ray<float> narrow = ray_in_float(ray);
      judge_count(trial.naive("the formula from school, in float"), question, ray, school_hits(narrow));
      judge_count(trial.naive("its discriminant by fma, in float"), question, ray, fused_discriminant_hits(narrow));
      judge_count(trial.naive("by the closest point, in float"), question, ray, closest_point_hits(narrow));
    }
  }
}

Sketch draw_graze() {
  Sketch sketch{"Two rays past the edge of a sphere, 2^-k inside and outside; here 1/8, in the case down to 2^-26.",
                {}};
  return sketch.circle({0, 0}, 1)
      .line({-3, 0.875}, {2, 0.875}, Role::ray)
      .line({-3, 1.125}, {2, 1.125}, Role::ray)
      .dot({-0.484, 0.875})
      .dot({0.484, 0.875})
      .label({-3, 0.6}, "1 - 2^-k: two roots")
      .label({-3, 1.3}, "1 + 2^-k: none")
      .label({-2.5, -1.3}, "in float a coin toss from k = 18 on", Role::naive);
}

// ---- sph-tangent, sph-zero-radius

template <Level level>
void ask_roots_at(Trial& trial, const solid::Sphere& sphere, const Ray<double>& ray, std::optional<double> touch) {
  const RootList list = face_roots<level>(sphere, LocalRay<level>(ray));
  Verdict verdict = Verdict::wrong;
  double error = 0;
  if (!touch && list.count == 0) verdict = Verdict::exact;
  if (touch && list.count == 1 && list.roots[0].multiplicity == 2) {
    const double off = std::fabs(list.roots[0].t - *touch), size = std::fabs(*touch);
    error = off == 0 ? 0 : off / size;
    // As lib/README.md has it; `fast` promises no double roots, but a float is near its number.
    const double share = level == Level::fast ? 0x1p-19 : level == Level::watertight ? 0x1p-46 : 0x1p-52;
    if (off <= share * size) verdict = off == 0 ? Verdict::exact : Verdict::within_bound;
  }
  trial.of("roots of the sphere", level).add(verdict, error, [&] {
    std::string got;
    for (int i = 0; i < list.count; ++i) {
      const Root& root = list.roots[static_cast<std::size_t>(i)];
      got += all_digits(root.t) + " x" + std::to_string(root.multiplicity) + " ";
    }
    return Example{text_of(SolidTree(sphere)) + ", " + text_of(ray), touch ? all_digits(*touch) + " x2" : "none", got};
  });
}

void ask_roots(Trial& trial, const solid::Sphere& sphere, const Ray<double>& ray, std::optional<double> touch) {
  ask_roots_at<Level::fast>(trial, sphere, ray, touch);
  ask_roots_at<Level::watertight>(trial, sphere, ray, touch);
  ask_roots_at<Level::precise>(trial, sphere, ray, touch);
  ask_roots_at<Level::exact>(trial, sphere, ray, touch);
}

void run_tangent(Trial& trial) {
  Random random(12);
  const auto count = trial.count(2000);
  const std::array points{Vec3d(0, 0, 1), Vec3d(1, 2, 2), Vec3d(3, 4, 0), Vec3d(2, 3, 6), Vec3d(1, 4, 8)};
  for (std::uint64_t i = 0; i < count; ++i) {
    // A point of the sphere in whole numbers, and a whole direction across the radius.
    const Vec3d point = points[i % points.size()], center = random_lattice_vector(random, 8);
    const Vec3d direction = glm::cross(point, random_lattice_vector(random, 3000));
    if (direction == Vec3d(0)) continue;
    const double t = 1 + random.below(7);
    const solid::Sphere sphere{center, glm::length(point)};
    const Ray<double> ray{center + point - t * direction, direction};
    SolidQuestion(sphere, ray).ask_spans(trial, "sphere");
    SolidQuestion(~SolidTree(sphere), ray).ask_spans(trial, "complement of the sphere");
    ask_roots(trial, sphere, ray, t);
    const std::vector<double> roots =
        naive_sphere_roots(Vec3f(center), static_cast<float>(sphere.radius), ray_in_float(ray));
    trial.naive("the formula from school, in float").decide(roots.size() == 2 && roots[0] == roots[1], [&] {
      return Example{text_of(ray), all_digits(t) + " twice", all_digits(roots)};
    });
  }
}

Sketch draw_tangent() {
  Sketch sketch{"A ray that touches a sphere in one point, in whole numbers.", {}};
  return sketch.circle({0, 0}, 5)
      .line({-1, 7}, {7, 1}, Role::ray)
      .line({0, 0}, {3, 4}, Role::aid)
      .dot({3, 4})
      .label({3.4, 4.3}, "one root, twice: touched, not entered")
      .label({-5, -6.5}, "in float two roots, or none, by luck", Role::naive);
}

void run_zero_radius(Trial& trial) {
  Random random(13);
  const auto count = trial.count(2000);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3d center = random_lattice_vector(random, 50);
    Vec3d direction = random_lattice_vector(random, 50);
    if (direction == Vec3d(0)) direction.z = 1;
    const double t = 1 + random.below(7);
    const bool is_touched = i % 2 == 0;
    const double aside = is_touched ? 0 : std::ldexp(1.0, -static_cast<int>(random.below(30)));
    Ray<double> ray{center - t * direction, direction};
    ray.origin[direction.x == 0 ? 0 : 1] += aside;
    const solid::Sphere point{center, 0};
    const Vec3d away = glm::cross(ray.origin - center, direction);  // few digits: exact
    const bool passes = away == Vec3d(0);
    SolidQuestion(point, ray).ask_spans(trial, "sphere");
    ask_roots(trial, point, ray, passes ? std::optional(t) : std::nullopt);

    const std::vector<double> roots = naive_sphere_roots(Vec3f(center), 0.0f, ray_in_float(ray));
    if (roots.empty()) continue;
    const Vec3f normal = (ray_in_float(ray).at(static_cast<float>(roots[0])) - Vec3f(center)) / 0.0f;
    trial.naive("normals by (p - c) / r").decide(is_finite(normal), [&] {
      return Example{text_of(ray), "a normal, or none", all_digits(double(normal.x))};
    });
  }
}

Sketch draw_zero_radius() {
  Sketch sketch{"A sphere of radius 0 is a point. A ray through it touches; one beside it does not.", {}};
  return sketch.dot({0, 0})
      .line({-4, -2}, {4, 2}, Role::ray)
      .line({-4, -1}, {4, 3}, Role::ray)
      .label({0.3, -0.4}, "touched, with no inside")
      .label({-3.5, 1.5}, "normal (p - c) / r = 0 / 0", Role::naive);
}

// ---- sph-interval-reject

/// With proven bounds, and a miss where the discriminant may be negative.
bool surely_hits(const Ray<float>& ray) {
  const auto one = [](float x) { return OutwardFloat{x, x}; };
  const OutwardFloat o[3] = {one(ray.origin.x), one(ray.origin.y), one(ray.origin.z)};
  const OutwardFloat d[3] = {one(ray.direction.x), one(ray.direction.y), one(ray.direction.z)};
  const auto dot = [](const OutwardFloat a[3], const OutwardFloat b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const OutwardFloat a = dot(d, d), nearest = dot(o, d) / a;
  const OutwardFloat v[3] = {o[0] - nearest * d[0], o[1] - nearest * d[1], o[2] - nearest * d[2]};
  const OutwardFloat length = root_of(dot(v, v));
  const OutwardFloat discriminant = one(4) * a * (one(1) + length) * (one(1) - length);
  return !(discriminant.lo < 0);
}

void run_interval_reject(Trial& trial) {
  Random random(14);
  const auto count = trial.count(1000);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Ray<double> ray = passing_ray(1 - 0x1p-18, random);
    const SolidQuestion question(solid::Sphere{}, ray);
    question.ask_spans(trial, "sphere");
    judge_count(trial.naive("a miss where an interval may be negative"), question, ray, surely_hits(ray_in_float(ray)));
  }
}

Sketch draw_interval_reject() {
  Sketch sketch{"A ray 2^-18 inside the edge of a sphere, drawn 1/16 inside: what intervals know of its distance.", {}};
  return sketch.circle({0, 0}, 1)
      .line({-3, 0.9375}, {2, 0.9375}, Role::ray)
      .line({0, 0}, {0, 0.9375}, Role::aid)
      .rectangle({-0.08, 0.8}, {0.08, 1.08}, Role::naive)
      .dot({-0.348, 0.9375})
      .dot({0.348, 0.9375})
      .label({0.3, 1.15}, "distance, as an interval: may miss, so it is a miss", Role::naive)
      .label({-3, 0.7}, "true: hit", Role::truth);
}

}  // namespace

HardCase sphere_graze() {
  return {.id = "sph-graze",
          .group = "sphere",
          .inputs = "radius 1, random rays of float from 16 away that pass the center at 1 -+ 2^-k, k = 10 ... 26",
          .expected = "hit or missed as the sign of the exact discriminant says",
          .why =
              "b b and 4 a c agree in all but their last digits, which are those that rounding has spoiled: their "
              "difference is noise. A fused multiply-add spares one rounding of it, and a, b and c are still wrong.",
          .oracle = Oracle::rationals,
          .reference = "Haines, Guenther and Akenine-Moeller, Ray Tracing Gems, chapter 7, 2019",
          .run = run_graze,
          .draw = draw_graze};
}

HardCase sphere_tangent() {
  return {.id = "sph-tangent",
          .group = "sphere",
          .inputs = "spheres through points like (3, 4, 0) + c, and whole directions at right angles to the radius",
          .expected = "one root of multiplicity 2; nothing is entered, and nothing is NaN",
          .why =
              "The discriminant is 0, and rounded it is 0, or a little more, or a little less: two roots, or none. "
              "Whether a solid is entered must not depend on which.",
          .oracle = Oracle::rationals,
          .run = run_tangent,
          .draw = draw_tangent};
}

HardCase sphere_interval_reject() {
  return {.id = "sph-interval-reject",
          .group = "sphere",
          .inputs = "radius 1, random rays of float from 16 away that pass the center at 1 - 2^-18",
          .expected = "hit",
          .why =
              "An interval tells what may be; code that takes `may be negative` for `is negative` gives up rays near "
              "the edge, all the way round each sphere. Where bounds do not settle a question, more digits have to.",
          .oracle = Oracle::rationals,
          .reference = "pbrt-v4, shapes.h",
          .run = run_interval_reject,
          .draw = draw_interval_reject};
}

HardCase sphere_zero_radius() {
  return {.id = "sph-zero-radius",
          .group = "sphere",
          .inputs = "radius 0, rays in whole numbers through the center and 2^-k beside it",
          .expected = "one root of multiplicity 2 where the line goes through the point, none elsewhere; never inside",
          .why =
              "A point has no normal: (p - c) / r is 0 / 0, and NaN spreads to the whole pixel. And each ray "
              "through it is a tangent, with a discriminant that rounding makes positive or negative.",
          .oracle = Oracle::rationals,
          .run = run_zero_radius,
          .draw = draw_zero_radius};
}

}  // namespace sightline::hard
