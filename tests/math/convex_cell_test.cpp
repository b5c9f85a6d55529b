/// Cells under long sequences of cuts: by planes at random, tangent ones, nearly coincident ones, and planes through
/// what earlier cuts have made.

#include "sightline/math/convex_cell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sightline/math/random.h"

namespace sightline {
namespace {

constexpr double tolerance = 0x1p-42;  ///< About that of a binary space partition of a scene of this size.

Vec3d random_point(Random& random) {
  const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
  return 2.0 * Vec3d(x, y, z) - 1.0;
}

Vec3d random_direction(Random& random) {
  for (;;) {
    const Vec3d p = random_point(random);
    const double length = glm::length(p);
    if (length > 0.1 && length < 1) return p / length;
  }
}

Vec3d doubled_area(const std::vector<Vec3d>& loop) {
  Vec3d doubled(0);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) doubled += glm::cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return doubled;
}

/// Area of the part below the plane with the section that closes it, by clipping each face; the section is what makes
/// the face vectors of a closed surface sum to nothing.
double area_below(const Polyhedron& solid, const Plane& plane) {
  double area = 0;
  Vec3d sum(0);
  for (const auto& face : solid.faces) {
    std::vector<Vec3d> part;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3d& from = solid.vertices[face[i]];
      const Vec3d& to = solid.vertices[face[(i + 1) % face.size()]];
      const double at = plane.side(from), next = plane.side(to);
      if (at <= 0) part.push_back(from);
      if ((at <= 0) != (next <= 0)) part.push_back(from + at / (at - next) * (to - from));
    }
    const Vec3d doubled = doubled_area(part);
    area += 0.5 * glm::length(doubled);
    sum += doubled;
  }
  return area + 0.5 * glm::length(sum);
}

bool contains_a_face(const Plane& plane, const Polyhedron& solid, double cut_tolerance) {
  return std::any_of(solid.faces.begin(), solid.faces.end(), [&](const auto& face) {
    return std::all_of(face.begin(), face.end(),
                       [&](std::uint32_t v) { return std::fabs(plane.side(solid.vertices[v])) <= 4 * cut_tolerance; });
  });
}

/// Area of the faces of which three corners or more count as lying on the plane. If others lie deeper, the face is kept
/// beside a section that overlaps it.
double area_along(const Plane& plane, const Polyhedron& solid, double cut_tolerance) {
  double area = 0;
  for (const auto& face : solid.faces) {
    std::vector<Vec3d> loop;
    for (const std::uint32_t v : face) loop.push_back(solid.vertices[v]);
    const auto on = [&](const Vec3d& p) { return std::fabs(plane.side(p)) <= cut_tolerance; };
    if (std::count_if(loop.begin(), loop.end(), on) >= 3) area += 0.5 * glm::length(doubled_area(loop));
  }
  return area;
}

/// C1: neighbours share vertices, so each edge is walked once in each direction.
bool is_closed(const Polyhedron& solid) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& face : solid.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) edges.push_back({face[i], face[(i + 1) % face.size()]});
  }
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) == edges.end() &&
         std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
           return std::binary_search(edges.begin(), edges.end(), std::pair(edge.second, edge.first));
         });
}

enum class Cut { any, tangent, coincident, through_vertices, through_edge, axis, sliver };

Plane random_cut(Cut kind, const Polyhedron& solid, const Plane& last, Random& random) {
  const auto vertex = [&]() -> const Vec3d& {
    return solid.vertices[random.below(static_cast<std::uint32_t>(solid.vertices.size()))];
  };
  Vec3d normal = random_direction(random);
  switch (kind) {
    case Cut::tangent:
      return {normal, 0.9};
    case Cut::coincident: {
      const double turn = std::ldexp(1.0, -static_cast<int>(20 + random.below(30)));
      normal = glm::normalize(last.normal + turn * normal);
      return {normal, last.offset - turn * random.uniform_double()};
    }
    case Cut::through_vertices: {
      const Vec3d a = vertex(), b = vertex(), c = vertex(), across = glm::cross(b - a, c - a);
      if (glm::length(across) > 0x1p-20) normal = across / glm::length(across);
      return {normal, glm::dot(normal, a)};
    }
    case Cut::through_edge: {
      const auto& face = solid.faces[random.below(static_cast<std::uint32_t>(solid.faces.size()))];
      const Vec3d a = solid.vertices[face[0]], across = glm::cross(solid.vertices[face[1]] - a, normal);
      if (glm::length(across) > 0x1p-20) normal = across / glm::length(across);
      return {normal, glm::dot(normal, a)};
    }
    case Cut::axis: {
      const int axis = static_cast<int>(random.below(3));
      normal = Vec3d(0);
      normal[axis] = random.below(2) == 0 ? 1 : -1;
      return {normal, glm::dot(normal, vertex())};
    }
    case Cut::sliver: {
      double highest = -2;
      for (const Vec3d& p : solid.vertices) highest = std::max(highest, glm::dot(normal, p));
      return {normal, highest - tolerance * 8 * random.uniform_double()};
    }
    case Cut::any:
      break;
  }
  return {normal, glm::dot(normal, 0.7 * random_point(random))};
}

struct Reached {
  std::size_t vertices = 0;  ///< Most of any cell.
  int cuts = 0, wholes = 0;  ///< Wholes: cells left whole by C2.
};

/// Cuts a cube again and again, and checks each cell against its polyhedron.
void cut_often(const std::vector<Cut>& kinds, int count, double cut_tolerance, std::uint64_t seed, Reached& reached) {
  Random random(seed);
  ConvexCell cell = ConvexCell::box(Vec3d(-1), Vec3d(1)), part;
  Plane last{{0, 0, 1}, 0.5};
  for (int i = 0; i < count; ++i) {
    const Polyhedron solid = cell.polyhedron(Vec3d(0));
    const Cut kind = kinds[random.below(static_cast<std::uint32_t>(kinds.size()))];
    const Plane plane = random_cut(kind, solid, last, random);
    ConvexCell::Heights heights;
    cell.measure(plane, heights);
    constexpr double slack = 0x1p-24;  // faces are flat to within the tolerance, which cuts along them magnify
    if (heights.lo < 0 && heights.hi > 0) {
      const ConvexCell::Areas areas = cell.areas(heights);
      if (contains_a_face(plane, solid,
                          cut_tolerance)) {  // one part is flat, and rounding decides how much of the face is in it
        EXPECT_LE(areas.below, cell.area() + slack);
        EXPECT_LE(areas.above, cell.area() + slack);
      } else {
        EXPECT_NEAR(areas.below, area_below(solid, plane), slack);
        EXPECT_NEAR(areas.above, area_below(solid, {-plane.normal, -plane.offset}), slack);
      }
    }
    cell.keep_below(plane, cut_tolerance, part);
    const Polyhedron kept = part.polyhedron(Vec3d(0));
    ASSERT_LE(kept.vertices.size(), std::size_t(ConvexCell::max_vertices));
    const bool overlaps = kind != Cut::tangent && !is_closed(kept);
    if (part.is_empty() || part.area() < 0x1p-6 || overlaps) {  // begin anew
      cell = ConvexCell::box(Vec3d(-1), Vec3d(1));
      continue;
    }
    const bool is_whole = heights.hi > cut_tolerance && part.area() == cell.area() && kept.faces == solid.faces;
    if (heights.hi > cut_tolerance && !is_whole) {
      EXPECT_GE(part.area(), area_below(solid, {plane.normal, plane.offset - 2 * cut_tolerance}) - slack);
      const double upper = area_below(solid, {plane.normal, plane.offset + 2 * cut_tolerance});
      EXPECT_LE(part.area(), upper + 0x1p-12 + area_along(plane, solid, cut_tolerance));  // strips may overlap, too
      ++reached.cuts;
    }
    reached.wholes += is_whole;
    reached.vertices = std::max(reached.vertices, kept.vertices.size());
    std::swap(cell, part);
    last = plane;
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(ConvexCell, AreasMatchThePolyhedronHoweverItIsCut) {
  Reached reached;
  const std::vector<Cut> all{Cut::any,          Cut::tangent, Cut::coincident, Cut::through_vertices,
                             Cut::through_edge, Cut::axis,    Cut::sliver};
  for (std::uint64_t seed = 0; seed < 60; ++seed) cut_often(all, 200, tolerance, seed, reached);
  for (const Cut kind : all) cut_often({Cut::tangent, kind}, 300, tolerance, 100, reached);
  EXPECT_GT(reached.cuts, 3000);
}

TEST(ConvexCell, NeverExceedsItsCapacity) {
  Reached reached;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    cut_often({Cut::tangent}, 400, tolerance, seed, reached);
    cut_often({Cut::tangent, Cut::tangent, Cut::tangent, Cut::coincident, Cut::sliver}, 400, tolerance, seed, reached);
  }
  EXPECT_GT(reached.vertices, std::size_t(ConvexCell::max_vertices) * 3 / 4);
  EXPECT_GT(reached.wholes, 0);
}

/// Where vertices coincide within the tolerance, faces shrink to less than three corners and are dropped: an edge then
/// has one face only.
TEST(ConvexCell, KeepsItsCapacityWhenFacesAreDropped) {
  Random random(5);
  bool was_open = false;
  for (int round = 0; round < 40; ++round) {
    const double coarse = std::ldexp(1.0, -3 - round % 6);
    ConvexCell cell = ConvexCell::box(Vec3d(-1), Vec3d(1)), part;
    for (int i = 0; i < 300; ++i) {
      const Plane plane{random_direction(random), 0.9 + 0.1 * random.uniform_double()};
      cell.keep_below(plane, i % 2 == 0 ? coarse : tolerance, part);
      const Polyhedron kept = part.polyhedron(Vec3d(0));
      ASSERT_LE(kept.vertices.size(), std::size_t(ConvexCell::max_vertices));
      was_open = was_open || !is_closed(kept);
      if (!part.is_empty()) std::swap(cell, part);
    }
  }
  EXPECT_TRUE(was_open);
}

TEST(ConvexCell, PlanesThroughEdgesCutTheWholeSection) {
  const ConvexCell cube = ConvexCell::box(Vec3d(0), Vec3d(1));
  ConvexCell::Heights heights;
  const double half = 3 + std::sqrt(2.0);
  for (const Plane& diagonal :
       {Plane{{1, 1, 0}, 1}, Plane{{-1, -1, 0}, -1}, Plane{{0, 1, -1}, 0}, Plane{{1, 0, -1}, 0}}) {
    cube.measure(diagonal, heights);
    const ConvexCell::Areas areas = cube.areas(heights);
    EXPECT_DOUBLE_EQ(areas.below, half);
    EXPECT_DOUBLE_EQ(areas.above, half);
    ConvexCell part;
    cube.keep_below(diagonal, tolerance, part);
    EXPECT_DOUBLE_EQ(part.area(), half);
    EXPECT_TRUE(is_closed(part.polyhedron(Vec3d(0))));
  }
}

TEST(ConvexCell, FlatOnesHaveBothSides) {
  const ConvexCell flat = ConvexCell::box({0, 0, 0}, {2, 1, 0});
  EXPECT_EQ(flat.area(), 4);
  ConvexCell::Heights heights;
  flat.measure({{1, 0, 0}, 0.5}, heights);
  const ConvexCell::Areas areas = flat.areas(heights);
  EXPECT_EQ(areas.below, 1);
  EXPECT_EQ(areas.above, 3);
}

TEST(ConvexCell, NothingBelowIsEmpty) {
  const ConvexCell cube = ConvexCell::box(Vec3d(0), Vec3d(1));
  ConvexCell part;
  cube.keep_below({{1, 0, 0}, -1}, tolerance, part);
  EXPECT_TRUE(part.is_empty());
  EXPECT_EQ(part.area(), 0);
  cube.keep_below({{1, 0, 0}, 1}, tolerance, part);
  EXPECT_EQ(part.area(), 6);
}

}  // namespace
}  // namespace sightline
