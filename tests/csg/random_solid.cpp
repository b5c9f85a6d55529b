#include "tests/csg/random_solid.h"

#include <cmath>
#include <sstream>

namespace sightline {
namespace {

/// Mostly small integers, some halves, and few numbers that differ in their last place only.
double coordinate(const Dice& dice) {
  constexpr std::array<double, 4> close{0.3, 0.1 + 0.2, 0x1.fffffffffffffp-1, 0x1.0000000000001p0};
  const int kind = dice(10);
  if (kind < 7) return dice(5) - 2;
  if (kind < 9) return 0.5 * (dice(9) - 4);
  return close[static_cast<std::size_t>(dice(4))];
}
Vec3d point(const Dice& dice) {
  const double x = coordinate(dice), y = coordinate(dice), z = coordinate(dice);
  return {x, y, z};
}

Vec3d whole_vector(const Dice& dice, int reach) {
  Vec3d v(0);
  for (int i = 0; i < 3; ++i) v[i] = dice(2 * reach + 1) - reach;
  return v;
}

/// Along an axis as often as not; never 0.
Vec3d direction(const Dice& dice) {
  Vec3d v(0);
  if (dice(2) == 0) v = whole_vector(dice, 2);
  if (v == Vec3d(0)) v[dice(3)] = dice(2) == 0 ? 1 : -1;
  return v;
}

solid::Box box(const Dice& dice) {
  const Vec3d a = point(dice), b = point(dice);
  solid::Box box{glm::min(a, b), glm::max(a, b)};
  for (int i = 0; i < 3; ++i) box.hi[i] += box.lo[i] == box.hi[i];
  return box;
}

solid::HalfSpace half(const Dice& dice) {
  constexpr std::array<double, 5> scales{1, 3, 0.5, 0.1, 0x1p+40};
  const Vec3d normal = direction(dice);
  const double offset = coordinate(dice), scale = scales[static_cast<std::size_t>(dice(5))];
  return {scale * normal, scale * offset};
}

double radius(const Dice& dice) {
  constexpr std::array<double, 6> radii{1, 2, 3, 0.5, 1.5, 0x1.0000000000001p0};
  return radii[static_cast<std::size_t>(dice(6))];
}

Vec3d other_than(const Vec3d& p, const Dice& dice) { return p + direction(dice); }

solid::Quadric quadric(const Dice& dice) {
  solid::Quadric quadric;
  for (std::size_t i = 0; i < 10; ++i) quadric.coefficients[i] = dice(i < 3 ? 4 : 3) - 1;
  quadric.coefficients[9] -= dice(4);
  return quadric;
}

Torus torus(const Dice& dice) {
  const Vec3d center = point(dice), axis = direction(dice);
  const double minor = 0.25 * (1 + dice(4));
  return {center, axis, minor + 0.25 * (1 + dice(6)), minor};
}

/// A tetrahedron, none of whose faces is parallel to lines of the lattice.
std::shared_ptr<const ClosedMesh> mesh(const Dice& dice) {
  const Vec3d at = point(dice);
  const double size = 0.5 * (1 + dice(4));
  std::vector<Vec3d> vertices{{1.01, -0.13, 0.07}, {-0.97, 1.19, 0.11}, {-0.89, -1.07, -0.23}, {0.03, 0.17, 1.37}};
  for (Vec3d& v : vertices) v = at + size * v;
  return std::make_shared<const ClosedMesh>(
      vertices, std::vector<ClosedMesh::Corners>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

/// Axes swapped and turned by the angle of 3, 4 and 5, scaled and moved: all as rounded, which is exact enough for a
/// definition.
Frame frame(const Dice& dice) {
  constexpr std::array<double, 4> scales{1, 2, 0.5, -1};
  Frame frame;
  const int turn = dice(3);
  const bool is_skew = dice(3) == 0;
  const double scale = scales[static_cast<std::size_t>(dice(4))];
  const Vec3d move = whole_vector(dice, 1);
  for (int i = 0; i < 3; ++i) {
    auto& row = frame.rows[static_cast<std::size_t>(i)];
    row = {0, 0, 0, move[i]};
    row[static_cast<std::size_t>((i + turn) % 3)] = scale;
  }
  if (is_skew) frame.rows[0] = {0.6, 0.8, 0, move.x}, frame.rows[1] = {-0.8, 0.6, 0, move.y};
  if (is_skew) frame.rows[2] = {0, 0, scale, move.z};
  return frame;
}

}  // namespace

SolidTree primitive_of_kind(int kind, const Dice& dice) {
  switch (kind) {
    case 0:
      return half(dice);
    case 1: {
      const Vec3d center = point(dice);
      return solid::Sphere{center, radius(dice)};
    }
    case 2:
      return box(dice);
    case 3: {
      const Vec3d base = point(dice), top = other_than(base, dice);
      return solid::Cylinder{base, top, radius(dice)};
    }
    case 4: {
      const Vec3d apex = point(dice), base = other_than(apex, dice);
      return solid::Cone{apex, base, radius(dice)};
    }
    case 5:
      return quadric(dice);
    case 6:
      return torus(dice);
    default:
      return mesh(dice);
  }
}

SolidTree lattice_primitive(const Dice& dice) { return primitive_of_kind(2 - dice(3), dice); }

SolidTree any_primitive(const Dice& dice) {
  SolidTree primitive = primitive_of_kind(dice(shape_kinds), dice);
  if (dice(3) == 2) primitive.frame = frame(dice);
  return primitive;
}

SolidTree random_tree(const Dice& dice, int depth, const std::function<SolidTree(const Dice&)>& primitive) {
  std::vector<SolidTree> parts;
  const std::function<SolidTree(int)> grown = [&](int levels) -> SolidTree {
    if (levels == 0) return primitive(dice);
    const int kind = dice(8);
    if (kind == 7 && !parts.empty()) return parts[static_cast<std::size_t>(dice(static_cast<int>(parts.size())))];
    if (kind == 6) return ~grown(levels - 1);
    if (kind == 5) return primitive(dice);
    const int count = kind == 4 ? 1 + dice(4) : 2;
    std::vector<SolidTree> args;
    for (int i = 0; i < count; ++i) args.push_back(grown(levels - 1));
    const SolidTree tree(operation_infos[static_cast<std::size_t>(dice(4))].operation, std::move(args));
    parts.push_back(tree);
    return tree;
  };
  return grown(depth);
}

Ray<double> lattice_ray(const Dice& dice) {
  Ray<double> ray{point(dice), direction(dice)};
  switch (dice(4)) {
    case 0:  // between two points of the lattice
      ray.direction = point(dice) - ray.origin;
      break;
    case 1:  // from afar
      ray.origin = ray.origin - 16.0 * ray.direction;
      break;
    case 2:  // of another length
      ray.direction *= dice(2) == 0 ? 0x1p-30 : 1.0 / 3;
      break;
    default:
      break;
  }
  if (ray.direction == Vec3d(0)) ray.direction.z = 1;
  return ray;
}

namespace {

std::string text_of(const Vec3d& v) {
  std::ostringstream text;
  text.precision(17);
  text << '(' << v.x << ' ' << v.y << ' ' << v.z << ')';
  return text.str();
}

struct ShapeText {
  std::ostream& out;

  void operator()(const solid::HalfSpace& half) { out << "half " << text_of(half.normal) << ' ' << half.offset; }
  void operator()(const solid::Sphere& sphere) { out << "sphere " << text_of(sphere.center) << ' ' << sphere.radius; }
  void operator()(const solid::Box& box) { out << "box " << text_of(box.lo) << ' ' << text_of(box.hi); }
  void operator()(const solid::Cylinder& cylinder) {
    out << "cylinder " << text_of(cylinder.base) << ' ' << text_of(cylinder.top) << ' ' << cylinder.radius;
  }
  void operator()(const solid::Cone& cone) {
    out << "cone " << text_of(cone.apex) << ' ' << text_of(cone.base) << ' ' << cone.radius;
  }
  void operator()(const solid::Quadric& quadric) {
    out << "quadric";
    for (const double x : quadric.coefficients) out << ' ' << x;
  }
  void operator()(const Torus& torus) {
    out << "torus " << text_of(torus.center) << ' ' << text_of(torus.axis) << ' ' << torus.major << ' ' << torus.minor;
  }
  void operator()(const std::shared_ptr<const ClosedMesh>& mesh) {
    out << "mesh";
    for (const Vec3d& v : mesh->vertices()) out << ' ' << text_of(v);
  }
};

}  // namespace

std::string text_of(const SolidTree& tree) {
  std::ostringstream out;
  out.precision(17);
  out << '[';
  if (tree.kind == SolidTree::Kind::primitive) {
    std::visit(ShapeText{out}, tree.shape);
    for (const auto& row : tree.frame.rows) {
      if (!tree.frame.is_identity()) out << " / " << row[0] << ' ' << row[1] << ' ' << row[2] << ' ' << row[3];
    }
  } else {
    out << (tree.kind == SolidTree::Kind::complement ? "compl" : operation_infos[std::size_t(tree.operation)].name);
    for (const SolidTree& arg : tree.args) out << ' ' << text_of(arg);
  }
  out << ']';
  return out.str();
}

std::string text_of(const Ray<double>& ray) { return text_of(ray.origin) + " -> " + text_of(ray.direction); }

}  // namespace sightline
