#pragma once
/// Closed meshes with points that are surely inside, and rays of which is known that they must hit.
///
/// A segment between a point that the surface winds around and one that it does not wind around meets the surface. A
/// test that makes the true decision about every closed triangle with an area that is not seen edge-on cannot miss it:
/// triangles that the line lies in, or without area, end at others, and the line leaves them there, for at the
/// segment's ends there is no surface. So a segment without a hit is a leak, whatever it was aimed at.
///   L1  Winding numbers are sums of solid angles, which are 4 pi times a whole number in real arithmetic. No inside
///       point is nearer to the surface than its clearance, so no angle is lost to cancellation; a sum that is not
///       within 2^-10 of a whole number is refused.
///   L2  A ray towards the inside ends within the clearance of an inside point, where the surface winds as often.
///   L3  What is outside is beyond the bounds of all vertices.

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/shape/mesh.h"
#include "tests/shape/closed_mesh_seeds.h"

namespace sightline::hard {

/// Where a mesh of unit size stands, and how its numbers are rounded.
struct Placement {
  std::string name;
  double scale = 1;
  Vec3d center{0};
  double lattice = 0;  ///< Vertices are multiples of this share of the scale; 0: of what a float can tell.
};

class LeakMesh {
 public:
  /// \throws std::logic_error where the mesh is open, or has no inside that is wide enough for what floats tell apart.
  LeakMesh(std::string name, const MeshSeed& seed, const Placement& placement);

  const std::string& name() const { return name_; }
  const std::shared_ptr<const TriangleMesh>& mesh() const { return mesh_; }
  const std::vector<Vec3d>& inside() const { return inside_; }
  bool is_on_lattice() const { return on_lattice_; }

  /// What rays aim at.
  enum class Aim { edges, vertices, both };

  /// Sixteen rays to the triangles from a random one on, from one inside point or towards it. The same arguments give
  /// the same rays. Where vertices and inside points are on a lattice, rays go through points of edges and vertices
  /// exactly, unless they are to pass up to `beside` from those along each axis.
  static constexpr std::uint32_t group_size = 16;
  template <class T>
  void rays(std::uint64_t seed, std::uint64_t group, Ray<T>* rays, Aim aim = Aim::both, double beside = 0) const {
    Random random(Random::hash(seed) + group);
    const Vec3d from = inside_[random.below(static_cast<std::uint32_t>(inside_.size()))];
    const bool goes_out = random.below(2) == 0;
    const std::uint32_t first = random.below(mesh_->size());
    for (std::uint32_t i = 0; i < group_size; ++i) {
      const auto& corners = mesh_->triangles()[(first + i / 4) % mesh_->size()];
      const Vec3d a(mesh_->positions()[corners[i % 3]]), b(mesh_->positions()[corners[(i + 1) % 3]]);
      const bool is_vertex = aim == Aim::vertices || (aim == Aim::both && i % 4 == 3);
      Vec3d target = is_vertex ? a : a + share_of(random) * (b - a);
      if (beside > 0) {
        for (int axis = 0; axis < 3; ++axis) target[axis] += beside * (2 * random.uniform_double() - 1);
      }
      rays[i] = goes_out ? outward<T>(from, target) : inward<T>(from, target);
    }
  }

  /// How often the surface winds around the point.
  double winding(const Vec3d& point) const;
  /// A lower bound of the way from the point to the surface.
  double clearance(const Vec3d& point) const;

 private:
  /// On a lattice quarters, so that points of edges have two bits more than vertices.
  double share_of(Random& random) const { return on_lattice_ ? 0.25 * (1 + random.below(3)) : random.uniform_double(); }

  template <class T>
  Ray<T> outward(const Vec3d& from, const Vec3d& target) const {
    return {Vec3<T>(from), Vec3<T>(target - from)};
  }

  /// From beyond the target to the inside point, where it ends (L2).
  ///   It begins 2^k times the way farther on, out of the bounds (L3), and so the end is at 1 + 2^-k.
  template <class T>
  Ray<T> inward(const Vec3d& to, const Vec3d& target) const {
    const Vec3d way = target - to;
    const double factor = std::ldexp(1.0, std::max(0, std::ilogb(reach_ / max_norm(way)) + 1));
    const Vec3<T> origin(target + factor * way);
    return {origin, Vec3<T>(target - Vec3d(origin)), T(0), T(1 + 1 / factor)};
  }

  void find_inside(std::uint64_t seed);

  std::string name_;
  std::shared_ptr<const TriangleMesh> mesh_;
  std::vector<Vec3d> inside_;
  double reach_ = 0;  ///< The largest extent of the bounds.
  double step_ = 0;   ///< Inside points are multiples of it, on a lattice.
  bool on_lattice_ = false;
};

}  // namespace sightline::hard
