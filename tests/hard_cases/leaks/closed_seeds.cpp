#include "tests/hard_cases/leaks/closed_seeds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "sightline/io/file_error.h"
#include "sightline/scene/scenes.h"

namespace sightline::hard {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
constexpr double pi = std::numbers::pi;

MeshSeed icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  MeshSeed seed{{{-1, g, 0},
                 {1, g, 0},
                 {-1, -g, 0},
                 {1, -g, 0},
                 {0, -1, g},
                 {0, 1, g},
                 {0, -1, -g},
                 {0, 1, -g},
                 {g, 0, -1},
                 {g, 0, 1},
                 {-g, 0, -1},
                 {-g, 0, 1}},
                {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (Vec3d& p : seed.vertices) p = glm::normalize(p);
  return seed;
}

using Whole = std::array<std::int64_t, 3>;

/// Six times the volume of the tetrahedron a, b, c, d: exact, of numbers up to 2^18.
std::int64_t volume(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  const auto from_a = [&](const Whole& p, std::size_t i) { return p[i] - a[i]; };
  const auto minor = [&](std::size_t i, std::size_t k) {
    return from_a(c, i) * from_a(d, k) - from_a(c, k) * from_a(d, i);
  };
  return from_a(b, 0) * minor(1, 2) + from_a(b, 1) * minor(2, 0) + from_a(b, 2) * minor(0, 1);
}

/// The triangles of a scene, without copies of vertices, in a box from -1 to 1.
MeshSeed seed_of(const TriangleMesh& mesh) {
  MeshSeed seed;
  std::map<std::array<float, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> place;
  const Vec3d lo(mesh.bounds().lo), hi(mesh.bounds().hi);
  const double size = 0.5 * max_norm(hi - lo);
  for (const Vec3f& p : mesh.positions()) {
    const auto [at, is_new] = places.emplace(std::array{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}, seed.vertices.size());
    if (is_new) seed.vertices.push_back((Vec3d(p) - 0.5 * (lo + hi)) / size);
    place.push_back(at->second);
  }
  for (const auto& [a, b, c] : mesh.triangles()) seed.triangles.push_back({place[a], place[b], place[c]});
  return seed;
}

}  // namespace

MeshSeed icosphere(int times) {
  MeshSeed seed = icosahedron();
  for (; times > 0; --times) {
    std::map<Edge, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] =
          middles.emplace(Edge(std::min(a, b), std::max(a, b)), static_cast<std::uint32_t>(seed.vertices.size()));
      if (is_new) seed.vertices.push_back(glm::normalize(seed.vertices[a] + seed.vertices[b]));
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> parts;
    for (const auto& [a, b, c] : std::vector(seed.triangles)) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    seed.triangles = std::move(parts);
  }
  return seed;
}

MeshSeed uv_sphere(std::uint32_t around, std::uint32_t rings) {
  MeshSeed seed{{{0, 0, 1}, {0, 0, -1}}, {}};
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    const double needle = 0x1p-10;
    const double polar = ring == 0 ? needle : ring + 1 == rings ? pi - needle : pi * ring / (rings - 1);
    for (std::uint32_t i = 0; i < around; ++i) {
      const double angle = 2 * pi * i / around, radius = std::sin(polar);
      seed.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), std::cos(polar));
    }
  }
  const auto at = [&](std::uint32_t ring, std::uint32_t i) { return 2 + ring * around + i % around; };
  for (std::uint32_t i = 0; i < around; ++i) {
    seed.triangles.push_back({0, at(0, i), at(0, i + 1)});
    seed.triangles.push_back({1, at(rings - 1, i + 1), at(rings - 1, i)});
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      seed.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      seed.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  return seed;
}

MeshSeed random_hull(std::uint32_t points, std::uint64_t seed) {
  Random random(seed);
  std::vector<Whole> places;
  while (places.size() < points) {
    Vec3d p(2 * random.uniform_double() - 1, 0, 0);
    p.y = 2 * random.uniform_double() - 1, p.z = 2 * random.uniform_double() - 1;
    if (!(glm::dot(p, p) > 0.01 && glm::dot(p, p) <= 1)) continue;
    const Vec3d q = 4096.0 * glm::normalize(p);
    places.push_back({std::llround(q.x), std::llround(q.y), std::llround(q.z)});
  }
  const std::int64_t first = volume(places[0], places[1], places[2], places[3]);
  if (first == 0) throw std::logic_error("random hull: expected a seed whose first points are in no plane");
  if (first > 0) std::swap(places[0], places[1]);  // then each face below sees the fourth point behind it
  MeshSeed hull{{}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
  for (std::uint32_t p = 4; p < points; ++p) {
    std::set<Edge> horizon;
    std::erase_if(hull.triangles, [&](const auto& t) {
      if (volume(places[t[0]], places[t[1]], places[t[2]], places[p]) <= 0) return false;
      for (const Edge& edge : {Edge(t[0], t[1]), Edge(t[1], t[2]), Edge(t[2], t[0])}) {
        if (horizon.erase({edge.second, edge.first}) == 0) horizon.insert(edge);
      }
      return true;
    });
    for (const auto& [a, b] : horizon) hull.triangles.push_back({a, b, p});
  }
  for (const auto& [x, y, z] : places) hull.vertices.push_back(Vec3d(double(x), double(y), double(z)) / 4096.0);
  return hull;
}

MeshSeed sliver_torus(std::uint32_t around, std::uint32_t across) {
  MeshSeed seed;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = 2 * pi * i / around;
    for (std::uint32_t k = 0; k < across; ++k) {
      const double turn = 2 * pi * k / across + angle, radius = 0.7 + 0.3 * std::cos(turn);
      seed.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.3 * std::sin(turn));
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t k) {
    const std::uint32_t seam = i == around ? 0 : i;  // the turns of a whole round are one
    return seam * across + k % across;
  };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < across; ++k) {
      seed.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      seed.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return seed;
}

bool is_closed(const MeshSeed& mesh) {
  std::map<Edge, int> balance;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (a != b) balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return std::ranges::all_of(balance, [](const auto& edge) { return edge.second == 0; });
}

std::vector<NamedSeed> closed_seeds(const std::filesystem::path& data_dir) {
  Random random(7);
  const auto anywhere = [&] {
    const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
    return 2.0 * Vec3d(x, y, z) - 1.0;
  };
  std::vector<NamedSeed> seeds{{"octahedron", octahedron()},
                               {"cube", cube()},
                               {"double-fan", double_fan(16)},
                               {"folded", folded(60, random, anywhere)},
                               {"icosphere", icosphere(3)},
                               {"uv-sphere", uv_sphere(48, 24)},
                               {"hull-1", random_hull(100, 1)},
                               {"hull-2", random_hull(600, 2)},
                               {"sliver-torus", sliver_torus(400, 3)},
                               {"menger", seed_of(*load_scene("menger:2", data_dir))}};
  try {
    seeds.push_back({"dragon", seed_of(*load_scene("dragon:4", data_dir))});
  } catch (const FileError&) {  // it was not fetched
  }
  return seeds;
}

}  // namespace sightline::hard
