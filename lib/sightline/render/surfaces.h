#pragma once
/// What is where a ray meets a scene. Each property is computed for those that ask for it, no others.

#include <glm/vec2.hpp>

#include "sightline/render/surface_material.h"
#include "sightline/render/trace_world.h"
#include "sightline/texture/footprint.h"
#include "sightline/texture/tangent_frame.h"

namespace sightline {

/// A point of a surface.
struct SurfacePoint {
  Vec3d point{0};
  Vec3d outside{0, 0, 1};  ///< The surface's normal, of unit length.
  double error = 0;        ///< The surface passes the point at most so far away.

  /// Where rays begin that leave to the side of `side`, +-outside: surely on that side of the surface where it is flat
  /// or bends away, so that it is not met again. No epsilon: as far as arithmetic may have erred, and not more.
  ///   The sum of point and shift is rounded once more, by less than `error`.
  Vec3d beyond(const Vec3d& side) const { return point + (4 * error) * side; }
};

/// The material of that name, or `otherwise` for none and for the empty name.
std::uint32_t material_named(const Scene& scene, const std::string& name, std::uint32_t otherwise);

/// Numbers of the primitives that are left in a solid: those below its root.
std::vector<std::uint32_t> primitives_in(const Solid& solid);

class Surfaces {
 public:
  /// Refers to both.
  Surfaces(const Scene& scene, const TraceWorld& world);

  SurfacePoint locate(const Ray<double>& ray, const WorldHit& hit) const {
    SurfacePoint at;
    locate(ray, hit, at);
    return at;
  }
  /// The same, in place: copying what was just written would wait for it.
  void locate(const Ray<double>& ray, const WorldHit& hit, SurfacePoint& at) const;
  /// Number of its material, or no_item.
  std::uint32_t material(const WorldHit& hit) const;
  /// The same of a solid's own material number.
  std::uint32_t material(std::uint32_t item, std::uint32_t of_solid) const {
    return materials_[items_[item].first_material + of_solid];
  }
  /// The element's number.
  NodeId node(const WorldHit& hit) const { return world_.origin(hit.item).node; }

  /// Whether shading takes another normal than that of the surface.
  bool is_smooth(const WorldHit& hit) const {
    if (!has_smooth_) return false;
    const MeshGeometry* mesh = items_[hit.item].mesh;
    return mesh && !mesh->normals.empty();
  }
  /// The normal as shading takes it: interpolated where the mesh has normals of its own. On the side of `outside`.
  Vec3d normal(const WorldHit& hit, const SurfacePoint& at) const {
    return is_smooth(hit) ? interpolated_normal(hit, at) : at.outside;
  }
  /// The point in coordinates of the shape.
  Vec3d local(const WorldHit& hit, const SurfacePoint& at) const {
    const Item& item = items_[hit.item];
    return item.mesh ? local_of_mesh(hit) : item.to_world.inverse().point(at.point);
  }
  /// A square of that width in the world, around the point on the surface, in coordinates of the shape.
  Footprint local_footprint(const WorldHit& hit, const SurfacePoint& at, double width) const {
    return width == 0 ? Footprint() : wide_footprint(hit, at, width);
  }
  /// The place in images: a mesh's own, 0 where it has none; of a solid spherical around its origin. And by how much it
  /// moves for a length in the world, about.
  struct ImagePlace {
    glm::dvec2 uv{0};
    double scale = 0;
  };
  ImagePlace image_place(const WorldHit& hit, const SurfacePoint& at) const;
  /// The unit normal with dents in the shape's coordinates; `footprint` is a length in the world.
  Vec3d dented(const WorldHit& hit, const SurfacePoint& at, const Vec3d& normal, const Dents& dents,
               double footprint) const;
  /// The frame of a normal map around a unit normal.
  TangentFrame tangent_frame(const WorldHit& hit, const SurfacePoint& at, const Vec3d& normal) const;

 private:
  /// Of an item.
  struct Item {
    const MeshGeometry* mesh = nullptr;
    Transform to_world;                ///< Of the mesh's placement, as floats have it; of a solid its node's.
    double scale = 1;                  ///< A length in the shape for one in the world.
    std::uint32_t first_material = 0;  ///< Of a solid, in materials_.
  };
  /// A mesh's triangle as it is placed: corners' numbers, and weights.
  struct Place;
  Place place(const WorldHit& hit) const;
  Vec3d local_of_mesh(const WorldHit& hit) const;
  Footprint wide_footprint(const WorldHit& hit, const SurfacePoint& at, double width) const;
  Vec3d interpolated_normal(const WorldHit& hit, const SurfacePoint& at) const;

  const Scene& scene_;
  const TraceWorld& world_;
  double solid_error_;       ///< Of t, relative to it.
  bool has_smooth_ = false;  ///< Any item with normals of its own.
  std::vector<Item> items_;
  std::vector<std::uint32_t> materials_;  ///< Of solids' materials.
};

}  // namespace sightline
