/// Triangles that are small, thin, or no more than a line.

#include "tests/hard_cases/naive_triangles.h"
#include "tests/hard_cases/triangle_parts.h"

namespace sightline::hard {
namespace {

/// Unconnected triangles, and a ray at a point of each.
struct Targets {
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  std::vector<Ray<float>> rays;

  void add(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
  }
  void ask(Trial& trial, std::string_view name, NaiveTest test) {
    const TracedMesh traced(TriangleMesh(std::move(positions), std::move(triangles)));
    const MeshQuestion question(traced.mesh(), std::move(rays));
    question.ask(trial, traced);
    question.ask(trial.naive(name), test);
  }
};

/// Triangles of that size beside one another in the plane z = 0, which rays down the z axis meet in their middle.
void add_row(Targets& targets, float size, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) {
    const float x = 4 * size * static_cast<float>(i);
    targets.add({x, 0, 0}, {x + size, 0, 0}, {x, size, 0});
    for (const float height : {1.f, size}) {
      targets.rays.push_back({{x + size / 4, size / 4, height}, {0, 0, -1}});
      targets.rays.push_back({{x + size / 4, size / 2, -height}, {size / 8, 0, height}});
    }
  }
}

void run_absolute_epsilon(Trial& trial) {
  Targets targets;
  add_row(targets, 1e-4f, trial.count(200));
  targets.ask(trial, "no hit where |det| <= 1e-6", cautious_moller_trumbore);
}

void run_underflow(Trial& trial) {
  for (const float size : {1e-12f, 1e-18f}) {
    Targets targets;
    add_row(targets, size, trial.count(50));
    targets.ask(trial, "no hit where |cross|^2 = 0 in float", area_checked);
  }
}

void run_pbrt_bad_case(Trial& trial) {
  Targets pbrt;
  pbrt.add({-1113.45459f, -79.049614f, -56.2431908f}, {-1113.45459f, -87.0922699f, -56.2431908f},
           {-1113.45459f, -79.2090149f, -56.2431908f});
  pbrt.rays.push_back({{-1081.47925f, 99.9999542f, 87.7701111f}, {-32.1072998f, -183.355865f, -144.607635f}});
  pbrt.ask(trial, "Woop in float", woop);
  // Three corners in a row along an axis, at coordinates of all sizes, and rays at the row.
  Random random(61);
  Targets many;
  for (std::uint64_t i = 0; i < trial.count(400); ++i) {
    Vec3f corners[3];
    corners[0] = Vec3f(1000.0 * point_in_cube(random));
    corners[1] = corners[2] = corners[0];
    const int axis = static_cast<int>(random.below(3));
    corners[1][axis] += random.uniform(-10, 10), corners[2][axis] += random.uniform(-10, 10);
    many.add(corners[0], corners[1], corners[2]);
    const Vec3d target = Vec3d(corners[0]) + random.uniform_double() * Vec3d(corners[1] - corners[0]);
    many.rays.push_back(ray_between(target + 200.0 * point_in_cube(random), target));
  }
  many.ask(trial, "Woop in float", woop);
}

void run_sliver(Trial& trial) {
  Random random(62);
  Targets targets;
  for (std::uint64_t i = 0; i < trial.count(700); ++i) {
    const double aspect = std::pow(10.0, 1 + double(i % 7));
    const Vec3d at(double(i) * 0.5, 0, 0), a = at + point_in_cube(random), b = at + point_in_cube(random);
    const Vec3f c(0.5 * (a + b) + point_in_cube(random) / aspect);
    targets.add(Vec3f(a), Vec3f(b), c);
    for (const double inside : {0.8, 1.1}) {
      // At points within, and just beside the long edge.
      const double along = 0.25 + 0.5 * random.uniform_double();
      const Vec3d on_edge = Vec3d(Vec3f(a)) + along * (Vec3d(Vec3f(b)) - Vec3d(Vec3f(a)));
      const Vec3d target = on_edge + (1 - inside) * (Vec3d(c) - on_edge);
      targets.rays.push_back(ray_between(target + 4.0 * point_in_cube(random), target));
    }
  }
  const TracedMesh traced(TriangleMesh(std::move(targets.positions), std::move(targets.triangles)));
  const MeshQuestion question(traced.mesh(), std::move(targets.rays));
  question.ask(trial, traced);
  question.ask(trial.naive("Moeller-Trumbore in float"), moller_trumbore);
  question.ask(trial.naive("Baldwin-Weber in float"), baldwin_weber);
  question.ask(trial.naive("Woop in float"), woop);
}

// ---- Drawings

Sketch draw_small(std::string caption, std::string size, std::string naive) {
  Sketch sketch{std::move(caption), {}};
  return sketch.polygon({{0, 0}, {2, 0}, {0, 2}})
      .line({-1.5, 2}, {0.5, 0.5}, Role::ray)
      .dot({0.5, 0.5})
      .label({0.6, -0.3}, std::move(size))
      .label({0.9, 1.4}, std::move(naive), Role::naive);
}
Sketch draw_absolute_epsilon() {
  return draw_small("A triangle of a detailed mesh, drawn 20,000 times its size.", "edges of 1e-4",
                    "det = 1e-8 < 1e-6: parallel, it says");
}
Sketch draw_underflow() {
  return draw_small("A triangle of a microscope's scene, drawn large.", "edges of 1e-12",
                    "|cross|^2 = 1e-48 is 0 in float: no area, it says");
}
Sketch draw_bad_case() {
  Sketch sketch{"Three corners on one line: there is no triangle. What passes the line nearby must not hit it.", {}};
  return sketch.line({0, -3}, {0, 3}, Role::shape)
      .dot({0, -3}, Role::aid)
      .dot({0, 2.5}, Role::aid)
      .dot({0, 3}, Role::aid)
      .line({2.5, 2}, {-2.5, -2}, Role::ray)
      .dot({0, 0}, Role::naive)
      .label({0.3, -0.4}, "u, v, w are rounding errors of one sign: hit at 0.99586", Role::naive);
}
Sketch draw_sliver() {
  Sketch sketch{"A triangle 20 times as long as wide; the case has them up to 10^7.", {}};
  return sketch.polygon({{-3, -0.5}, {3, 0.5}, {0.03, 0.3}})
      .dot({0.1, 0.15})
      .dot({0.2, -0.15}, Role::aid)
      .circle({0.1, 0.15}, 0.4, Role::naive)
      .label({0.6, -0.4}, "the circle is rounding: as wide as the triangle", Role::naive)
      .label({-2.5, 0.4}, "hit inside, miss below the long edge");
}

}  // namespace

HardCase triangle_absolute_epsilon() {
  return {.id = "tri-abs-eps",
          .group = "triangle",
          .inputs = "200 triangles with edges of 1e-4, rays at points inside",
          .expected = "a hit",
          .why =
              "`Parallel if |det| < 1e-6` compares an angle with twice the area times the direction's length. A small "
              "triangle seen face to face is then parallel to every ray: fine meshes vanish.",
          .oracle = Oracle::rationals,
          .reference = "tinybvh",
          .run = run_absolute_epsilon,
          .draw = draw_absolute_epsilon};
}
HardCase triangle_underflow() {
  return {.id = "tri-underflow",
          .group = "triangle",
          .inputs = "triangles with edges of 1e-12 and 1e-18 in float, rays at points inside",
          .expected = "a hit",
          .why =
              "The area is a product of two lengths, its square one of four: 1e-12 to the fourth power is below the "
              "smallest float and becomes 0. What was to refuse triangles without area refuses small ones.",
          .oracle = Oracle::rationals,
          .reference = "pbrt-v4, IntersectTriangle",
          .run = run_underflow,
          .draw = draw_underflow};
}
HardCase triangle_pbrt_bad_case() {
  return {.id = "tri-pbrt-badcase",
          .group = "triangle",
          .inputs = "corners (-1113.45459, y, -56.2431908) with y = -79.049614, -87.0922699, -79.2090149; 400 like it",
          .expected = "a miss: its area is 0",
          .why =
              "All three edge functions are 0 in truth, but what rounding leaves of them can have one sign. Their sum, "
              "also an error, then divides the height, and the quotient looks like a sound distance.",
          .oracle = Oracle::rationals,
          .reference = "pbrt, shapes_test: Triangle.BadCases",
          .run = run_pbrt_bad_case,
          .draw = draw_bad_case};
}
HardCase triangle_sliver() {
  return {
      .id = "tri-sliver",
      .group = "triangle",
      .inputs = "700 triangles 10^k times as long as wide, k = 1 ... 7; rays inside and beside their long edge",
      .expected = "the signs that real arithmetic has: hits within, misses beside",
      .why =
          "The width of a sliver is of the size of its edge functions' rounding errors, so their signs tell nothing. "
          "A test that first maps the triangle to a unit triangle divides by that width and is wrong even sooner.",
      .oracle = Oracle::rationals,
      .run = run_sliver,
      .draw = draw_sliver};
}

}  // namespace sightline::hard
