/// On which side of a surface a ray begins that leaves it.

#include "sightline/query/workloads.h"
#include "tests/hard_cases/offset_parts.h"

namespace sightline::hard {
namespace {

/// A tetrahedron anywhere within the scale, so that no ray that leaves it meets it again.
TriangleMesh tetrahedron(Random& random, double scale) {
  const Vec3d at = scale * point_in_cube(random);
  std::vector<Vec3f> corners;
  for (int i = 0; i < 4; ++i) corners.push_back(Vec3f(at + 0.5 * scale * point_in_cube(random)));
  return {std::move(corners), {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
}

/// From outside at a point of a triangle that faces the origin.
Ray<float> ray_at(Random& random, const TriangleMesh& mesh, double scale) {
  const Triangle triangle = mesh[random.below(mesh.size())];
  const double u = random.uniform_double(), v = random.uniform_double() * (1 - u);
  const Vec3d a(triangle.a), target = a + u * (Vec3d(triangle.b) - a) + v * (Vec3d(triangle.c) - a);
  return ray_between(target + 8.0 * scale * glm::normalize(point_in_cube(random)), target);
}

Example side_example(const Ray<double>& ray, double scale, const std::string& got) {
  return {"scale " + text_of_number(scale) + ", " + text_of_ray(ray), "on the side that the ray came from", got};
}

/// The origin is surely on its side, and a ray to that side meets nothing.
void judge_mesh(Trial& trial, Random& random, const TriangleMesh& mesh, const OneShape& shape, const Ray<float>& narrow,
                double scale) {
  const Ray<double> ray = to_double(narrow);
  const WorldHit hit = shape.hit(ray);
  if (!hit.is_hit()) return;
  const ExactPlane plane(mesh[hit.prim_id]);
  const int side = -plane.side_towards(ray.direction);
  const Vec3d origin = origin_of_next(shape.locate(ray, hit), ray);
  trial.of("renderer, mesh").decide(plane.side_of(origin) == side, [&] {
    return side_example(ray, scale, "begins on side " + std::to_string(plane.side_of(origin) * side));
  });
  for (int k = 0; k < 3; ++k) {
    Vec3d direction = point_in_cube(random);
    if (plane.side_towards(direction) != side) direction = -direction;
    const WorldHit again = shape.hit({origin, direction});
    trial.of("renderer, mesh").decide(!again.is_hit(), [&] {
      return side_example(ray, scale,
                          "meets triangle " + std::to_string(again.prim_id) + " again at " + text_of_number(again.t));
    });
  }
}

void judge_bounce(Trial& trial, const TriangleMesh& mesh, const Tracer& tracer, const Ray<float>& ray, double scale,
                  std::uint64_t seed) {
  for (const Level level : triangle_levels) {
    Hit<float> hit, again;
    tracer.closest_hits(std::span(&ray, 1), std::span(&hit, 1), level);
    if (!hit.is_hit()) continue;
    const auto next = bounce_rays(mesh, std::span(&ray, 1), std::span(&hit, 1), seed);
    const ExactPlane plane(mesh[hit.prim_id]);
    const int side = -plane.side_towards(Vec3d(ray.direction));
    bool is_right = plane.side_of(Vec3d(next[0].origin)) == side;
    if (plane.side_towards(Vec3d(next[0].direction)) == side) {
      tracer.closest_hits(std::span<const Ray<float>>(next), std::span(&again, 1), level);
      is_right = is_right && again.prim_id != hit.prim_id;
    }
    trial.of("bounce rays of workloads", level).decide(is_right, [&] {
      return side_example(to_double(ray), scale, "begins on the other side, or meets the triangle again");
    });
  }
}

/// Spheres and boxes of doubles: outside in exact arithmetic, and nothing met by a ray that goes away.
void judge_solids(Trial& trial, Random& random, double scale) {
  using Rational = ExactPlane::Rational;
  const Vec3d center = scale * point_in_cube(random);
  const double radius = scale * (0.1 + random.uniform_double());
  const Ray<double> ray{center + 6.0 * scale * glm::normalize(point_in_cube(random)), Vec3d(0)};
  const Vec3d target = center + 0.57 * radius * point_in_cube(random);
  const Ray<double> aimed{ray.origin, target - ray.origin};
  const solid::Box box{center - radius, center + radius};
  for (const Level level : {Level::fast, Level::watertight, Level::precise, Level::exact}) {
    const auto judge = [&](std::string_view who, const SolidTree& tree, auto&& is_outside) {
      const OneShape shape(tree, level);
      const WorldHit hit = shape.hit(aimed);
      if (!hit.is_hit())
        return trial.of(who, level).decide(false, [&] { return side_example(aimed, scale, "a miss"); });
      const SurfacePoint at = shape.locate(aimed, hit);
      const Vec3d origin = origin_of_next(at, aimed);
      Vec3d direction = point_in_cube(random);
      if (glm::dot(direction, at.outside) < 0) direction = -direction;
      const WorldHit again = shape.hit({origin, direction});
      trial.of(who, level).decide(is_outside(origin) && !again.is_hit(), [&] {
        return side_example(aimed, scale,
                            is_outside(origin) ? "meets it again at " + text_of_number(again.t) : "within");
      });
    };
    judge("renderer, sphere", SolidTree(solid::Sphere{center, radius}), [&](const Vec3d& p) {
      const auto d = ExactPlane::minus(p, center);
      return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] > Rational(radius) * Rational(radius);
    });
    judge("renderer, box", SolidTree(box), [&](const Vec3d& p) {
      return !(glm::all(glm::lessThanEqual(box.lo, p)) && glm::all(glm::lessThanEqual(p, box.hi)));
    });
  }
}

/// All that is said of naive code: the origin it makes of a hit.
template <class Move>
void judge_naive(Tally& tally, const TriangleMesh& mesh, const Tracer& tracer, const Ray<float>& ray, double scale,
                 Move&& move) {
  Hit<float> hit;
  tracer.closest_hits(std::span(&ray, 1), std::span(&hit, 1));
  if (!hit.is_hit()) return;
  const ExactPlane plane(mesh[hit.prim_id]);
  const Vec3f origin = move(ray.at(hit.t), float_normal(mesh[hit.prim_id], ray));
  tally.decide(plane.side_of(Vec3d(origin)) == -plane.side_towards(Vec3d(ray.direction)),
               [&] { return side_example(to_double(ray), scale, "on it, or on the other side"); });
}

template <class Move>
void run_sides(Trial& trial, std::uint64_t seed, std::string_view name, double least_naive_scale, Move&& move) {
  Random random(seed);
  for (std::uint64_t i = 0; i < trial.count(120); ++i) {
    double scale = random_scale(random);
    if (i == 0) scale = std::max(scale, least_naive_scale);  // at least one
    const auto mesh = std::make_shared<const TriangleMesh>(tetrahedron(random, scale));
    const auto tracer = make_tracer("box-tree", mesh);
    const OneShape shape{TriangleMesh(*mesh)};
    for (int k = 0; k < 8; ++k) {
      const Ray<float> ray = ray_at(random, *mesh, scale);
      judge_mesh(trial, random, *mesh, shape, ray, scale);
      judge_bounce(trial, *mesh, *tracer, ray, scale, random.next());
      if (scale >= least_naive_scale) judge_naive(trial.naive(name), *mesh, *tracer, ray, scale, move);
    }
    judge_solids(trial, random, scale);
  }
}

void run_none(Trial& trial) {
  run_sides(trial, 121, "o + t d in float", 0, [](const Vec3f& p, const Vec3f&) { return p; });
}
void run_fixed(Trial& trial) {
  run_sides(trial, 122, "o + t d + 1e-4 n in float, scale >= 1e4", 1e4,
            [](const Vec3f& p, const Vec3f& n) { return p + 1e-4f * n; });
}

Sketch draw_side(std::string caption, std::string naive) {
  Sketch sketch{std::move(caption), {}};
  return sketch.line({-3, -0.5}, {3, 0.5}, Role::shape)
      .line({-2, 2.5}, {0, 0}, Role::ray)
      .circle({0, 0}, 0.6, Role::aid)
      .dot({0.1, -0.35}, Role::naive)
      .dot({-0.11, 0.62})
      .line({-0.11, 0.62}, {1.2, 2.6}, Role::truth)
      .label({0.8, -0.6}, std::move(naive), Role::naive)
      .label({0.3, 1}, "4 error off: surely above, and no farther");
}
Sketch draw_none() {
  return draw_side("A hit, and the ball in which rounding may have put it, enlarged.",
                   "o + t d: below, one time of two");
}
Sketch draw_fixed() {
  return draw_side("The same at scale 1e4, where floats are 1e-3 apart.", "+ 1e-4 n: rounded away again");
}

}  // namespace

HardCase offset_none() {
  return {.id = "off-none",
          .group = "offset",
          .inputs = "tetrahedra, spheres and boxes of sizes from 1e-4 to 1e7; rays that leave where others hit",
          .expected = "they begin on the side that the ray came from, exactly, and do not meet the surface again",
          .why =
              "o + t d is rounded, and with it the point falls below the surface as often as above. A ray from below "
              "hits the surface that it comes from: shadow acne.",
          .oracle = Oracle::rationals,
          .run = run_none,
          .draw = draw_none};
}
HardCase offset_fixed() {
  return {
      .id = "off-fixed",
      .group = "offset",
      .inputs = "the same; naive code moves origins by 1e-4 along the normal, at scales of 1e4 and more",
      .expected = "they begin on the side that the ray came from, exactly, and do not meet the surface again",
      .why =
          "A fixed length is right for one scale. Where floats are farther apart than it, the sum is rounded back, and "
          "it is as if nothing had been added.",
      .oracle = Oracle::rationals,
      .run = run_fixed,
      .draw = draw_fixed};
}

}  // namespace sightline::hard
