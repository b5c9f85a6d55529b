#pragma once
/// Small scenes and rays that catch what random soup does not: everything here is reproducible.

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/shape/box.h"
#include "sightline/shape/mesh.h"
#include "sightline/shape/sphere.h"

namespace sightline::laws {

inline Vec3f random_point(Random& random, float lo, float hi) {
  const float x = random.uniform(lo, hi), y = random.uniform(lo, hi), z = random.uniform(lo, hi);
  return {x, y, z};
}

inline Vec3f lattice_point(Random& random, int size) {
  const auto x = random.below(size + 1), y = random.below(size + 1), z = random.below(size + 1);
  return {float(x), float(y), float(z)};
}

/// Unconnected triangles, each with vertices of its own.
class MeshMaker {
 public:
  void add(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const auto first = static_cast<std::uint32_t>(positions_.size());
    positions_.insert(positions_.end(), {a, b, c});
    triangles_.push_back({first, first + 1, first + 2});
  }
  TriangleMesh make() { return {std::move(positions_), std::move(triangles_)}; }

 private:
  std::vector<Vec3f> positions_;
  std::vector<TriangleMesh::Corners> triangles_;
};

inline TriangleMesh soup(int count, float size, std::uint64_t seed) {
  Random random(seed);
  MeshMaker maker;
  for (int i = 0; i < count; ++i) {
    const Vec3f at = random_point(random, 0, 1);
    maker.add(at, at + random_point(random, -size, size), at + random_point(random, -size, size));
  }
  return maker.make();
}

/// Vertices on a small integer lattice: coincident planes, equal distances, degenerate triangles, duplicates.
inline TriangleMesh lattice(int count, int size, std::uint64_t seed) {
  Random random(seed);
  MeshMaker maker;
  for (int i = 0; i < count; ++i) {
    const Vec3f a = lattice_point(random, size);
    Vec3f b = a, c = a;
    for (int axis = 0; axis < 3; ++axis) {
      b[axis] += float(random.below(3)) - 1;
      c[axis] += float(random.below(3)) - 1;
    }
    maker.add(a, b, c);
  }
  return maker.make();
}

/// Quads that tile the three lattice planes through the middle, so that rays run inside planes and along edges.
inline TriangleMesh walls(int size) {
  MeshMaker maker;
  const float middle = float(size / 2);
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [&](int i, int j) {
      Vec3f p(middle);
      p[(axis + 1) % 3] = float(i);
      p[(axis + 2) % 3] = float(j);
      return p;
    };
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) {
        maker.add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        maker.add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return maker.make();
}

inline TriangleMesh flat(int count, std::uint64_t seed) {
  Random random(seed);
  MeshMaker maker;
  for (int i = 0; i < count; ++i) {
    Vec3f corners[3];
    const Vec3f at = random_point(random, 0, 8);
    for (Vec3f& corner : corners) corner = {at.x + random.uniform(-1, 1), at.y + random.uniform(-1, 1), 0};
    maker.add(corners[0], corners[1], corners[2]);
  }
  return maker.make();
}

inline TriangleMesh copies(int count) {
  MeshMaker maker;
  for (int i = 0; i < count; ++i) maker.add({0, 0, 0}, {1, 0, 0.25f}, {0, 1, 0.5f});
  return maker.make();
}

inline TriangleMesh sticks(int count, std::uint64_t seed) {
  Random random(seed);
  MeshMaker maker;
  for (int i = 0; i < count; ++i) {
    const Vec3f at = random_point(random, 0, 1);
    const float length = random.uniform(0.1f, 0.4f);
    maker.add(at, at + Vec3f(length, length, 0), at + Vec3f(0.0005f, 0, 0.0005f));
  }
  return maker.make();
}

/// Fine detail in the middle of a hall a thousand times its size.
inline TriangleMesh small_in_large() {
  MeshMaker maker;
  Random random(11);
  for (int i = 0; i < 400; ++i) {
    const Vec3f at = Vec3f(500) + random_point(random, 0, 1);
    maker.add(at, at + random_point(random, -0.1f, 0.1f), at + random_point(random, -0.1f, 0.1f));
  }
  maker.add({0, 0, 0}, {1000, 0, 0}, {0, 1000, 0});
  maker.add({1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0});
  maker.add({0, 0, 1000}, {1000, 0, 1000}, {0, 1000, 1000});
  maker.add({0, 0, 0}, {0, 0, 1000}, {1000, 0, 0});
  return maker.make();
}

/// The mesh scaled about the origin, then moved.
inline TriangleMesh transformed(const TriangleMesh& mesh, float scale, const Vec3f& offset) {
  std::vector<Vec3f> positions = mesh.positions();
  for (Vec3f& p : positions) p = scale * p + offset;
  return {std::move(positions), mesh.triangles()};
}

/// The mesh turned so that none of its planes is across an axis; planes bend by the rounding of their vertices.
inline TriangleMesh turned(const TriangleMesh& mesh) {
  std::vector<Vec3f> positions = mesh.positions();
  for (Vec3f& p : positions) {
    const Vec3d q(p);
    p = Vec3f(Vec3d(2 * q.x - q.y + 2 * q.z, 2 * q.x + 2 * q.y - q.z, 2 * q.y + 2 * q.z - q.x) / 3.0);
  }
  return {std::move(positions), mesh.triangles()};
}

inline SphereSet spheres(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Sphere> list;
  for (int i = 0; i < count; ++i) {
    const Vec3f center = random_point(random, 0, 1);
    list.push_back({center, i % 10 == 0 ? 0 : random.uniform(0, 0.1f)});
  }
  return SphereSet(std::move(list));
}

inline BoxSet lattice_boxes(int count, int size, std::uint64_t seed) {
  Random random(seed);
  std::vector<Aabb> list;
  for (int i = 0; i < count; ++i) {
    const Vec3f lo = lattice_point(random, size);
    list.push_back({lo, lo + lattice_point(random, 2)});
  }
  return BoxSet(std::move(list));
}

// ---- Rays

/// Between random points of the bounds enlarged by half on every side; every eighth starts far away.
template <class T>
std::vector<Ray<T>> rays_about(const Aabb& bounds, int count, std::uint64_t seed) {
  Random random(seed);
  const Vec3d center = 0.5 * (Vec3d(bounds.lo) + Vec3d(bounds.hi));
  const Vec3d extent = Vec3d(bounds.hi) - Vec3d(bounds.lo);
  const auto point = [&] {
    const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
    return center + 2.0 * (Vec3d(x, y, z) - 0.5) * extent;
  };
  std::vector<Ray<T>> rays;
  for (int i = 0; i < count; ++i) {
    const Vec3d to = point();
    Vec3d from = point();
    if (i % 8 == 0) from = to + (from - to) * 1000.0;
    Ray<T> ray{Vec3<T>(from), Vec3<T>(to - from)};
    if (i % 16 == 1) ray.t_max = T(0.75);
    if (i % 16 == 3) ray.t_min = T(0.5);
    if (i % 16 == 5) ray.t_min = T(-0.5);
    if (i % 16 == 7) ray.t_min = -std::numeric_limits<T>::infinity();
    if (max_norm(ray.direction) > 0) rays.push_back(ray);
  }
  return rays;
}

/// The same rays with directions scaled by `factor`, a power of two, and parameters to match.
template <class T>
std::vector<Ray<T>> stretched(std::vector<Ray<T>> rays, T factor) {
  for (Ray<T>& ray : rays) {
    ray.direction *= factor;
    ray.t_min /= factor;
    ray.t_max /= factor;
  }
  return rays;
}

/// Lattice points in lattice directions, with zeros of both signs.
template <class T>
std::vector<Ray<T>> lattice_rays(int size, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Ray<T>> rays;
  while (int(rays.size()) < count) {
    Ray<T> ray;
    for (int axis = 0; axis < 3; ++axis) {
      ray.origin[axis] = T(random.below(2 * size + 9)) / 2 - 2;
      ray.direction[axis] = T(random.below(5)) - 2;
      if (ray.direction[axis] == 0 && random.below(2) == 1) ray.direction[axis] = -T(0);
    }
    if (max_norm(ray.direction) > 0) rays.push_back(ray);
  }
  return rays;
}

/// At the corners and at points of the edges of the mesh.
template <class T>
std::vector<Ray<T>> rays_at_edges(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  Random random(seed);
  const Vec3d extent = Vec3d(mesh.bounds().hi) - Vec3d(mesh.bounds().lo);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < count && mesh.size() > 0; ++i) {
    const Triangle triangle = mesh[random.below(mesh.size())];
    const double share = i % 3 == 0 ? 0 : random.uniform_double();
    const Vec3d to = Vec3d(triangle.a) + share * (Vec3d(triangle.b) - Vec3d(triangle.a));
    const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
    const Vec3<T> from(to + 3.0 * (Vec3d(x, y, z) - 0.5) * extent);
    const Ray<T> ray{from, Vec3<T>(to) - from};
    if (max_norm(ray.direction) > 0) rays.push_back(ray);
  }
  return rays;
}

/// Rays with a NaN or an infinity somewhere, without direction, or with an empty range.
template <class T>
std::vector<Ray<T>> broken_rays() {
  const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
  const Ray<T> sound{Vec3<T>(T(0.5), T(0.5), T(-3)), Vec3<T>(T(0.01), T(0.02), 1)};
  std::vector<Ray<T>> rays;
  for (const T bad : {nan, infinity, -infinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      rays.push_back(sound);
      rays.back().origin[axis] = bad;
      rays.push_back(sound);
      rays.back().direction[axis] = bad;
    }
  }
  rays.push_back({sound.origin, Vec3<T>(0)});
  if constexpr (std::is_same_v<T, double>) {
    rays.push_back({sound.origin, sound.direction * 1e-200});
    rays.push_back({sound.origin, sound.direction * 1e200});
  }
  rays.push_back({sound.origin, sound.direction, nan, infinity});
  rays.push_back({sound.origin, sound.direction, 0, nan});
  rays.push_back({sound.origin, sound.direction, 2, 1});
  return rays;
}

}  // namespace sightline::laws
