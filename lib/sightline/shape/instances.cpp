#include "sightline/shape/instances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "sightline/math/transform.h"

namespace sightline {
namespace {

[[noreturn]] void refuse(std::size_t placement, const std::string& expected) {
  throw std::invalid_argument("instance " + std::to_string(placement) + ": expected " + expected);
}

/// Of a map of floats: each of the six products is off by less than two roundings, and the sum by five more.
int sign_of_determinant(const Affine& map) {
  const Vec3d a = map.column(0), b = map.column(1), c = map.column(2);
  const double determinant = glm::dot(a, glm::cross(b, c));
  const Vec3d size(std::fabs(b.y * c.z) + std::fabs(b.z * c.y), std::fabs(b.z * c.x) + std::fabs(b.x * c.z),
                   std::fabs(b.x * c.y) + std::fabs(b.y * c.x));
  const double bound = 0x1p-49 * glm::dot(glm::abs(a), size);
  // Products of three floats neither overflow nor underflow.
  if (std::fabs(determinant) > bound) return determinant > 0 ? 1 : -1;
  return determinant_sign(map);
}

}  // namespace

Placement::Placement(const Affine& to_world, std::uint32_t mesh) : mesh_(mesh) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < 4; ++k) rows_[axis][k] = static_cast<float>(to_world.rows[axis][k]);
  }
  const Affine rounded = this->to_world();
  is_mirroring_ = is_finite(rounded) && sign_of_determinant(rounded) < 0;
}

Affine Placement::to_world() const {
  Affine map;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < 4; ++k) map.rows[axis][k] = rows_[axis][k];
  }
  return map;
}

/// I1 is monotone in each coordinate, roundings included, so that corners of the box are placed farthest.
Aabb Placement::bounds(const Aabb& local) const {
  if (local.is_empty()) return {};
  const auto farthest = [&](std::size_t axis, bool is_upper) {
    Vec3f corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<int>(k);
      corner[i] = (rows_[axis][k] > 0) == is_upper ? local.hi[i] : local.lo[i];
    }
    return coordinate(corner, axis);
  };
  return {{farthest(0, false), farthest(1, false), farthest(2, false)},
          {farthest(0, true), farthest(1, true), farthest(2, true)}};
}

/// Instances are looked at in the order of how far their boxes reach, until none reaches beyond what was found.
float Instances::farthest(std::span<const Aabb> boxes, int axis, bool is_upper) const {
  const float sign = is_upper ? 1.0f : -1.0f;
  const auto reach = [&](std::uint32_t i) { return sign * (is_upper ? boxes[i].hi : boxes[i].lo)[axis]; };
  const auto is_nearer = [&](std::uint32_t a, std::uint32_t b) { return reach(a) < reach(b); };
  std::vector<std::uint32_t> heap(size());
  std::iota(heap.begin(), heap.end(), 0u);
  std::make_heap(heap.begin(), heap.end(), is_nearer);
  float found = -std::numeric_limits<float>::infinity();
  while (!heap.empty() && reach(heap.front()) > found) {
    for (const Vec3f& p : mesh_of(heap.front()).positions()) {
      found = std::max(found, sign * placements_[heap.front()].coordinate(p, static_cast<std::size_t>(axis)));
    }
    std::pop_heap(heap.begin(), heap.end(), is_nearer);
    heap.pop_back();
  }
  return sign * found;
}

std::string_view missing_of(const Placement& placement, const TriangleMesh& mesh) {
  const Affine map = placement.to_world();
  if (!is_finite(map)) return "a matrix of numbers that are finite in float";
  if (sign_of_determinant(map) == 0) return "a matrix that can be inverted in float";
  if (mesh.size() == 0) return "a mesh that has triangles";
  const Aabb box = placement.bounds(mesh.bounds());
  if (!is_finite(box.lo) || !is_finite(box.hi)) return "vertices within the range of float";
  return {};
}

Instances::Instances(std::vector<std::shared_ptr<const TriangleMesh>> meshes, std::vector<Placement> placements)
    : meshes_(std::move(meshes)), placements_(std::move(placements)) {
  std::vector<Aabb> boxes(placements_.size());
  for (std::size_t i = 0; i < placements_.size(); ++i) {
    const Placement& placement = placements_[i];
    if (placement.mesh() >= meshes_.size()) refuse(i, "a mesh below " + std::to_string(meshes_.size()));
    const TriangleMesh& mesh = *meshes_[placement.mesh()];
    if (const std::string_view missing = missing_of(placement, mesh); !missing.empty()) refuse(i, std::string(missing));
    boxes[i] = placement.bounds(mesh.bounds());
    triangles_ += mesh.size();
  }
  for (int axis = 0; axis < 3; ++axis) {
    bounds_.lo[axis] = farthest(boxes, axis, false);
    bounds_.hi[axis] = farthest(boxes, axis, true);
  }
}

bool Instances::have_moved_to(const Instances& others) const {
  if (size() != others.size()) return false;
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (&mesh_of(i) != &others.mesh_of(i)) return false;
  }
  return true;
}

TriangleMesh Instances::flattened(std::uint64_t most) const {
  std::uint64_t vertices = 0;
  for (const Placement& placement : placements_) vertices += meshes_[placement.mesh()]->positions().size();
  if (triangles_ > most || vertices > most) {
    throw std::length_error("expected at most " + std::to_string(most) +
                            " triangles and vertices of all instances, found " + std::to_string(triangles_) + " and " +
                            std::to_string(vertices));
  }
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  positions.reserve(vertices);
  triangles.reserve(triangles_);
  for (const Placement& placement : placements_) {
    const TriangleMesh& mesh = *meshes_[placement.mesh()];
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const Vec3f& p : mesh.positions()) positions.push_back(placement.point(p));
    for (const auto& [a, b, c] : mesh.triangles()) {
      if (placement.is_mirroring()) {
        triangles.push_back({first + a, first + c, first + b});  // I2
      } else {
        triangles.push_back({first + a, first + b, first + c});
      }
    }
  }
  return {std::move(positions), std::move(triangles)};
}

}  // namespace sightline
