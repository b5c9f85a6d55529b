#include "sightline/shape/closed_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "tests/shape/closed_mesh_seeds.h"
#include "tests/shape/rational_geometry.h"

namespace sightline {
namespace {

using Passages = std::map<std::uint32_t, bool>;  // triangle, enters

ClosedMesh made(const MeshSeed& seed) { return {seed.vertices, seed.triangles}; }

Passages passages_of(const ClosedMesh& mesh, const Ray<double>& ray, const Frame* frame = nullptr) {
  Passages found;
  std::uint32_t next = 0;
  mesh.passages(FramedRay(ray, frame), [&](std::uint32_t id, bool enters) {
    EXPECT_GE(id, next) << "out of order";
    next = id + 1;
    found[id] = enters;
  });
  return found;
}

using Integer = boost::multiprecision::cpp_int;

struct Whole {
  Integer x, y, z;

  Integer& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
};
Whole operator-(const Whole& p, const Whole& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
Whole operator+(const Whole& p, const Whole& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
Whole operator*(const Integer& s, const Whole& p) { return {s * p.x, s * p.y, s * p.z}; }
Integer dot(const Whole& p, const Whole& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
Whole cross(const Whole& p, const Whole& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

/// All coordinates as multiples of 2^-bits.
Whole whole(const ExactVector& v, unsigned bits) {
  const auto of = [&](const Rational& x) {
    const Rational scaled = x * (Integer(1) << bits);
    EXPECT_EQ(denominator(scaled), 1);
    return Integer(numerator(scaled));
  };
  return {of(v.x), of(v.y), of(v.z)};
}

struct WholeLine {
  Whole origin, direction;
};

/// Where the line goes through the triangle's plane, and then on which sides of its edges: the open triangle, which a
/// line that has been moved aside passes or misses, but never touches.
std::optional<bool> moved_passage(const WholeLine& line, const Whole& a, const Whole& b, const Whole& c) {
  const Whole normal = cross(b - a, c - a);
  const Integer slope = dot(normal, line.direction);
  if (slope == 0) return std::nullopt;
  const auto side = [&](const Whole& from, const Whole& to) {  // times the slope
    const Whole p = slope * (line.origin - from) + dot(normal, a - line.origin) * line.direction;
    return Integer(dot(cross(to - from, p), normal) * slope.sign());
  };
  for (const Integer& each : {side(a, b), side(b, c), side(c, a)}) {
    if (each < 0) return std::nullopt;
    EXPECT_NE(each, 0) << "not moved far enough";
  }
  return slope < 0;
}

/// By 2^-bits / 2 and its square, which is so small that nothing else is smaller.
WholeLine moved(const ExactLine& line, unsigned bits) {
  const Vec3d size(abs(line.direction.x).convert_to<double>(), abs(line.direction.y).convert_to<double>(),
                   abs(line.direction.z).convert_to<double>());
  const int largest = largest_axis(size);
  WholeLine moved{whole(line.origin, bits), whole(line.direction, bits)};
  moved.origin[(largest + 1) % 3] += Integer(1) << (bits / 2);
  moved.origin[(largest + 2) % 3] += 1;
  return moved;
}

/// Compares with the oracle, and counts.
void expect_exact(const ClosedMesh& mesh, const Ray<double>& ray, int& passed, const Frame* frame = nullptr,
                  unsigned bits = 800) {
  const Passages found = passages_of(mesh, ray, frame);
  const WholeLine line = moved(exact(ray, frame ? *frame : Frame()), bits);
  std::vector<Whole> vertices;
  for (const Vec3d& p : mesh.vertices()) vertices.push_back(whole(exact(p), bits));
  int balance = 0;
  for (std::uint32_t id = 0; id < mesh.size(); ++id) {
    const auto [a, b, c] = mesh.triangles()[id];
    const auto expected = moved_passage(line, vertices[a], vertices[b], vertices[c]);
    const auto at = found.find(id);
    ASSERT_EQ(expected.has_value(), at != found.end()) << "triangle " << id;
    if (!expected) continue;
    ASSERT_EQ(*expected, at->second) << "triangle " << id;
    balance += *expected ? 1 : -1;
    ++passed;
  }
  ASSERT_EQ(balance, 0);
}

Vec3d lattice_point(Random& random, std::uint32_t size) {
  const auto x = random.below(size), y = random.below(size), z = random.below(size);
  return {double(x), double(y), double(z)};
}
Vec3d any_point(Random& random, double size) {
  const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
  return size * (2.0 * Vec3d(x, y, z) - 1.0);
}

TEST(ClosedMesh, RayFromTheMiddleOfAnOctahedronLeavesOnce) {
  const ClosedMesh mesh = made(octahedron());
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Passages found = passages_of(mesh, {Vec3d(0), Vec3d(x, y, z)});
        ASSERT_EQ(found.size(), 2u) << x << y << z;
        EXPECT_NE(found.begin()->second, found.rbegin()->second);
      }
    }
  }
}

TEST(ClosedMesh, CubeIsExactThroughAllItsLatticePoints) {
  const ClosedMesh mesh = made(cube());
  int passed = 0;
  for (int from = 0; from < 125; ++from) {
    for (int to = 0; to < 125; ++to) {
      const auto point = [](int i) { return 0.5 * Vec3d(i % 5, i / 5 % 5, i / 25) - Vec3d(1); };
      if (from == to || (from * 125 + to) % 7 != 0) continue;
      expect_exact(mesh, {point(from), point(to) - point(from)}, passed, nullptr, 80);
      if (HasFatalFailure()) FAIL() << from << " to " << to;
    }
  }
  EXPECT_GT(passed, 1000);
}

TEST(ClosedMesh, IsExactOnTheLattice) {
  Random random(1);
  int passed = 0;
  for (int i = 0; i < 200; ++i) {
    const ClosedMesh mesh = made(folded(random.below(30), random, [&] { return lattice_point(random, 5); }));
    for (int k = 0; k < 12; ++k) {
      const Vec3d from = lattice_point(random, 5);
      const Ray<double> ray{from, lattice_point(random, 5) - from};
      expect_exact(mesh, ray, passed, nullptr, 80);  // no direction at all among the others
      if (HasFatalFailure()) FAIL() << "mesh " << i << " ray " << k;
    }
  }
  EXPECT_GT(passed, 2500);
}

TEST(ClosedMesh, IsExactWhereRaysAreAimedAtEdgesAndVertices) {
  Random random(2);
  int passed = 0;
  for (int i = 0; i < 40; ++i) {
    const double size = i % 3 == 0 ? 1 : i % 3 == 1 ? 1e-6 : 1e5;
    const Vec3d offset = i % 2 == 0 ? Vec3d(0) : Vec3d(148376, 1234, -223423);
    const MeshSeed seed = i % 5 == 0 ? double_fan(16) : folded(12, random, [&] { return any_point(random, 1); });
    MeshSeed scaled = seed;
    for (Vec3d& p : scaled.vertices) p = size * p + offset;
    const ClosedMesh mesh = made(scaled);
    for (int k = 0; k < 25; ++k) {
      const auto [a, b, c] = mesh.facet(random.below(mesh.size())).vertices;
      const double share = k % 4 == 0 ? 0 : random.uniform_double();
      const Vec3d target = a + share * (b - a);
      const Vec3d from = offset + any_point(random, 3 * size);
      expect_exact(mesh, {from, k % 8 == 1 ? b - a : target - from}, passed);
      if (HasFatalFailure()) FAIL() << "mesh " << i << " ray " << k;
    }
  }
  EXPECT_GT(passed, 1000);
}

TEST(ClosedMesh, IsExactInFrames) {
  Random random(3);
  int passed = 0;
  for (int i = 0; i < 200; ++i) {
    Frame frame;
    for (auto& row : frame.rows) {
      for (double& x : row) x = i % 2 == 0 ? 0.25 * random.below(9) - 1 : 3 * random.uniform_double() - 1.5;
    }
    const ClosedMesh mesh = made(folded(10, random, [&] { return lattice_point(random, 4); }));
    for (int k = 0; k < 10; ++k) {
      const Vec3d from = lattice_point(random, 5);
      expect_exact(mesh, {from, lattice_point(random, 5) - from}, passed, &frame, i % 2 == 0 ? 80 : 800);
      if (HasFatalFailure()) FAIL() << "mesh " << i << " ray " << k;
    }
  }
  EXPECT_GT(passed, 500);
}

TEST(ClosedMesh, IsExactHoweverLargeOrSmall) {
  Random random(4);
  int passed = 0;
  for (const double size : {1e-4, 1e-12, 1e-30, 1e-60, 1e-150, 1e-300, 5e-324, 1e20, 1e60, 1e150, 1e300}) {
    MeshSeed seed = octahedron();
    for (Vec3d& p : seed.vertices) p *= size;
    const ClosedMesh mesh = made(seed);
    const int before = passed;
    for (int k = 0; k < 8; ++k) {
      const Vec3d from = size * Vec3d(double(random.below(5)) - 2, double(random.below(5)) - 2, -3);
      const Vec3d to = k % 2 == 0 ? size * any_point(random, 1) : seed.vertices[random.below(6)];
      expect_exact(mesh, {from, to - from}, passed, nullptr, 8000);
      expect_exact(mesh, {from, Vec3d(0, 0, 1)}, passed, nullptr, 8000);
      if (HasFatalFailure()) FAIL() << size;
    }
    EXPECT_GT(passed, before) << size;
  }
}

TEST(ClosedMesh, SliversOfEveryAspectAreExact) {
  Random random(5);
  int passed = 0;
  for (int power = 1; power <= 50; power += 3) {
    for (int i = 0; i < 10; ++i) {
      const Vec3d a = any_point(random, 1), b = any_point(random, 1);
      const auto near = [&] { return 0.5 * (a + b) + std::ldexp(1., -power) * any_point(random, 1); };
      const ClosedMesh mesh({a, b, near(), near()}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
      const auto [p, q, r] = mesh.facet(random.below(4)).vertices;
      const Vec3d from = any_point(random, 4);
      expect_exact(mesh, {from, (p + q + r) / 3. - from}, passed);
      if (HasFatalFailure()) FAIL() << "aspect 2^" << power;
    }
  }
  EXPECT_GT(passed, 100);
}

TEST(ClosedMesh, RayInAFaceGoesThroughOthersOnly) {
  const ClosedMesh mesh = made(cube());
  int passed = 0;
  for (const Vec3d& direction : {Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0), Vec3d(2, 1, 0)}) {
    for (const double z : {-1., 1.}) {
      expect_exact(mesh, {Vec3d(0.25, 0.5, z), direction}, passed);
      expect_exact(mesh, {Vec3d(1, 1, z), direction}, passed);
    }
  }
}

TEST(ClosedMesh, BoundsContainEveryVertex) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const double size = std::ldexp(1., static_cast<int>(random.below(2000)) - 1000);
    const ClosedMesh mesh = made(folded(5, random, [&] { return any_point(random, size); }));
    const Aabb bounds = mesh.bounds();
    for (const Vec3d& p : mesh.vertices()) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(double(bounds.lo[axis]), p[axis]);
        EXPECT_GE(double(bounds.hi[axis]), p[axis]);
      }
    }
  }
}

std::string refusal(const MeshSeed& seed) {
  try {
    made(seed);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ClosedMesh, RefusesWhatIsNotClosed) {
  EXPECT_EQ(refusal({{}, {}}), "closed mesh: expected triangles, found none");
  MeshSeed seed = cube();
  seed.vertices[3].y = std::nan("");
  EXPECT_EQ(refusal(seed), "closed mesh: vertex 3: expected finite numbers");
  seed = cube();
  seed.triangles[4][1] = 8;
  EXPECT_EQ(refusal(seed), "closed mesh: triangle 4: expected vertices below 8, found 8");
  seed = cube();
  seed.triangles.pop_back();
  EXPECT_EQ(refusal(seed),
            "closed mesh: triangle 3: expected its edge from vertex 5 to 7 to be another triangle's from 7 to 5, "
            "found it open");
  seed = cube();
  std::swap(seed.triangles[2][0], seed.triangles[2][1]);
  EXPECT_NE(refusal(seed), "accepted");
  seed = cube();
  seed.triangles.push_back(seed.triangles[0]);
  EXPECT_NE(refusal(seed), "accepted");
  seed = cube();
  seed.triangles.insert(seed.triangles.end(), {{0, 1, 2}, {2, 1, 0}, {4, 4, 5}, {4, 5, 4}});
  EXPECT_EQ(refusal(seed), "accepted") << "folded flat, and without area";
  MeshSeed apart;
  for (const auto& triangle : cube().triangles) {
    const auto first = static_cast<std::uint32_t>(apart.vertices.size());
    for (const std::uint32_t corner : triangle) apart.vertices.push_back(cube().vertices[corner]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(refusal(apart), "accepted") << "vertices at one place count as one";
}

}  // namespace
}  // namespace sightline
