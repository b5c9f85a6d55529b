/// Where triangles meet: at edges, at corners, and where an edge meets a corner.

#include "tests/hard_cases/naive_triangles.h"
#include "tests/hard_cases/triangle_parts.h"

namespace sightline::hard {
namespace {

/// At points of edges, at `share` of each from its first corner; every other one from inside, around the center.
std::vector<Ray<float>> rays_at_edges(const TriangleMesh& mesh, std::uint64_t count, bool only_corners,
                                      std::uint64_t seed) {
  Random random(seed);
  const Vec3d center = 0.5 * (Vec3d(mesh.bounds().lo) + Vec3d(mesh.bounds().hi));
  const double size = 0.5 * max_norm(Vec3d(mesh.bounds().hi) - Vec3d(mesh.bounds().lo));
  std::vector<Ray<float>> rays;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto& corners = mesh.triangles()[random.below(mesh.size())];
    const std::uint32_t side = random.below(3);
    const Vec3d from(mesh.positions()[corners[side]]), to(mesh.positions()[corners[(side + 1) % 3]]);
    const Vec3d target = only_corners ? from : from + random.uniform_double() * (to - from);
    rays.push_back(ray_between(center + (i % 2 ? 0.25 : 4) * size * point_in_cube(random), target));
  }
  return rays;
}

void ask_at_edges(Trial& trial, const TriangleMesh& mesh, std::uint64_t count, bool only_corners) {
  const TracedMesh traced(mesh);
  const MeshQuestion question(traced.mesh(), rays_at_edges(mesh, trial.count(count), only_corners, 51));
  question.ask(trial, traced);
  question.ask(trial.naive("Moeller-Trumbore in float"), moller_trumbore);
  question.ask(trial.naive("Baldwin-Weber in float"), baldwin_weber);
}

void run_edge(Trial& trial) { ask_at_edges(trial, uv_sphere(12, 20, {0, 0, 0}, 1), 2000, false); }
void run_vertex(Trial& trial) { ask_at_edges(trial, uv_sphere(12, 20, {0, 0, 0}, 1), 2000, true); }

void run_embree_far(Trial& trial) {
  const TriangleMesh mesh = uv_sphere(12, 20, {148376, 1234, -223423}, 2);
  ask_at_edges(trial, mesh, 1000, false);
  ask_at_edges(trial, mesh, 1000, true);
}

/// 16 triangles around a tip, the rim rounded to float.
TriangleMesh fan(const Vec3d& tip) {
  std::vector<Vec3f> positions{Vec3f(tip)};
  std::vector<TriangleMesh::Corners> triangles;
  for (std::uint32_t i = 0; i < 16; ++i) {
    const double angle = 2 * std::numbers::pi * i / 16;
    positions.push_back(Vec3f(tip + Vec3d(std::cos(angle), std::sin(angle), -0.3 + 0.1 * std::sin(3 * angle))));
    triangles.push_back({0, 1 + i, 1 + (i + 1) % 16});
  }
  return {std::move(positions), std::move(triangles)};
}

void run_fan_pole(Trial& trial) {
  Random random(52);
  for (const Vec3d& tip : {Vec3d(0), Vec3d(0.3, -7.1, 2.9)}) {
    const TracedMesh traced(fan(tip));
    std::vector<Ray<float>> rays;
    for (std::uint64_t i = 0; i < trial.count(250); ++i) {
      const Vec3d away = point_in_cube(random);
      rays.push_back(ray_between(tip + Vec3d(away.x, away.y, 2 + away.z), Vec3d(Vec3f(tip))));
    }
    const MeshQuestion question(traced.mesh(), std::move(rays));
    question.ask(trial, traced);
    question.ask(trial.naive("Moeller-Trumbore in float"), moller_trumbore);
  }
}

/// Rows of a triangle below an edge, and two above it that end in a corner at `share` of the edge.
void run_t_junction(Trial& trial) {
  Random random(53);
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  std::vector<Ray<float>> rays;
  const std::uint64_t count = trial.count(160);
  for (std::uint64_t k = 0; k < count; ++k) {
    // Even ones on the lattice: the corner is on the edge. Odd ones anywhere: it is rounded off the edge.
    const bool is_on_edge = k % 2 == 0;
    const auto corner = [&](double x, double y) {
      const Vec3d p = point_in_cube(random);
      const Vec3d whole(std::floor(8 * p.x), std::floor(8 * p.y), std::floor(8 * p.z));
      return Vec3f(Vec3d(x, y, 0) + Vec3d(double(4 * k), 0, 0) + (is_on_edge ? whole / 16.0 : 0.5 * p));
    };
    const Vec3f left = corner(0, 0), right = corner(3, 0), below = corner(1.5, -2), above = corner(1.5, 2);
    const double share = is_on_edge ? 0.25 * (1 + random.below(3)) : random.uniform_double();
    const Vec3f middle(Vec3d(left) + share * (Vec3d(right) - Vec3d(left)));
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {left, right, below, above, middle});
    triangles.push_back({first, first + 2, first + 1});
    triangles.push_back({first, first + 4, first + 3});
    triangles.push_back({first + 4, first + 1, first + 3});
    for (int i = 0; i < 12; ++i) {
      const double along = i % 4 == 0 ? share : random.uniform_double();
      const Vec3d target = Vec3d(left) + along * (Vec3d(right) - Vec3d(left));
      rays.push_back(ray_between(target + Vec3d(0.3, 0.2, 4) + point_in_cube(random), target));
    }
  }
  const TracedMesh traced(TriangleMesh(std::move(positions), std::move(triangles)));
  const MeshQuestion question(traced.mesh(), std::move(rays));
  question.ask(trial, traced);
  question.ask(trial.naive("Moeller-Trumbore in float"), moller_trumbore);
}

// ---- Drawings

Sketch draw_neighbours(std::string caption, std::string_view where) {
  Sketch sketch{std::move(caption), {}};
  return sketch.polygon({{-2, 0}, {0.1, -1.5}, {-0.1, 1.5}})
      .polygon({{2, 0.2}, {0.1, -1.5}, {-0.1, 1.5}})
      .line({0.1, -1.5}, {-0.1, 1.5}, Role::shape)
      .dot({0, 0})
      .circle({0, 0}, 0.35, Role::naive)
      .label({0.45, -0.35}, "u = -3e-8 for the left one, v = -2e-8 for the right one: neither", Role::naive)
      .label({0.45, 0.5}, std::string(where));
}
Sketch draw_edge() {
  return draw_neighbours(
      "Two neighbours as the ray sees them; the circle is what rounding makes of the point, enlarged.",
      "the ray goes through the edge, or within an ulp of it");
}

Sketch draw_spokes(std::string caption, int sides) {
  Sketch sketch{std::move(caption), {}};
  std::vector<glm::dvec2> rim;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    rim.emplace_back(2 * std::cos(angle), 2 * std::sin(angle));
    sketch.line({0, 0}, rim.back(), Role::shape);
  }
  return sketch.polygon(rim).dot({0, 0}).circle({0, 0}, 0.25, Role::naive);
}
Sketch draw_vertex() {
  return draw_spokes("Six triangles around a corner, as the ray sees them. The circle is rounding, enlarged.", 6)
      .label({0.4, 0.9}, "each of the six may say: not mine", Role::naive);
}
Sketch draw_fan() {
  return draw_spokes("The tip of a fan of 16, seen along the ray; the circle is rounding, enlarged.", 16)
      .label({2.2, 0}, "true: all 16 are met in the tip")
      .label({2.2, -0.5}, "naive: a hole of a pixel in the pole", Role::naive);
}
Sketch draw_far() {
  Sketch sketch{"A sphere of radius 2, and floats along x where its center is 148376: 1/64 apart (drawn 1/4).", {}};
  for (int i = -10; i <= 10; ++i) sketch.line({i / 4.0, -2.3}, {i / 4.0, -2.1}, Role::aid);
  sketch.circle({0, 0}, 2).line({0.4, 0.3}, {2.5, 1.4}, Role::ray).dot({1.76, 1.01});
  return sketch.label({-2.4, -2.7}, "corners are here and nowhere between; a - o keeps few digits, its products fewer");
}
Sketch draw_t_junction() {
  Sketch sketch{"A corner that should be on the edge below it, rounded to the next float: the gap is drawn 10^6 fold.",
                {}};
  return sketch.polygon({{-2, 0}, {2, 0}, {0, -1.5}})
      .polygon({{-2, 0}, {0.3, 0.2}, {0, 1.6}})
      .polygon({{0.3, 0.2}, {2, 0}, {0, 1.6}})
      .dot({0.3, 0.2}, Role::aid)
      .dot({0.25, 0.08})
      .label({0.5, 0.5}, "T-corner")
      .label({-1.9, -0.6}, "a crack that the numbers have: a ray through it passes");
}

}  // namespace

HardCase triangle_edge() {
  return {.id = "tri-edge",
          .group = "triangle",
          .inputs = "2000 rays of float at edges of a closed sphere of 440 triangles, from outside and from inside",
          .expected = "each triangle that the ray crosses, none else; from inside a hit for every ray",
          .why =
              "Two neighbours compute their common edge by different operations. Where the ray passes within their "
              "rounding errors, both may find it on the other one's side: light leaks in by every edge. Edge functions "
              "that both take from the same two corners, with a sign that is exact, cannot contradict each other.",
          .oracle = Oracle::rationals,
          .reference = "Woop, Benthin, Wald 2013; embree's WatertightTest",
          .run = run_edge,
          .draw = draw_edge};
}
HardCase triangle_vertex() {
  return {
      .id = "tri-vertex",
      .group = "triangle",
      .inputs = "2000 rays of float at corners of a closed sphere of 440 triangles",
      .expected = "each triangle that the ray crosses, none else; from inside a hit for every ray",
      .why =
          "Around a corner six decisions are made on the verge of rounding, each for itself. With signs of the exact "
          "edge functions the triangles around a corner cover all directions.",
      .oracle = Oracle::rationals,
      .reference = "embree#188, embree#387",
      .run = run_vertex,
      .draw = draw_vertex};
}
HardCase triangle_embree_far() {
  return {.id = "tri-embree-far",
          .group = "triangle",
          .inputs = "a sphere of radius 2 around (148376, 1234, -223423), rays at its edges and corners",
          .expected = "each triangle that the ray crosses, none else",
          .why =
              "Floats are 1/64 apart there. Differences of coordinates are exact, but what is multiplied before it is "
              "subtracted has lost all digits that count.",
          .oracle = Oracle::rationals,
          .reference = "embree, verify.cpp",
          .run = run_embree_far,
          .draw = draw_far};
}
HardCase triangle_fan_pole() {
  return {.id = "tri-fan-pole",
          .group = "triangle",
          .inputs = "fans of 16 triangles, rim rounded to float, 500 rays of float at the tip",
          .expected = "at least one of the 16, and just those that real arithmetic says",
          .why =
              "The tip of a fan is where most edges meet, and the thinnest corners: 16 tests that must be of one mind. "
              "Where each rounds for itself, the pole of every sphere has a hole.",
          .oracle = Oracle::rationals,
          .run = run_fan_pole,
          .draw = draw_fan};
}
HardCase triangle_t_junction() {
  return {
      .id = "tri-t-junction",
      .group = "triangle",
      .inputs = "160 corners in the middle of another triangle's edge, half of them exactly on it; rays at the edge",
      .expected = "closed where the corner is on the edge; else the crack or overlap that the numbers describe",
      .why =
          "A corner computed to be on an edge is rounded off it. The crack is then part of the model, and no test may "
          "close it, or it would find hits beside triangles. Tests that round find cracks where there are none as "
          "well, and differ from direction to direction.",
      .oracle = Oracle::rationals,
      .is_policy = true,
      .run = run_t_junction,
      .draw = draw_t_junction};
}

}  // namespace sightline::hard
