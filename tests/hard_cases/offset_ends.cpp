/// Rays that leave a surface and must not leave more than it; rays that end on one.

#include <array>

#include "sightline/render/lamps.h"
#include "tests/hard_cases/offset_parts.h"

namespace sightline::hard {
namespace {

// ---- off-leak

/// A floor, and a ceiling 1e-4 of the scale above it.
struct Gap {
  double scale;
  TriangleMesh mesh;
  Vec3d normal;

  Gap(Random& random, double its_scale) : scale(its_scale) {
    Vec3d u, v;
    do {
      u = point_in_cube(random), v = point_in_cube(random), normal = glm::cross(u, v);
    } while (glm::length(normal) < 0.1);
    normal = glm::normalize(normal);
    const Vec3d at = scale * point_in_cube(random), up = 1e-4 * scale * normal;
    std::vector<Vec3f> corners;
    for (const Vec3d& shift : {Vec3d(0), up}) {
      for (const Vec3d& p : {at, at + scale * u, at + scale * v}) corners.push_back(Vec3f(p + shift));
    }
    mesh = {std::move(corners), {{0, 1, 2}, {3, 4, 5}}};
  }
  /// From between both down to the floor.
  Ray<float> ray(Random& random) const {
    const Triangle floor = mesh[0];
    const Vec3d a(floor.a), middle = (a + Vec3d(floor.b) + Vec3d(floor.c)) / 3.0,
                            target = middle + 0.2 * random.uniform_double() * (a - middle);
    return ray_between(target + 0.5e-4 * scale * (normal + 0.3 * point_in_cube(random)), target);
  }
  bool is_within(const Vec3d& p) const {
    return ExactPlane(mesh[0]).side_of(p) > 0 && ExactPlane(mesh[1]).side_of(p) < 0;
  }
};

Example gap_example(const Gap& gap, const Ray<float>& ray, const std::string& got) {
  return {"scale " + text_of_number(gap.scale) + ", a gap of 1e-4 of it, " + text_of_ray(to_double(ray)),
          "begins within, meets the ceiling", got};
}

void run_leak(Trial& trial) {
  Random random(131);
  for (std::uint64_t i = 0; i < trial.count(400); ++i) {
    const double small = std::pow(10.0, least_scale + 3 * random.uniform_double());
    const Gap gap(random, i % 2 ? random_scale(random) : small);
    const OneShape shape{TriangleMesh(gap.mesh)};
    for (int k = 0; k < 6; ++k) {
      const Ray<float> narrow = gap.ray(random);
      const Ray<double> ray = to_double(narrow);
      const WorldHit hit = shape.hit(ray);
      if (hit.prim_id != 0 || !gap.is_within(ray.origin)) continue;  // the origin was rounded out of the gap
      const Vec3d origin = origin_of_next(shape.locate(ray, hit), ray);
      const WorldHit next = shape.hit({origin, gap.normal});
      trial.of("renderer, mesh").decide(gap.is_within(origin) && next.prim_id == 1, [&] {
        return gap_example(gap, narrow, gap.is_within(origin) ? "within, but misses the ceiling" : "begins outside");
      });
      if (gap.scale > 0.1) continue;
      const Vec3f p = narrow.at(float(hit.t)), n = float_normal(gap.mesh[0], narrow);
      const auto judge = [&](std::string_view name, const Vec3f& moved) {
        trial.naive(name).decide(gap.is_within(Vec3d(moved)),
                                 [&] { return gap_example(gap, narrow, "begins outside"); });
      };
      judge("p + 1e-4 n, scale <= 0.1", p + 1e-4f * n);
      judge("256 last places along n, scale <= 0.1", integer_offset(p, n));
    }
  }
}

Sketch draw_leak() {
  Sketch sketch{"A narrow gap between floor and ceiling, from the side.", {}};
  return sketch.line({-3, 0}, {3, 0}, Role::shape)
      .line({-3, 1}, {3, 1}, Role::shape)
      .line({-1.5, 0.6}, {0, 0}, Role::ray)
      .dot({0, 0.12})
      .line({0, 0.12}, {0.6, 1}, Role::truth)
      .dot({0, 1.6}, Role::naive)
      .line({0, 1.6}, {0.6, 3}, Role::naive)
      .label({0.2, 1.8}, "moved by 1e-4: in the open, light leaks in", Role::naive);
}

// ---- off-absorbed

void run_absorbed(Trial& trial) {
  Random random(132);
  for (int k = 11; k <= 23; ++k) {
    const float height = std::ldexp(1.f, k);
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Vec3f> corners(3, Vec3f(0));
      for (int i = 0; i < 3; ++i) corners[std::size_t(i)][axis] = height;
      corners[1][(axis + 1) % 3] = corners[2][(axis + 2) % 3] = 1;
      const TriangleMesh mesh(corners, {{0, 1, 2}});
      const OneShape shape{TriangleMesh(mesh)};
      Vec3d from(0);
      from[axis] = height + 4, from[(axis + 1) % 3] = from[(axis + 2) % 3] = 0.1 + 0.3 * random.uniform_double();
      Vec3d down(0);
      down[axis] = -1;
      const Ray<double> ray{from, down};
      const WorldHit hit = shape.hit(ray);
      const auto example = [&](double got) {
        return Example{"a plane at " + text_of_number(double(height)) + " across axis " + std::to_string(axis),
                       "above " + text_of_number(double(height)), text_of_number(got)};
      };
      const double origin = hit.is_hit() ? origin_of_next(shape.locate(ray, hit), ray)[axis] : 0;
      trial.of("renderer, mesh").decide(origin > double(height), [&] { return example(origin); });
      const float naive = height + 1e-4f;
      trial.naive("p + 1e-4 n in float").decide(naive > height, [&] { return example(double(naive)); });
    }
  }
}

Sketch draw_absorbed() {
  Sketch sketch{"Floats around 2048, and 2048 + 1e-4: not half of a step, drawn true to size.", {}};
  for (int i = -1; i <= 2; ++i) sketch.line({2.44 * i, -0.3}, {2.44 * i, 0.3}, Role::aid);
  return sketch.line({-3, 0}, {5.5, 0}, Role::shape)
      .dot({0, 0}, Role::naive)
      .dot({1, 0})
      .label({-0.4, -0.7}, "2048: the sum in float", Role::naive)
      .label({0.8, 0.4}, "2048.0001")
      .label({2.1, -0.7}, "2048.000244");
}

// ---- off-shadow-end

/// A room of a floor and a ceiling, across an axis; and an area lamp in the very plane of the ceiling.
void run_shadow_end(Trial& trial) {
  Random random(133);
  for (std::uint64_t i = 0; i < trial.count(400); ++i) {
    const double scale = random_scale(random);
    const int axis = static_cast<int>(i % 3);
    const auto floor = static_cast<float>(scale * (random.uniform_double() - 0.5)),
               ceiling = static_cast<float>(double(floor) + scale * (0.2 + random.uniform_double()));
    std::vector<Vec3f> corners;
    const auto size = static_cast<float>(8 * scale);
    for (const float height : {floor, ceiling}) {
      for (const auto& [x, y] : std::array<std::pair<float, float>, 3>{{{-size, -size}, {size, -size}, {0, size}}}) {
        Vec3f p(0);
        p[axis] = height, p[(axis + 1) % 3] = x, p[(axis + 2) % 3] = y;
        corners.push_back(p);
      }
    }
    const TriangleMesh mesh(corners, {{0, 1, 2}, {3, 4, 5}});
    const OneShape shape{TriangleMesh(mesh)};
    Lamp lamp;
    lamp.kind = Lamp::Kind::area;
    lamp.position = Vec3d(0), lamp.position[axis] = ceiling;
    lamp.axis = Vec3d(0), lamp.axis[axis] = -1;
    lamp.right[(axis + 1) % 3] = scale, lamp.up[(axis + 2) % 3] = scale;
    lamp.area = scale * scale;
    for (int k = 0; k < 6; ++k) {
      Vec3d from(0);
      from[axis] = 0.5 * (double(floor) + double(ceiling));
      from[(axis + 1) % 3] = scale * (2 * random.uniform_double() - 1),
                        from[(axis + 2) % 3] = scale * random.uniform_double();
      Vec3d down = 0.3 * point_in_cube(random);
      down[axis] = -1;
      const Ray<double> ray{from, down};
      const WorldHit hit = shape.hit(ray);
      const SurfacePoint at = shape.locate(ray, hit);
      const double x = random.uniform_double(), y = random.uniform_double();
      const LampLight light = light_of(lamp, at.point, {x, y}, at.error);
      const bool is_dark = shape.is_shadowed({origin_of_next(at, ray), light.to_lamp, 0, light.distance});
      const auto example = [&] {
        return Example{"scale " + text_of_number(scale) + ", floor at " + text_of_number(double(floor)) +
                           ", ceiling and lamp at " + text_of_number(double(ceiling)) + ", from " +
                           text_of_point(at.point),
                       "light", "shadow"};
      };
      trial.of("renderer, area lamp").decide(!is_dark, example);
      const Vec3f target(lamp.position + (x - 0.5) * lamp.right + (y - 0.5) * lamp.up), p(at.point);
      const Ray<float> naive{p, target - p};
      bool is_naive_dark = false;
      const TriangleRay prepared = mesh.prepare(to_double(naive));
      prepared.for_each_crossing(mesh[1], [&](const Crossing& crossing) { is_naive_dark = crossing.t <= 1; });
      trial.naive("to the lamp, t <= 1").decide(!is_naive_dark, example);
    }
  }
}

Sketch draw_shadow_end() {
  Sketch sketch{"A lamp in the plane of the ceiling, and a ray to it.", {}};
  return sketch.line({-3, 2}, {3, 2}, Role::shape)
      .line({-3, 0}, {3, 0}, Role::shape)
      .line({0.5, 2}, {1.5, 2}, Role::truth)
      .line({-1, 0.05}, {1, 2}, Role::ray)
      .dot({1, 1.95})
      .dot({1, 2}, Role::naive)
      .label({0.4, 1.5}, "ends before the plane, by what rounding may be off")
      .label({0.6, 2.3}, "ends at t = 1, on the ceiling, as it seems: shadow", Role::naive);
}

}  // namespace

HardCase offset_leak() {
  return {
      .id = "off-leak",
      .group = "offset",
      .inputs = "floors with a ceiling 1e-4 of the scale above, scales 1e-4 to 1e7; rays that leave the floor",
      .expected = "they begin between both, exactly, and meet the ceiling",
      .why =
          "An offset that is large enough for one scene is too large for another: it moves the ray through the next "
          "wall. Steps in the last places leak as well near the world's origin, where they have to be a fixed length.",
      .oracle = Oracle::rationals,
      .reference = "Waechter and Binder, Ray Tracing Gems ch. 6, 2019",
      .run = run_leak,
      .draw = draw_leak};
}
HardCase offset_absorbed() {
  return {
      .id = "off-absorbed",
      .group = "offset",
      .inputs = "planes at 2^k across each axis, k = 11 ... 23, hit from above",
      .expected = "the ray that leaves begins above the plane",
      .why = "2048 + 1e-4 is 2048 in float, as floats are 2.4e-4 apart there: the offset is added and does nothing.",
      .oracle = Oracle::closed_form,
      .run = run_absorbed,
      .draw = draw_absorbed};
}
HardCase offset_shadow_end() {
  return {.id = "off-shadow-end",
          .group = "offset",
          .inputs = "area lamps in the very plane of a ceiling, points of the floor, scales 1e-4 to 1e7",
          .expected = "light: the ceiling does not shadow the lamp that is on it",
          .why =
              "The ray ends where the ceiling is. Whether the ceiling's computed t is below the computed distance is a "
              "matter of the last place: lamps are dark in speckles. The end needs a margin as the beginning does.",
          .oracle = Oracle::closed_form,
          .reference = "pbrt, SpawnRayTo",
          .run = run_shadow_end,
          .draw = draw_shadow_end};
}

}  // namespace sightline::hard
