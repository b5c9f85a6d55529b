#include "tests/csg/exact_solid.h"

#include <numeric>
#include <sstream>
#include <variant>

namespace sightline::oracle {
namespace {

template <class N>
using Vector = std::array<N, 3>;

template <class N>
Vector<N> vector(const Vec3d& v) {
  return {N(v.x), N(v.y), N(v.z)};
}
template <class N>
Vector<N> operator-(const Vector<N>& a, const Vector<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class N>
N square(const N& x) {
  return x * x;
}

/// Functions of a point that are all at most 0 in the shape, in exact numbers or in polynomials of t.
template <class N>
struct Faces {
  Vector<N> p;
  std::vector<N>& found;

  void operator()(const solid::HalfSpace& half) { found.push_back(dot(vector<N>(half.normal), p) - N(half.offset)); }
  void operator()(const solid::Sphere& sphere) {
    const auto q = p - vector<N>(sphere.center);
    found.push_back(dot(q, q) - square(N(sphere.radius)));
  }
  void operator()(const solid::Box& box) {
    for (int i = 0; i < 3; ++i) {
      found.push_back(N(box.lo[i]) - p[static_cast<std::size_t>(i)]);
      found.push_back(p[static_cast<std::size_t>(i)] - N(box.hi[i]));
    }
  }
  /// The distance from the axis: |q|^2 - (q.a)^2 / |a|^2 <= r^2.
  void operator()(const solid::Cylinder& cylinder) {
    const auto q = p - vector<N>(cylinder.base), axis = vector<N>(cylinder.top) - vector<N>(cylinder.base);
    const N length2 = dot(axis, axis), height = dot(q, axis);
    found.push_back(length2 * dot(q, q) - square(height) - square(N(cylinder.radius)) * length2);
    found.push_back(-height);
    found.push_back(height - length2);
  }
  /// At the height h of |a| the radius is r h / |a|.
  void operator()(const solid::Cone& cone) {
    const auto q = p - vector<N>(cone.apex), axis = vector<N>(cone.base) - vector<N>(cone.apex);
    const N length2 = dot(axis, axis), height = dot(q, axis);
    found.push_back(length2 * (length2 * dot(q, q) - square(height)) - square(N(cone.radius) * height));
    found.push_back(-height);
    found.push_back(height - length2);
  }
  void operator()(const solid::Quadric& quadric) {
    const auto k = [&](std::size_t i) { return N(quadric.coefficients[i]); };
    const auto& [x, y, z] = p;
    found.push_back(k(0) * x * x + k(1) * y * y + k(2) * z * z + k(3) * x * y + k(4) * x * z + k(5) * y * z + k(6) * x +
                    k(7) * y + k(8) * z + k(9));
  }
  /// (|q|^2 + R^2 - r^2)^2 <= 4 R^2 (|q|^2 - (q.a)^2 / |a|^2).
  void operator()(const Torus& torus) {
    const auto q = p - vector<N>(torus.center), axis = vector<N>(torus.axis);
    const N major2 = square(N(torus.major)), length2 = dot(axis, axis);
    const N around = length2 * dot(q, q) - square(dot(q, axis));
    found.push_back(length2 * square(dot(q, q) + major2 - square(N(torus.minor))) - N(4) * major2 * around);
  }
  void operator()(const std::shared_ptr<const ClosedMesh>& mesh) {
    for (std::uint32_t id = 0; id < mesh->size(); ++id) {
      const auto& [a, b, c] = mesh->facet(id).vertices;
      const auto u = vector<N>(b) - vector<N>(a), v = vector<N>(c) - vector<N>(a);
      const Vector<N> normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      found.push_back(dot(normal, p - vector<N>(a)));
    }
  }
};

template <class N>
std::vector<N> faces_of(const SolidTree& primitive, const Vector<N>& world) {
  Vector<N> local = world;
  for (std::size_t i = 0; i < 3 && !primitive.frame.is_identity(); ++i) {
    const auto& row = primitive.frame.rows[i];
    local[i] = N(row[0]) * world[0] + N(row[1]) * world[1] + N(row[2]) * world[2] + N(row[3]);
  }
  std::vector<N> found;
  std::visit(Faces<N>{local, found}, primitive.shape);
  return found;
}

/// Given whether a primitive has the point; primitives are asked for in the order of the tree, and all of them.
template <class Has>
bool is_in(const SolidTree& tree, Has& has) {
  if (tree.kind == SolidTree::Kind::primitive) return has(tree);
  bool is_inside = is_in(tree.args[0], has);
  if (tree.kind == SolidTree::Kind::complement) return !is_inside;
  for (std::size_t i = 1; i < tree.args.size(); ++i) {
    const bool other = is_in(tree.args[i], has);
    switch (tree.operation) {
      case Operation::unite:
        is_inside |= other;
        break;
      case Operation::intersect:
        is_inside &= other;
        break;
      case Operation::subtract:
        is_inside &= !other;
        break;
      case Operation::differ:
        is_inside ^= other;
        break;
    }
  }
  return is_inside;
}

struct Crossing {
  Root root;
  std::size_t face;
};

}  // namespace

ExactSpans exact_spans(const SolidTree& tree, const Ray<double>& ray) {
  Vector<Polynomial> line;
  for (int i = 0; i < 3; ++i) line[static_cast<std::size_t>(i)] = Polynomial(ray.origin[i], ray.direction[i]);
  std::vector<bool> is_behind;  // by face of the whole tree
  std::vector<std::size_t> last_face;
  std::vector<Crossing> crossings;
  const auto collect = [&](const SolidTree& primitive) {
    for (const Polynomial& polynomial : faces_of(primitive, line)) {
      for (Root& root : roots_of(polynomial)) {
        if (!root.is_double) crossings.push_back({std::move(root), is_behind.size()});
      }
      is_behind.push_back(first_sign(polynomial) <= 0);
    }
    last_face.push_back(is_behind.size());
    return false;
  };
  is_in(tree, collect);
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.root.compare(b.root) < 0; });

  const auto is_inside = [&] {
    std::size_t face = 0, primitive = 0;
    const auto has = [&](const SolidTree&) {
      bool has_all = true;
      for (; face < last_face[primitive]; ++face) has_all = has_all && is_behind[face];
      ++primitive;
      return has_all;
    };
    return is_in(tree, has);
  };
  ExactSpans spans{is_inside(), {}};
  bool was_inside = spans.begins_inside;
  for (std::size_t i = 0; i < crossings.size();) {
    const Root& root = crossings[i].root;
    for (; i < crossings.size() && crossings[i].root.compare(root) == 0; ++i) is_behind[crossings[i].face].flip();
    if (is_inside() == was_inside) continue;
    was_inside = !was_inside;
    spans.ends.push_back(root);
  }
  return spans;
}

bool contains(const SolidTree& tree, const Point& point) {
  const auto has = [&](const SolidTree& primitive) {
    for (const Binary& value : faces_of(primitive, point)) {
      if (value.sign() > 0) return false;
    }
    return true;
  };
  return is_in(tree, has);
}

std::string fault_of(const Spans& spans, const ExactSpans& truth, Level level) {
  std::ostringstream fault;
  fault.precision(17);
  if (spans.begins_inside != truth.begins_inside) fault << "begins inside: " << spans.begins_inside << "; ";
  if (spans.boundaries.size() != truth.ends.size()) {
    fault << "expected " << truth.ends.size() << " boundaries, found " << spans.boundaries.size() << ":";
    for (const Boundary& boundary : spans.boundaries) fault << ' ' << boundary.t;
    return fault.str();
  }
  const double share = level == Level::watertight ? 0x1p-46 : 0x1p-52;
  for (std::size_t i = 0; i < truth.ends.size() && level != Level::fast; ++i) {
    const auto& [t, radius, primitive, face, root, is_flipped] = spans.boundaries[i];
    if (!is_within(truth.ends[i], t, radius))
      fault << "t = " << t << " is off by more than its bound " << radius << "; ";
    const bool is_accurate = level == Level::exact ? is_nearest(truth.ends[i], t)
                                                   : is_within(truth.ends[i], t, Binary(share) * Binary(std::fabs(t)));
    if (!is_accurate) fault << "t = " << t << " is not as accurate as its level; ";
  }
  return fault.str();
}

}  // namespace sightline::oracle
