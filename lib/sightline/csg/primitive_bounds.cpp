/// Bounds are computed in balls, whose ends are proven, so that nothing has to be added for rounding.

#include "sightline/csg/primitive_bounds.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "sightline/math/ball.h"
#include "sightline/math/rounding.h"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Wide = Triple<WideBall>;

double above(const WideBall& x) { return next_up(x.mid.high + (x.radius + std::fabs(x.mid.low)) * (1 + 0x1p-50)); }
double below(const WideBall& x) { return -above(-x); }

/// The square root, of a sum of squares whose ball may hold 0 or reach below it.
WideBall root_of_sum(const WideBall& x) {
  const WideBall root = sqrt(x);
  if (std::isfinite(root.radius)) return root;
  const double most = std::sqrt(std::max(0.0, above(x)));
  return {DoubleDouble(0), next_up(most)};
}

/// Of the affine map back from a frame: columns of the inverse matrix, and where the frame's origin is.
struct Placement {
  std::array<Wide, 3> axes;
  Wide origin;
  bool is_certain;
};

Placement placement_of(const Frame& frame) {
  const auto entry = [&](std::size_t row, std::size_t column) { return WideBall(frame.rows[row][column]); };
  std::array<Wide, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) rows[i] = {entry(i, 0), entry(i, 1), entry(i, 2)};
  const WideBall determinant = dot(rows[0], cross(rows[1], rows[2]));
  Placement placement;
  for (std::size_t i = 0; i < 3; ++i) {
    placement.axes[i] = cross(rows[(i + 1) % 3], rows[(i + 2) % 3]);
    for (WideBall& x : placement.axes[i]) x = x / determinant;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    WideBall sum(0.0);
    for (std::size_t i = 0; i < 3; ++i) sum = sum - placement.axes[i][axis] * entry(i, 3);
    placement.origin[axis] = sum;
  }
  placement.is_certain = sign_of(determinant).value != 0;
  return placement;
}

/// How a shape's own coordinates show along an axis of the world: world = offset + row . local.
struct Row {
  Wide row;
  WideBall offset;
};

std::array<Row, 3> rows_of(const Frame& frame) {
  std::array<Row, 3> rows;
  if (frame.is_identity()) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rows[axis].row[axis] = WideBall(1.0);
      rows[axis].offset = WideBall(0.0);
    }
    return rows;
  }
  const Placement placement = placement_of(frame);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows[axis] = {{placement.axes[0][axis], placement.axes[1][axis], placement.axes[2][axis]}, placement.origin[axis]};
  }
  return rows;
}

/// The interval of row . x over a shape.
struct Range {
  double lo, hi;
};

Range around(const WideBall& center, const WideBall& half) { return {below(center - half), above(center + half)}; }

Range range_of(const solid::Sphere& sphere, const Row& row) {
  const WideBall center = dot(row.row, triple<WideBall>(sphere.center)) + row.offset;
  return around(center, WideBall(sphere.radius) * root_of_sum(dot(row.row, row.row)));
}

Range range_of(const solid::Box& box, const Row& row) {
  WideBall lo = row.offset, hi = row.offset;
  for (std::size_t i = 0; i < 3; ++i) {
    const WideBall a = row.row[i] * WideBall(box.lo[static_cast<int>(i)]);
    const WideBall b = row.row[i] * WideBall(box.hi[static_cast<int>(i)]);
    const bool rises = below(row.row[i]) >= 0, falls = above(row.row[i]) <= 0;
    if (rises || falls) {
      lo = lo + (rises ? a : b);
      hi = hi + (rises ? b : a);
    } else {
      const double least = std::min(below(a), below(b)), most = std::max(above(a), above(b));
      lo = lo + WideBall(least), hi = hi + WideBall(most);
    }
  }
  return {below(lo), above(hi)};
}

/// A disk of a radius across an axis: how far it reaches along the row.
WideBall reach_of_disk(double radius, const Vec3d& from, const Vec3d& to, const Row& row) {
  const Wide axis = difference(triple<WideBall>(to), triple<WideBall>(from));
  const Wide across = cross(row.row, axis);
  return WideBall(radius) * root_of_sum(dot(across, across) / dot(axis, axis));
}

Range hull(const Range& a, const Range& b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

Range range_of(const solid::Cylinder& cylinder, const Row& row) {
  const WideBall reach = reach_of_disk(cylinder.radius, cylinder.base, cylinder.top, row);
  const auto end = [&](const Vec3d& p) { return around(dot(row.row, triple<WideBall>(p)) + row.offset, reach); };
  return hull(end(cylinder.base), end(cylinder.top));
}

Range range_of(const solid::Cone& cone, const Row& row) {
  const WideBall reach = reach_of_disk(cone.radius, cone.apex, cone.base, row);
  const auto end = [&](const Vec3d& p, const WideBall& r) {
    return around(dot(row.row, triple<WideBall>(p)) + row.offset, r);
  };
  return hull(end(cone.apex, WideBall(0.0)), end(cone.base, reach));
}

/// A tube around a circle: the circle's reach and the tube's.
Range range_of(const solid::Torus& torus, const Row& row) {
  const WideBall circle = reach_of_disk(torus.major, Vec3d(0), torus.axis, row);
  const WideBall tube = WideBall(torus.minor) * root_of_sum(dot(row.row, row.row));
  return around(dot(row.row, triple<WideBall>(torus.center)) + row.offset, circle + tube);
}

/// An ellipsoid x.Ax + b.x + c <= 0 has the center -A^-1 b / 2 and, along a row w, the reach
/// sqrt(k w.A^-1 w), k = b.A^-1 b / 4 - c. Other quadrics have no bounds.
Range range_of(const solid::Quadric& quadric, const Row& row) {
  const auto& q = quadric.coefficients;
  const WideBall half(0.5);
  const Wide x{WideBall(q[0]), half * WideBall(q[3]), half * WideBall(q[4])};
  const Wide y{half * WideBall(q[3]), WideBall(q[1]), half * WideBall(q[5])};
  const Wide z{half * WideBall(q[4]), half * WideBall(q[5]), WideBall(q[2])};
  const WideBall minor = x[0] * y[1] - x[1] * y[0], determinant = dot(x, cross(y, z));
  const bool is_ellipsoid = sign_of(x[0]).value > 0 && sign_of(minor).value > 0 && sign_of(determinant).value > 0;
  if (!is_ellipsoid) return {-infinity, infinity};
  const std::array<Wide, 3> adjugate{cross(y, z), cross(z, x), cross(x, y)};
  const auto solved = [&](const Wide& v) {
    Wide result;
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = (adjugate[0][i] * v[0] + adjugate[1][i] * v[1] + adjugate[2][i] * v[2]) / determinant;
    }
    return result;
  };
  const Wide linear{WideBall(q[6]), WideBall(q[7]), WideBall(q[8])};
  const Wide twice_center = solved(linear);
  const WideBall size = WideBall(0.25) * dot(linear, twice_center) - WideBall(q[9]);
  if (above(size) < 0) return {infinity, -infinity};
  const WideBall center = row.offset - half * dot(row.row, twice_center);
  return around(center, root_of_sum(size * dot(row.row, solved(row.row))));
}

Range range_of(const solid::HalfSpace&, const Row&) { return {-infinity, infinity}; }

Range range_of(const std::shared_ptr<const ClosedMesh>& mesh, const Row& row) {
  const Aabb box = mesh->bounds();
  return range_of(solid::Box{Vec3d(box.lo), Vec3d(box.hi)}, row);
}

[[noreturn]] void refuse(const std::string& expected, const std::string& found) {
  throw std::invalid_argument("expected " + expected + ", found " + found);
}

/// All its digits.
std::string text_of(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

void check_finite(const Vec3d& v, const char* what) {
  if (!is_finite(v)) refuse(std::string("finite coordinates of the ") + what, "one that is not");
}
void check_size(double x, const char* what) {
  if (!(std::isfinite(x) && x >= 0)) refuse(std::string("a ") + what + " that is finite and not negative", text_of(x));
}
void check_ends(const Vec3d& a, const Vec3d& b, const char* what) {
  if (a == b) refuse(std::string("two ends of the ") + what + " that are apart", "one point");
}

struct Check {
  void operator()(const solid::HalfSpace& half) const {
    check_finite(half.normal, "half-space's normal");
    if (half.normal == Vec3d(0)) refuse("a half-space's normal that is not zero", "zero");
    if (!std::isfinite(half.offset)) refuse("a half-space's finite offset", text_of(half.offset));
  }
  void operator()(const solid::Sphere& sphere) const {
    check_finite(sphere.center, "sphere's center");
    check_size(sphere.radius, "sphere's radius");
  }
  void operator()(const solid::Box& box) const {
    check_finite(box.lo, "box's corner lo");
    check_finite(box.hi, "box's corner hi");
    for (int axis = 0; axis < 3; ++axis) {
      if (box.lo[axis] > box.hi[axis]) {
        refuse(std::string("a box's lo not above its hi on axis ") + "xyz"[axis],
               text_of(box.lo[axis]) + " and " + text_of(box.hi[axis]));
      }
    }
  }
  void operator()(const solid::Cylinder& cylinder) const {
    check_finite(cylinder.base, "cylinder's ends");
    check_finite(cylinder.top, "cylinder's ends");
    check_size(cylinder.radius, "cylinder's radius");
    check_ends(cylinder.base, cylinder.top, "cylinder");
  }
  void operator()(const solid::Cone& cone) const {
    check_finite(cone.apex, "cone's apex");
    check_finite(cone.base, "cone's base");
    check_size(cone.radius, "cone's radius");
    check_ends(cone.apex, cone.base, "cone");
  }
  void operator()(const solid::Quadric& quadric) const {
    for (const double x : quadric.coefficients) {
      if (!std::isfinite(x)) refuse("ten finite coefficients of the quadric", text_of(x));
    }
  }
  void operator()(const solid::Torus& torus) const {
    check_finite(torus.center, "torus's center");
    check_finite(torus.axis, "torus's axis");
    if (torus.axis == Vec3d(0)) refuse("a torus's axis that is not zero", "zero");
    check_size(torus.major, "torus's radius R");
    check_size(torus.minor, "torus's radius r");
  }
  void operator()(const std::shared_ptr<const ClosedMesh>& mesh) const {
    if (!mesh) refuse("a mesh", "none");
  }
};

}  // namespace

std::optional<Aabb> bounds_of(const SolidShape& shape, const Frame& frame) {
  const std::array<Row, 3> rows = rows_of(frame);
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const Range range =
        std::visit([&](const auto& s) { return range_of(s, rows[static_cast<std::size_t>(axis)]); }, shape);
    if (range.lo > range.hi) return Aabb{};
    box.lo[axis] = round_down(range.lo);
    box.hi[axis] = round_up(range.hi);
  }
  if (!is_finite(box.lo) || !is_finite(box.hi)) return std::nullopt;
  return box;
}

void check(const SolidShape& shape) { std::visit(Check(), shape); }

void check(const Frame& frame) {
  for (const auto& row : frame.rows) {
    for (const double x : row) {
      if (!std::isfinite(x)) refuse("finite numbers in a frame", text_of(x));
    }
  }
  if (!frame.is_identity() && !placement_of(frame).is_certain) refuse("a frame that can be inverted", "a flat one");
}

}  // namespace sightline
