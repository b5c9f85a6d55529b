#include "sightline/scene/teapot.h"

#include <array>

#include "sightline/shape/mesh_builder.h"

namespace sightline {
namespace {

/// 4 x 4 control points, row by row.
using Patch = std::array<Vec3d, 16>;

/// Body, lid and bottom are rings of 12 control points around the axis. A quarter of a ring is (radius, 0),
/// (radius, -shoulder), (shoulder, -radius), (0, -radius) at a height; shoulder is close to 0.56 * radius, which makes
/// the curve nearly a circle.
struct Ring {
  double radius, shoulder, height;
};

/// Handle and spout are half tubes, mirrored in the plane z = 0. A half ring is inner, inner moved by width, outer
/// moved by width, outer.
struct HalfRing {
  double inner_x, inner_height, outer_x, outer_height, width;
};

/// Four rings make a row of four patches; the last ring of a patch is the first of the next one of the same part.
constexpr Ring body[] = {
    {1.4, 0.784, 2.4},   {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125},
    {1.5, 0.84, 2.4},                                                  // rim
    {1.75, 0.98, 1.875}, {2, 1.12, 1.35},          {2, 1.12, 0.9},     // upper body
    {2, 1.12, 0.45},     {1.5, 0.84, 0.225},       {1.5, 0.84, 0.15},  // lower body
    {1.5, 0.84, 0.075},  {1.425, 0.798, 0},        {0, 0, 0},          // bottom
};
constexpr Ring lid[] = {
    {0, 0, 3.15},       {0.8, 0.45, 3.15},  {0, 0, 2.85},      {0.2, 0.112, 2.7},  // knob
    {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4},                     // cover
};
constexpr HalfRing handle[] = {
    {-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3}, {-2.7, 2.025, -3, 2.25, 0.3},
    {-2.7, 1.8, -3, 1.8, 0.3},      {-2.7, 1.575, -3, 1.35, 0.3},   {-2.5, 1.125, -2.65, 0.9375, 0.3},
    {-2, 0.9, -1.9, 0.6, 0.3},
};
constexpr HalfRing spout[] = {
    {1.7, 1.425, 1.7, 0.6, 0.66}, {2.6, 1.425, 3.1, 0.825, 0.66},     {2.3, 2.1, 2.4, 2.025, 0.25},
    {2.7, 2.4, 3.3, 2.4, 0.25},   {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15},
    {2.8, 2.4, 3.2, 2.4, 0.15},
};

/// The values of the four cubic Bernstein polynomials.
std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// A border's points come from its own four control points only (the other weights are zero), in an order that the
/// patch on the other side uses as well; so both give the same bits.
Vec3d evaluate(const Patch& patch, double u, double v) {
  const std::array<double, 4> along = bernstein(u), across = bernstein(v);
  Vec3d sum(0);
  for (int row = 0; row < 4; ++row) {
    Vec3d point(0);
    for (int column = 0; column < 4; ++column) point += across[column] * patch[4 * row + column];
    sum += along[row] * point;
  }
  return sum;
}

/// `flip` where rows and columns run such that the front of the patch would face inward.
void add_patch(MeshBuilder& builder, const Patch& patch, int segments, bool flip) {
  std::vector<std::uint32_t> ids;
  for (int row = 0; row <= segments; ++row) {
    for (int column = 0; column <= segments; ++column) {
      ids.push_back(builder.vertex(Vec3f(evaluate(patch, double(row) / segments, double(column) / segments))));
    }
  }
  const auto id = [&](int row, int column) { return ids[static_cast<std::size_t>(row * (segments + 1) + column)]; };
  for (int row = 0; row < segments; ++row) {
    for (int column = 0; column < segments; ++column) {
      const std::uint32_t a = id(row, column), b = id(row + 1, column), c = id(row + 1, column + 1),
                          d = id(row, column + 1);
      for (const auto& [second, third] : {std::pair(b, c), std::pair(c, d)}) {
        if (a == second || second == third || third == a) continue;
        if (flip) {
          builder.triangle(a, third, second);
        } else {
          builder.triangle(a, second, third);
        }
      }
    }
  }
}

/// Quarter turns about the y axis, exact.
Vec3d turned(Vec3d p, int quarters) {
  for (int i = 0; i < quarters; ++i) p = {p.z, p.y, -p.x};
  return p;
}

void add_rings(MeshBuilder& builder, const Ring* rings, int segments) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    Patch patch;
    for (int row = 0; row < 4; ++row) {
      const auto& [radius, shoulder, height] = rings[row];
      patch[4 * row] = turned({radius, height, 0}, quarter);
      patch[4 * row + 1] = turned({radius, height, shoulder}, quarter);
      patch[4 * row + 2] = turned({shoulder, height, radius}, quarter);
      patch[4 * row + 3] = turned({radius, height, 0}, quarter + 3);
    }
    add_patch(builder, patch, segments, true);
  }
}

void add_half_rings(MeshBuilder& builder, const HalfRing* rings, int segments) {
  for (const double side : {1.0, -1.0}) {
    Patch patch;
    for (int row = 0; row < 4; ++row) {
      const HalfRing& ring = rings[row];
      patch[4 * row] = {ring.inner_x, ring.inner_height, 0};
      patch[4 * row + 1] = {ring.inner_x, ring.inner_height, side * ring.width};
      patch[4 * row + 2] = {ring.outer_x, ring.outer_height, side * ring.width};
      patch[4 * row + 3] = {ring.outer_x, ring.outer_height, 0};
    }
    add_patch(builder, patch, segments, side > 0);
  }
}

}  // namespace

TriangleMesh make_teapot(int segments) {
  MeshBuilder builder;
  for (int first : {0, 3, 6, 9}) add_rings(builder, body + first, segments);
  for (int first : {0, 3}) add_rings(builder, lid + first, segments);
  for (int first : {0, 3}) add_half_rings(builder, handle + first, segments);
  for (int first : {0, 3}) add_half_rings(builder, spout + first, segments);
  return builder.take();
}

}  // namespace sightline
