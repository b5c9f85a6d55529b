#include "sightline/scene/procedural.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sightline/math/random.h"
#include "sightline/shape/mesh_builder.h"

namespace sightline {
namespace {

using Corners = TriangleMesh::Corners;

constexpr std::uint64_t seed = 1;

Vec3f random_point(Random& random) {
  const float x = random.uniform(), y = random.uniform(), z = random.uniform();
  return {x, y, z};
}

/// Triangles that share no vertices: corner 3 i + k belongs to triangle i.
TriangleMesh separate(std::vector<Vec3f> corners) {
  std::vector<Corners> triangles(corners.size() / 3);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) triangles[i] = {3 * i, 3 * i + 1, 3 * i + 2};
  return {std::move(corners), std::move(triangles)};
}

template <class MakeCorners>
TriangleMesh random_triangles(int count, MakeCorners make_corners) {
  Random random(seed);
  std::vector<Vec3f> corners;
  corners.reserve(3 * static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    for (const Vec3f& corner : make_corners(random)) corners.push_back(corner);
  }
  return separate(std::move(corners));
}

}  // namespace

TriangleMesh make_soup(int triangles) {
  const auto reach = static_cast<float>(1 / std::cbrt(static_cast<double>(triangles)));
  return random_triangles(triangles, [reach](Random& random) {
    const Vec3f a = random_point(random);
    const Vec3f b = a + reach * (random_point(random) - 0.5f);
    const Vec3f c = a + reach * (random_point(random) - 0.5f);
    return std::array{a, b, c};
  });
}

TriangleMesh make_sticks(int triangles) {
  const Vec3d along(0.5, 0.5, -std::sqrt(0.5));
  constexpr float width = 0.02f;
  return random_triangles(triangles, [&](Random& random) {
    const Vec3d inside(random_point(random));
    double begin = -2, end = 2;
    for (int axis = 0; axis < 3; ++axis) {
      const double to_low = -inside[axis] / along[axis], to_high = (1 - inside[axis]) / along[axis];
      begin = std::max(begin, std::min(to_low, to_high));
      end = std::min(end, std::max(to_low, to_high));
    }
    const Vec3f a(inside + begin * along), b(inside + end * along);
    return std::array{a, b, a + width * (random_point(random) - 0.5f)};
  });
}

TriangleMesh make_integers(int triangles) {
  return random_triangles(triangles, [](Random& random) {
    constexpr std::uint32_t side = 17, reach = 5;
    std::array<Vec3f, 3> corners;
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t low = random.below(side - reach + 1);
      for (Vec3f& corner : corners) corner[axis] = static_cast<float>(low + random.below(reach));
    }
    return corners;
  });
}

TriangleMesh make_flat(int triangles) {
  const auto reach = static_cast<float>(2 / std::sqrt(static_cast<double>(triangles)));
  return random_triangles(triangles, [reach](Random& random) {
    const Vec3f in_plane(1, 1, 0);
    const Vec3f a = in_plane * random_point(random);
    const Vec3f b = a + reach * in_plane * (random_point(random) - 0.5f);
    const Vec3f c = a + reach * in_plane * (random_point(random) - 0.5f);
    return std::array{a, b, c};
  });
}

TriangleMesh make_copies(int triangles) {
  return {{{0, 0, 0}, {1, 0, 0.25f}, {0.25f, 1, 0}},
          std::vector<Corners>(static_cast<std::size_t>(triangles), Corners{0, 1, 2})};
}

// ---- Terrain

namespace {

/// From -1 to 1 at the points of a lattice.
double lattice_height(std::uint64_t octave, std::uint64_t x, std::uint64_t y) {
  return 2 * Random((octave << 56) ^ (x << 28) ^ y).uniform_double() - 1;
}

/// Lattice heights, joined by curves that are level at the lattice points.
double noise(std::uint64_t octave, double x, double y) {
  const double column = std::floor(x), row = std::floor(y);
  const double u = x - column, v = y - row;
  const double across = u * u * (3 - 2 * u), along = v * v * (3 - 2 * v);
  const auto i = static_cast<std::uint64_t>(column), j = static_cast<std::uint64_t>(row);
  const auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
  return mix(mix(lattice_height(octave, i, j), lattice_height(octave, i + 1, j), across),
             mix(lattice_height(octave, i, j + 1), lattice_height(octave, i + 1, j + 1), across), along);
}

double terrain_height(double x, double y) {
  double height = 0, share = 0.15, frequency = 3;
  for (std::uint64_t octave = 0; octave < 10; ++octave) {
    height += share * noise(octave, frequency * x, frequency * y);
    share /= 2;
    frequency *= 2;
  }
  return height;
}

}  // namespace

TriangleMesh make_terrain(int cells) {
  std::vector<Vec3f> positions;
  std::vector<Corners> triangles;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const double x = double(column) / cells, z = double(row) / cells;
      positions.push_back(Vec3f(Vec3d(x, terrain_height(x, z), z)));
    }
  }
  const auto side = static_cast<std::uint32_t>(cells);
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 0; column < side; ++column) {
      const std::uint32_t a = row * (side + 1) + column, b = a + side + 1;
      triangles.push_back({a, b, b + 1});
      triangles.push_back({a, b + 1, a + 1});
    }
  }
  return {std::move(positions), std::move(triangles)};
}

// ---- Menger sponge

namespace {

/// Whether the cell of the sponge at (x, y, z) is solid: at no scale in the middle of two axes or more.
bool is_solid(std::array<int, 3> cell, int side) {
  for (const int x : cell) {
    if (x < 0 || x >= side) return false;
  }
  for (; side > 1; side /= 3) {
    int middles = 0;
    for (int& x : cell) {
      middles += x % 3 == 1;
      x /= 3;
    }
    if (middles > 1) return false;
  }
  return true;
}

}  // namespace

TriangleMesh make_menger(int level) {
  int side = 1;
  for (int i = 0; i < level; ++i) side *= 3;
  MeshBuilder builder;
  const auto corner = [side](const std::array<int, 3>& cell) {
    return Vec3f(cell[0], cell[1], cell[2]) / static_cast<float>(side);
  };
  for (int i = 0; i < side * side * side; ++i) {
    const std::array<int, 3> cell{i % side, i / side % side, i / (side * side)};
    if (!is_solid(cell, side)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int direction : {-1, 1}) {
        std::array<int, 3> beside = cell;
        beside[axis] += direction;
        if (is_solid(beside, side)) continue;
        std::array<int, 3> a = cell;
        a[axis] += direction > 0;
        std::array<int, 3> b = a, c = a, d = a;
        const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
        ++b[next], ++c[next], ++c[last], ++d[last];
        if (direction > 0) {
          builder.quad(corner(a), corner(b), corner(c), corner(d));
        } else {
          builder.quad(corner(a), corner(d), corner(c), corner(b));
        }
      }
    }
  }
  return builder.take();
}

// ---- Sphere flake

namespace {

void add_sphere(MeshBuilder& builder, const Vec3d& center, double radius) {
  constexpr int segments = 4;
  for (int octant = 0; octant < 8; ++octant) {
    const Vec3d sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
    const bool is_mirrored = sign.x * sign.y * sign.z < 0;
    const auto at = [&](int i, int k) {
      const Vec3d flat(segments - i - k, i, k);
      return Vec3f(center + radius * (sign * (flat / std::sqrt(glm::dot(flat, flat)))));
    };
    const auto add = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c) {
      is_mirrored ? builder.triangle(a, c, b) : builder.triangle(a, b, c);
    };
    for (int i = 0; i < segments; ++i) {
      for (int k = 0; i + k < segments; ++k) {
        add(at(i, k), at(i + 1, k), at(i, k + 1));
        if (i + k + 1 < segments) add(at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
      }
    }
  }
}

/// Six children around the equator and three toward `up`, which points away from the parent.
void add_flake(MeshBuilder& builder, const Vec3d& center, double radius, const Vec3d& up, int levels) {
  add_sphere(builder, center, radius);
  if (levels == 0) return;
  const Vec3d aside = std::fabs(up.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d u = glm::cross(up, aside) / std::sqrt(glm::dot(glm::cross(up, aside), glm::cross(up, aside)));
  const Vec3d v = glm::cross(up, u);
  const double half_root3 = 0.5 * std::numbers::sqrt3;
  const Vec3d around[6] = {u,  0.5 * u + half_root3 * v,  -0.5 * u + half_root3 * v,
                           -u, -0.5 * u - half_root3 * v, 0.5 * u - half_root3 * v};
  const double distance = radius + radius / 3;
  for (int i = 0; i < 6; ++i) {
    add_flake(builder, center + distance * around[i], radius / 3, around[i], levels - 1);
    if (i % 2 == 1) continue;
    const Vec3d raised = 0.5 * around[i] + half_root3 * up;
    add_flake(builder, center + distance * raised, radius / 3, raised, levels - 1);
  }
}

}  // namespace

TriangleMesh make_sphere_flake(int levels) {
  MeshBuilder builder;
  add_flake(builder, Vec3d(0), 1, Vec3d(0, 1, 0), levels);
  return builder.take();
}

}  // namespace sightline
