/// Grids: faces of cells, long walks, and the last cell.

#include <boost/multiprecision/cpp_int.hpp>

#include "tests/hard_cases/naive_grid.h"

namespace sightline::hard {
namespace {

using Rational = boost::multiprecision::cpp_rational;

// ---- grid-insert, grid-outside-cell

void run_insert(Trial& trial) {
  const TracedMesh traced(laws::lattice(300, 8, 91));
  const auto count = static_cast<int>(trial.count(2500));
  const MeshQuestion question(traced.mesh(), laws::lattice_rays<float>(8, count, 92));
  question.ask(trial, traced);
  ask_structure(trial.naive("grid: cells floor(lo) to ceil(hi) - 1"), question,
                NaiveGrid(traced.mesh(), GridFault::insert));
}

void run_outside_cell(Trial& trial) {
  const TracedMesh traced(laws::soup(150, 1, 93));
  const auto count = static_cast<int>(trial.count(2500));
  const MeshQuestion question(traced.mesh(), laws::rays_about<float>(traced.mesh().bounds(), count, 94));
  question.ask(trial, traced);
  ask_structure(trial.naive("grid: the first cell with a hit ends the walk"), question,
                NaiveGrid(traced.mesh(), GridFault::outside_cell));
}

// ---- grid-drift

/// The row of unit cells that a ray from (0, y) is in when it has come to x = steps.
int row_by_adding(float y, float slope, int steps) {
  int row = static_cast<int>(std::floor(y));
  float next_x = 1, next_y = (std::floor(y) + 1 - y) / slope;
  for (int column = 0; column < steps;) {
    if (next_x <= next_y) {
      ++column;
      next_x += 1;
    } else {
      ++row;
      next_y += 1 / slope;
    }
  }
  return row;
}
int true_row(float y, float slope, int steps) {
  const Rational at = Rational(y) + Rational(slope) * steps;
  return static_cast<int>(numerator(at) / denominator(at));  // at >= 0
}

/// A long row of triangles along a line, and rays from its end at any of them, past all the others.
void run_drift(Trial& trial) {
  Random random(95);
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  std::vector<Vec3d> centers;
  const auto count = static_cast<std::uint32_t>(trial.count(2000));
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = 32.0 * (i + 1);
    const Vec3d at(x, x / 3 + 40 * random.uniform_double(), x / 7 + 40 * random.uniform_double());
    centers.push_back(at);
    for (const Vec3d& shift : {Vec3d(0, 1, 0), Vec3d(0, -1, 1), Vec3d(0, -1, -1)})
      positions.push_back(Vec3f(at + shift));
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  std::vector<Ray<float>> rays;
  for (std::uint64_t i = 0; i < trial.count(250); ++i) {
    const Vec3d target = centers[random.below(count)] + Vec3d(0, random.uniform_double() - 0.5, 0);
    rays.push_back({Vec3f(0), Vec3f(target)});
    rays.push_back({Vec3f(target - Vec3d(0.5, 0, 0)), Vec3f(-target)});
  }
  const TracedMesh traced(TriangleMesh(std::move(positions), std::move(triangles)));
  MeshQuestion(traced.mesh(), std::move(rays)).ask(trial, traced);

  Tally& naive = trial.naive("next += delta in float, 100,000 columns");
  for (std::uint64_t i = 0; i < trial.count(40); ++i) {
    const float y = random.uniform(0, 1), slope = random.uniform(0.3f, 0.9f);
    const int found = row_by_adding(y, slope, 100'000), truth = true_row(y, slope, 100'000);
    naive.decide(found == truth, [&] {
      return Example{"from (0, " + text_of_number(double(y)) + ") along (1, " + text_of_number(double(slope)) + ")",
                     "row " + std::to_string(truth), "row " + std::to_string(found)};
    });
  }
}

// ---- grid-index-n

/// Walls at the far faces of a box whose bounds are no round numbers, and rays that begin a step before them.
void run_index_n(Trial& trial) {
  Random random(96);
  Tally& naive = trial.naive("int((x - lo) / (hi - lo) * n)");
  for (std::uint64_t round = 0; round < trial.count(40); ++round) {
    const float lo = random.uniform(-100, 100), hi = lo + random.uniform(0.1f, 300);
    std::vector<Vec3f> positions{{lo, lo, lo}, {hi, lo, lo}, {lo, hi, lo}, {hi, hi, lo},
                                 {lo, lo, hi}, {hi, lo, hi}, {lo, hi, hi}, {hi, hi, hi}};
    std::vector<TriangleMesh::Corners> triangles{{1, 3, 5}, {3, 7, 5}, {2, 6, 3}, {3, 6, 7}, {4, 5, 6}, {5, 7, 6}};
    for (std::uint32_t i = 0; i < 60; ++i) {  // so that there are cells
      for (int k = 0; k < 3; ++k) positions.push_back(laws::random_point(random, lo, hi));
      triangles.push_back({8 + 3 * i, 9 + 3 * i, 10 + 3 * i});
    }
    const float before = std::nextafter(hi, lo);
    std::vector<Ray<float>> rays;
    for (int i = 0; i < 24; ++i) {
      Vec3f origin = laws::random_point(random, lo, hi), direction = laws::random_point(random, -1, 1);
      origin[i % 3] = before;
      if (i % 2 == 0) direction = Vec3f(0);
      if (i % 2 == 0) direction[i % 3] = 1;
      rays.push_back({origin, direction});
    }
    const TracedMesh traced(TriangleMesh(std::move(positions), std::move(triangles)));
    MeshQuestion(traced.mesh(), std::move(rays)).ask(trial, traced);
    for (const int n : {10, 100, 640}) {
      const int index = static_cast<int>((before - lo) / (hi - lo) * static_cast<float>(n));
      naive.decide(index < n, [&] {
        return Example{"lo = " + text_of_number(double(lo)) + ", hi = " + text_of_number(double(hi)) +
                           ", x the float before hi, n = " + std::to_string(n),
                       std::to_string(n - 1), std::to_string(index)};
      });
    }
  }
}

// ---- grid-flat

void run_flat(Trial& trial) {
  laws::MeshMaker line;  // no wider than a line, so that nothing can be hit
  for (int i = 0; i < 30; ++i) line.add({float(i), 2, 3}, {float(i + 1), 2, 3}, {float(i) + 0.5f, 2, 3});
  std::vector<TriangleMesh> meshes;
  meshes.push_back(laws::flat(150, 97));
  meshes.push_back(line.make());
  laws::MeshMaker wall;  // in the plane x = 2
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 8; ++k)
      wall.add({2, float(i), float(k)}, {2, float(i + 1), float(k)}, {2, float(i), float(k + 1)});
  }
  meshes.push_back(wall.make());
  const auto count = static_cast<int>(trial.count(500));
  for (const TriangleMesh& mesh : meshes) {
    const TracedMesh traced(mesh);
    std::vector<Ray<float>> rays = laws::lattice_rays<float>(8, count, 98);
    Random random(99);
    for (int i = 0; i < count; ++i) {
      const Vec3f from = laws::random_point(random, -1, 9);
      rays.push_back({from, laws::random_point(random, -1, 9) - from});
    }
    MeshQuestion(traced.mesh(), std::move(rays)).ask(trial, traced);
    Tally& naive = trial.naive("(x - lo) / (hi - lo) * n");
    const Vec3f extent = mesh.bounds().extent();
    for (int axis = 0; axis < 3; ++axis) {
      const float x = mesh.positions()[0][axis], place = (x - mesh.bounds().lo[axis]) / extent[axis] * 8;
      naive.decide(place >= 0 && place <= 8, [&] {
        return Example{"lo = hi = x = " + text_of_number(double(x)), "a cell", text_of_number(double(place))};
      });
    }
  }
}

// ---- Drawings

Sketch cells(std::string caption, int columns, int rows) {
  Sketch sketch{std::move(caption), {}};
  for (int x = 0; x <= columns; ++x) sketch.line({x, 0}, {x, rows}, Role::aid);
  for (int y = 0; y <= rows; ++y) sketch.line({0, y}, {columns, y}, Role::aid);
  return sketch;
}
Sketch draw_insert() {
  return cells("A triangle, seen from its side, in the face between two columns of cells.", 4, 3)
      .line({2, 0.4}, {2, 2.6}, Role::shape)
      .line({-0.5, 0.8}, {4.4, 2.1}, Role::ray)
      .dot({2, 1.46})
      .label({2.1, 0.3}, "floor(2) = 2, ceil(2) - 1 = 1: cells 2 to 1 are none", Role::naive);
}
Sketch draw_outside() {
  return cells("A long triangle is known to the ray's first cell, but met in the fourth.", 4, 3)
      .line({0.2, 0.1}, {3.9, 2.2}, Role::shape)
      .line({2.3, 0.4}, {2.7, 2.2}, Role::shape)
      .line({-0.4, 0.9}, {4.4, 1.9}, Role::ray)
      .dot({2.5, 1.5})
      .dot({2.8, 1.57}, Role::naive)
      .label({0.2, 2.5}, "true: the short one, in the third cell")
      .label({2.9, 0.6}, "found in the first cell: taken", Role::naive);
}
Sketch draw_drift() {
  return cells("Steps along a ray: true ones, and those of a sum that loses a little each time (here 4% a step).", 8, 4)
      .line({0, 0.2}, {8, 3.7}, Role::ray)
      .path({{0, 0.2}, {1, 0.62}, {2, 1.04}, {3, 1.46}, {4, 1.88}, {5, 2.3}, {6, 2.72}, {7, 3.14}, {8, 3.56}},
            Role::naive)
      .label({0.2, 4.2}, "after 100,000 steps: tens of cells off", Role::naive);
}
Sketch draw_index() {
  return cells("A point one float before the far face, in a grid of four cells.", 4, 1)
      .dot({3.97, 0.5})
      .label({2.4, 1.2}, "cell 3")
      .rectangle({4, 0}, {5, 1}, Role::naive)
      .label({4.1, 0.5}, "(x - lo) / (hi - lo) rounds to 1: cell 4", Role::naive);
}
Sketch draw_flat() {
  return cells("A flat scene from its side, in a grid without height.", 6, 0)
      .line({0, 0}, {6, 0}, Role::shape)
      .line({1.5, 2}, {3.5, -1}, Role::ray)
      .dot({2.83, 0})
      .label({3.2, 0.6}, "(z - lo) / (hi - lo) = 0 / 0: as an integer -2147483648", Role::naive);
}

}  // namespace

HardCase grid_insert() {
  return {
      .id = "grid-insert",
      .group = "accelerator",
      .inputs = "300 triangles of whole numbers in a scene of 8 x 8 x 8, 2500 rays of whole and half numbers",
      .expected = "the nearest hit, as without any structure",
      .why =
          "A triangle in the face between two cells has floor(lo) = k and ceil(hi) - 1 = k - 1: a range without any "
          "cell. Cells are closed, and a triangle belongs to all that it touches.",
      .oracle = Oracle::rationals,
      .reference = "Amanatides and Woo 1987",
      .run = run_insert,
      .draw = draw_insert};
}
HardCase grid_outside_cell() {
  return {
      .id = "grid-outside-cell",
      .group = "accelerator",
      .inputs = "150 triangles as large as the scene, in many cells each; 2500 rays",
      .expected = "the nearest hit, as without any structure",
      .why =
          "A cell hands out a triangle that is hit in another cell, farther on; what lies between comes only later. A "
          "hit beyond the cell's end has to wait.",
      .oracle = Oracle::rationals,
      .reference = "Amanatides and Woo 1987",
      .run = run_outside_cell,
      .draw = draw_outside};
}
HardCase grid_drift() {
  return {
      .id = "grid-drift",
      .group = "accelerator",
      .inputs = "a row of 2000 small triangles 64,000 long, rays along it at each; slanted walks of 100,000 columns",
      .expected = "the triangle aimed at; the row that real arithmetic says",
      .why =
          "Each `next += delta` rounds at the size of the sum. All errors of one binade have the same sign, and after "
          "100,000 steps the walk is rows away from the ray. Planes computed from their number do not drift.",
      .oracle = Oracle::rationals,
      .run = run_drift,
      .draw = draw_drift};
}
HardCase grid_index_n() {
  return {
      .id = "grid-index-n",
      .group = "accelerator",
      .inputs = "40 boxes [lo, hi) in float, rays from the float before hi at walls in hi",
      .expected = "the wall; an index of at most n - 1",
      .why =
          "(x - lo) / (hi - lo) rounds to 1 though x < hi, or its product with n to n. The cell behind the last one is "
          "somebody else's memory.",
      .oracle = Oracle::rationals,
      .run = run_index_n,
      .draw = draw_index};
}
HardCase grid_flat() {
  return {
      .id = "grid-flat",
      .group = "accelerator",
      .inputs = "scenes in the planes z = 0 and x = 2, and triangles on one line; rays across and within",
      .expected = "the nearest hit; index 0 along axes without extent",
      .why =
          "Without extent a cell has size 0, and the place in it is 0 / 0. NaN made an integer is undefined, on x86 "
          "the smallest there is.",
      .oracle = Oracle::rationals,
      .run = run_flat,
      .draw = draw_flat};
}

}  // namespace sightline::hard
