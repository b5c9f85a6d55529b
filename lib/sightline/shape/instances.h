#pragma once
/// Meshes that stand in many places.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "sightline/math/affine.h"
#include "sightline/shape/mesh.h"

namespace sightline {

/// Where an instance of a mesh stands: a map to the world, rounded to float once.
///   I1  A vertex stands at what double makes of the map, from left to right, rounded to float. Products of floats are
///       exact in double, so there are as many roundings with and without fused multiply-add, and all that place
///       vertices agree bit for bit.
///   I2  Where the map mirrors, triangles are listed with their second and third vertex exchanged, so that outside
///       stays outside. Weights u and v of hits are those of the listed vertices.
class Placement {
 public:
  Placement() = default;
  Placement(const Affine& to_world, std::uint32_t mesh);

  std::uint32_t mesh() const { return mesh_; }
  bool is_mirroring() const { return is_mirroring_; }  ///< I2
  /// Of the map, three for the linear part, then the translation.
  const std::array<float, 4>& row(std::size_t axis) const { return rows_[axis]; }
  /// Exactly what the floats say.
  Affine to_world() const;

  float coordinate(const Vec3f& p, std::size_t axis) const {  // I1
    const auto& r = rows_[axis];
    return static_cast<float>(double(r[0]) * p.x + double(r[1]) * p.y + double(r[2]) * p.z + r[3]);
  }
  Vec3f point(const Vec3f& p) const { return {coordinate(p, 0), coordinate(p, 1), coordinate(p, 2)}; }

  Triangle triangle(const Triangle& local) const {
    const Triangle placed{point(local.a), point(local.b), point(local.c)};
    return is_mirroring_ ? Triangle{placed.a, placed.c, placed.b} : placed;
  }

  /// Holds the image of all points of a box, as I1 places them.
  Aabb bounds(const Aabb& local) const;

 private:
  std::array<std::array<float, 4>, 3> rows_{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  std::uint32_t mesh_ : 31 = 0;
  std::uint32_t is_mirroring_ : 1 = 0;
};
static_assert(sizeof(Placement) == 52);

/// What a placement of a mesh lacks, such as "a matrix that can be inverted in float"; empty where it lacks nothing.
std::string_view missing_of(const Placement& placement, const TriangleMesh& mesh);

/// Immutable. Instances have the order of their placements, triangles of all instances that of instances first.
class Instances {
 public:
  Instances() = default;
  /// \throws std::invalid_argument naming the placement where one is not finite in float, singular there, or of no mesh
  /// of the list, or places a vertex beyond the range of float.
  Instances(std::vector<std::shared_ptr<const TriangleMesh>> meshes, std::vector<Placement> placements);

  std::uint32_t size() const { return static_cast<std::uint32_t>(placements_.size()); }
  std::span<const Placement> placements() const { return placements_; }
  std::span<const std::shared_ptr<const TriangleMesh>> meshes() const { return meshes_; }
  const TriangleMesh& mesh_of(std::uint32_t instance) const { return *meshes_[placements_[instance].mesh()]; }

  /// Whether these and others are as many, and each of the same mesh: then they differ in their places alone.
  bool have_moved_to(const Instances& others) const;

  /// Of all instances.
  std::uint64_t triangles() const { return triangles_; }
  /// Holds the instance.
  Aabb bounds(std::uint32_t instance) const { return placements_[instance].bounds(mesh_of(instance).bounds()); }
  /// Of all vertices where they stand: those of the flattened mesh.
  const Aabb& bounds() const { return bounds_; }

  /// In the world.
  Triangle triangle(std::uint32_t instance, std::uint32_t id) const {
    return placements_[instance].triangle(mesh_of(instance)[id]);
  }

  /// One mesh of all triangles where they stand; its ids count the triangles of all instances.
  /// \throws std::length_error where there are more triangles or vertices than `most`.
  TriangleMesh flattened(std::uint64_t most = std::uint64_t{1} << 27) const;

 private:
  /// Over all vertices where they stand; `boxes` hold the instances.
  float farthest(std::span<const Aabb> boxes, int axis, bool is_upper) const;

  std::vector<std::shared_ptr<const TriangleMesh>> meshes_;
  std::vector<Placement> placements_;
  std::uint64_t triangles_ = 0;
  Aabb bounds_;
};

}  // namespace sightline
