/// Rays that are in a triangle's plane, begin on it, or count what they cross.

#include "sightline/csg/solid_tree.h"
#include "sightline/shape/closed_mesh.h"
#include "tests/csg/evaluate.h"
#include "tests/hard_cases/naive_triangles.h"
#include "tests/hard_cases/triangle_parts.h"

namespace sightline::hard {
namespace {

Vec3d lattice_vector(Random& random, std::uint32_t size) {
  const auto one = [&] { return double(random.below(2 * size + 1)) - size; };
  const double x = one(), y = one();
  return {x, y, one()};
}

// ---- tri-coplanar

/// Slanted squares cut in two, each with rays in its plane, many of them along its edges.
void run_coplanar(Trial& trial) {
  Random random(71);
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  std::vector<Ray<float>> rays;
  while (rays.size() < trial.count(1500)) {
    const Vec3d along = lattice_vector(random, 3), across = lattice_vector(random, 3);
    if (glm::cross(along, across) == Vec3d(0)) continue;
    const Vec3d at = lattice_vector(random, 20);
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const Vec3d& p : {at, at + along, at + along + across, at + across}) positions.push_back(Vec3f(p));
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
    for (const double shift : {0.0, 0.25, 0.5}) {
      rays.push_back({Vec3f(at - 2.0 * along + shift * across), Vec3f(along)});
      rays.push_back({Vec3f(at + shift * along + 3.0 * across), Vec3f(-across)});
      rays.push_back({Vec3f(at + shift * along), Vec3f(along + across)});
    }
  }
  const TracedMesh traced(TriangleMesh(std::move(positions), std::move(triangles)));
  const MeshQuestion question(traced.mesh(), std::move(rays));
  question.ask(trial, traced);
  Tally& naive = trial.naive("Moeller-Trumbore without a look at det");
  const std::size_t per_square = 9;
  for (std::size_t i = 0; i < question.rays().size(); ++i) {
    const auto own = static_cast<std::uint32_t>(2 * (i / per_square));
    const auto t = moller_trumbore(question.rays()[i], traced.mesh()[own], -1);
    naive.decide(!t, [&] {
      return Example{text_of_ray(to_double(question.rays()[i])), "a miss of the triangle seen edge-on",
                     t ? "t = " + text_of_number(double(*t)) : "a miss"};
    });
  }
}

Sketch draw_coplanar() {
  Sketch sketch{"A triangle from its side: no more than a line, and the ray is in it.", {}};
  return sketch.line({-1, 0}, {2, 0}, Role::shape)
      .line({-3, 0}, {-1, 0}, Role::ray)
      .line({2, 0}, {4, 0}, Role::ray)
      .dot({-1, 0}, Role::aid)
      .dot({2, 0}, Role::aid)
      .label({-0.5, 0.4}, "ours: edge-on is a miss, for every structure")
      .label({-0.5, -0.5}, "u = 0 / 0, v = 0 / 0, t = 0 / 0, and NaN < 0 is false: hit at NaN", Role::naive);
}

// ---- tri-parity

constexpr std::uint32_t octahedron_faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

/// |x| + |y| + |z| <= 1, as a mesh to trace and as a solid.
TriangleMesh octahedron_mesh() {
  std::vector<TriangleMesh::Corners> triangles;
  for (const auto& face : octahedron_faces) triangles.push_back({face[0], face[1], face[2]});
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, std::move(triangles)};
}

/// Through the center, the surface is met where +-t times the sum of the direction's sizes is 1.
void judge_spans(Tally& tally, Level level, const Ray<double>& ray, const Spans& spans) {
  const double truth = 1 / (std::fabs(ray.direction.x) + std::fabs(ray.direction.y) + std::fabs(ray.direction.z));
  // lib/README.md: float, 2^-46 of itself, the last place, correctly rounded.
  const double share = level == Level::fast ? 0x1p-18 : level == Level::watertight ? 0x1p-46 : 0x1p-52;
  Verdict verdict = Verdict::wrong;
  double error = 0;
  if (!spans.begins_inside && spans.boundaries.size() == 2) {
    error = std::max(std::fabs(spans.boundaries[0].t + truth), std::fabs(spans.boundaries[1].t - truth)) / truth;
    if (error <= share && level != Level::exact) verdict = Verdict::within_bound;
    if (error == 0) verdict = Verdict::exact;
  }
  tally.add(verdict, error, [&] {
    return Example{text_of_ray(ray), "in and out at -+" + text_of_number(truth),
                   std::to_string(spans.boundaries.size()) + " boundaries"};
  });
}

void run_parity(Trial& trial) {
  Random random(72);
  std::vector<Ray<float>> rays;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.f, 1.f}) {
      Ray<float> to_corner{Vec3f(0), Vec3f(0)};
      to_corner.direction[axis] = sign;
      rays.push_back(to_corner);
      to_corner.direction[(axis + 1) % 3] = 1;
      rays.push_back(to_corner);
      to_corner.direction[(axis + 1) % 3] = -0.25f;
      rays.push_back(to_corner);
    }
  }
  for (std::uint64_t i = 0; i < trial.count(1000); ++i) {
    // Whole numbers up to 2^10, so that their sum is exact; half of them to an edge.
    Vec3d direction = lattice_vector(random, 1024);
    if (i % 2) direction[static_cast<int>(i / 2 % 3)] = 0;
    if (direction != Vec3d(0)) rays.push_back({Vec3f(0), Vec3f(direction)});
  }
  const TracedMesh traced(octahedron_mesh());
  const MeshQuestion question(traced.mesh(), rays);
  question.ask(trial, traced);

  std::vector<Vec3d> vertices(traced.mesh().positions().begin(), traced.mesh().positions().end());
  const auto closed = std::make_shared<const ClosedMesh>(std::move(vertices), traced.mesh().triangles());
  const Solid solid{SolidTree(closed)};
  Tally& naive = trial.naive("inside where a ray crosses an odd number of triangles");
  for (const Ray<float>& narrow : rays) {
    const Ray<double> ray = to_double(narrow);
    for (const Level level : all_levels) {
      judge_spans(trial.of("closed mesh as a solid", level), level, ray, spans_of(solid, ray, level));
    }
    int crossed = 0;
    for (std::uint32_t id = 0; id < traced.mesh().size(); ++id) {
      const auto t = woop(narrow, traced.mesh()[id]);
      crossed += t && *t > 0;
    }
    naive.decide(crossed % 2 == 1, [&] {
      return Example{text_of_ray(ray), "inside", std::to_string(crossed) + " triangles crossed: outside"};
    });
  }
}

Sketch draw_parity() {
  Sketch sketch{"An octahedron along an axis: from its center to a corner all four triangles around it are met.", {}};
  return sketch.polygon({{2, 0}, {0, 2}, {-2, 0}, {0, -2}})
      .line({0, 0}, {2.8, 0}, Role::ray)
      .dot({0, 0}, Role::aid)
      .dot({2, 0})
      .label({1.2, -0.4}, "leaves once")
      .label({1.2, 0.5}, "4 crossings are even: outside, it says", Role::naive);
}

// ---- tri-origin-on

/// Triangles of whole numbers up to 2^19, each with another behind it; rays begin at (2 a + b + c) / 4, which is a
/// float. So t = 0 is a crossing in truth, and excluded.
void run_origin_on(Trial& trial) {
  Random random(73);
  for (std::uint64_t round = 0; round < trial.count(8); ++round) {
    std::vector<Vec3f> positions;
    std::vector<TriangleMesh::Corners> triangles;
    std::vector<Ray<float>> rays;
    for (std::uint32_t i = 0; i < 40; ++i) {
      const Vec3d a = 4.0 * lattice_vector(random, 1 << 17), b = 4.0 * lattice_vector(random, 1 << 17),
                  c = 4.0 * lattice_vector(random, 1 << 17);
      for (const Vec3d& p : {a, b, c}) positions.push_back(Vec3f(p));
      triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
      const Vec3f origin((2.0 * a + b + c) / 4.0);
      for (int k = 0; k < 4; ++k) rays.push_back({origin, Vec3f(point_in_cube(random))});
      rays.push_back({Vec3f(a), Vec3f(point_in_cube(random))});
    }
    const TracedMesh traced(TriangleMesh(std::move(positions), std::move(triangles)));
    const MeshQuestion question(traced.mesh(), std::move(rays));
    question.ask(trial, traced);
    question.ask(trial.naive("Moeller-Trumbore in float, t > 0"), moller_trumbore);
  }
}

Sketch draw_origin_on() {
  Sketch sketch{"A ray that begins on a triangle, and another triangle behind.", {}};
  return sketch.line({-2, 0}, {2, 0.4}, Role::shape)
      .line({-1, 3}, {3, 2.4}, Role::shape)
      .line({0, 0.2}, {1.4, 2.65}, Role::ray)
      .dot({0, 0.2}, Role::naive)
      .dot({1.4, 2.65})
      .label({0.2, -0.3}, "t = 1e-9: itself again, a speckle of shadow", Role::naive)
      .label({1.6, 2.9}, "true");
}

}  // namespace

HardCase triangle_coplanar() {
  return {.id = "tri-coplanar",
          .group = "triangle",
          .inputs = "slanted squares with whole corners, 1500 rays in their planes, through them and along their edges",
          .expected = "a triangle seen edge-on is missed; what else the ray crosses is hit; never NaN",
          .why =
              "The ray is at right angles to the normal: u, v and t are 0 / 0. NaN passes tests that are written as "
              "refusals, and then stays the nearest hit, since nothing is nearer than NaN.",
          .oracle = Oracle::rationals,
          .is_policy = true,
          .run = run_coplanar,
          .draw = draw_coplanar};
}
HardCase triangle_parity() {
  return {
      .id = "tri-parity",
      .group = "triangle",
      .inputs = "an octahedron, rays from its center to corners, to edges, and anywhere",
      .expected = "a solid is left once; as loose triangles 4, 2 and 1 are crossed there",
      .why =
          "A watertight test gives a ray to all triangles that share the edge or corner, as it must. To count them "
          "and take the parity then says outside. What matters is how many are entered and how many left, as if the "
          "ray had been moved a little, the same for all of them.",
      .oracle = Oracle::closed_form,
      .reference = "Edelsbrunner, Muecke: Simulation of Simplicity, 1990; embree#188",
      .run = run_parity,
      .draw = draw_parity};
}
HardCase triangle_origin_on() {
  return {
      .id = "tri-origin-on",
      .group = "triangle",
      .inputs = "40 triangles of whole numbers to 2^19, rays that begin at (2a + b + c) / 4 and at a, 8 times",
      .expected = "the triangle at t = 0 is not hit, the next behind it is",
      .why =
          "The height of the origin over the plane is 0, a difference of products that do not fit their format: what "
          "is left is positive half of the time, and the surface shadows itself.",
      .oracle = Oracle::rationals,
      .run = run_origin_on,
      .draw = draw_origin_on};
}

}  // namespace sightline::hard
