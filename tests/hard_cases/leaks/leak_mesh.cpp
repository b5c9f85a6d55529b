#include "tests/hard_cases/leaks/leak_mesh.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "tests/hard_cases/leaks/closed_seeds.h"

namespace sightline::hard {
namespace {

constexpr std::size_t inside_count = 12;
constexpr int most_tries = 4000;

double segment_distance(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const Vec3d way = b - a;
  const double length2 = glm::dot(way, way);
  const double share = length2 > 0 ? std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : 0;
  return glm::length(p - (a + share * way));
}

/// To the plane where the point's foot is in the triangle, else to the nearest edge; too small rather than too large.
double triangle_distance(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double to_edges = std::min({segment_distance(p, a, b), segment_distance(p, b, c), segment_distance(p, c, a)});
  const Vec3d normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  if (!(length > 0)) return to_edges;
  const auto is_beside = [&](const Vec3d& from, const Vec3d& to) {
    return glm::dot(glm::cross(to - from, p - from), normal) < 0;
  };
  if (is_beside(a, b) || is_beside(b, c) || is_beside(c, a)) return to_edges;
  return std::min(to_edges, std::fabs(glm::dot(p - a, normal)) / length);
}

}  // namespace

LeakMesh::LeakMesh(std::string name, const MeshSeed& seed, const Placement& placement)
    : name_(std::move(name)), on_lattice_(placement.lattice > 0) {
  if (!is_closed(seed)) throw std::logic_error(name_ + ": expected a closed mesh, found an open edge");
  std::vector<Vec3f> positions;
  for (const Vec3d& p : seed.vertices) {
    const Vec3d rounded = on_lattice_ ? placement.lattice * glm::round(p / placement.lattice) : p;
    positions.emplace_back(placement.center + placement.scale * rounded);
  }
  mesh_ = std::make_shared<const TriangleMesh>(std::move(positions), seed.triangles);
  reach_ = max_norm(Vec3d(mesh_->bounds().hi) - Vec3d(mesh_->bounds().lo));
  step_ = placement.scale * placement.lattice;
  find_inside(Random::hash(seed.triangles.size()));
}

/// Rounding moves a ray's end by less than `least`: that of the origin counts for at most once, that of the direction
/// for at most twice; each is at most 2^-24 of numbers below the coordinates and four reaches, along each axis.
void LeakMesh::find_inside(std::uint64_t seed) {
  const Vec3d lo(mesh_->bounds().lo), hi(mesh_->bounds().hi);
  const double least = 0x1p-20 * (std::max(max_norm(lo), max_norm(hi)) + 4 * reach_);
  Random random(seed);
  for (int i = 0; i < most_tries && inside_.size() < inside_count; ++i) {
    const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
    Vec3d point = lo + Vec3d(x, y, z) * (hi - lo);
    if (on_lattice_) point = step_ * glm::round(point / step_);
    point = Vec3d(Vec3f(point));
    if (!(clearance(point) > std::max(least, 0x1p-7 * reach_))) continue;
    const double times = winding(point);
    if (!(std::fabs(times - std::round(times)) < 0x1p-10))
      throw std::logic_error(name_ + ": a winding number in doubt");
    if (std::round(times) != 0) inside_.push_back(point);
  }
  if (inside_.empty()) throw std::logic_error(name_ + ": expected an inside, found none that is wide enough");
}

double LeakMesh::clearance(const Vec3d& point) const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh_->triangles()) {
    least = std::min(least, triangle_distance(point, Vec3d(mesh_->positions()[a]), Vec3d(mesh_->positions()[b]),
                                              Vec3d(mesh_->positions()[c])));
  }
  return 0.99 * least;
}

/// Van Oosterom and Strackee, "The Solid Angle of a Plane Triangle", 1983.
double LeakMesh::winding(const Vec3d& point) const {
  double sum = 0;
  for (const auto& corners : mesh_->triangles()) {
    const Vec3d a = Vec3d(mesh_->positions()[corners[0]]) - point, b = Vec3d(mesh_->positions()[corners[1]]) - point,
                c = Vec3d(mesh_->positions()[corners[2]]) - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double across = glm::dot(a, glm::cross(b, c));
    const double along = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    sum += 2 * std::atan2(across, along);
  }
  return sum / (4 * std::numbers::pi);
}

}  // namespace sightline::hard
