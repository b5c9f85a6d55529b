#pragma once
/// Everything of a scene that rays can meet, at one moment.

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sightline/query/instance_tracer.h"
#include "sightline/query/tracer.h"
#include "sightline/render/solid_tracer.h"
#include "sightline/scene/flatten.h"

namespace sightline {

struct WorldSettings {
  std::string accelerator = "wide-tree";                 ///< Over triangles and instances.
  std::vector<TracerSettings::Option> options;           ///< Of it.
  std::string solid_accelerator = "bih";                 ///< Over solids: takes packets.
  Level level = Level::watertight;                       ///< Of solids; triangles are decided exactly in any case.
  std::uint64_t flatten_up_to = std::uint64_t{1} << 21;  ///< Triangles that are put into one mesh, for speed.
  int threads = 0;                                       ///< To build with; 0 for as many as there are.
};

/// What a ray meets first; a miss when prim_id is no_primitive.
struct WorldHit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t item = 0;                ///< Instances of meshes, then solids.
  std::uint32_t prim_id = no_primitive;  ///< A mesh's triangle, a solid's primitive.
  double u = 0, v = 0;                   ///< Weights of the placed triangle's corners; of a solid v is the face.

  bool is_hit() const { return prim_id != no_primitive; }
};

/// Immutable, and safe to ask from many threads.
///   W1  Hits do not depend on whether meshes are flattened (J1 of instance_tracer.h), nor on the structure.
///   W2  Of a triangle and a solid at the same t the triangle is hit.
///   W3  What stands in a world before as it does here is built once, for both: structures of meshes by themselves, and
///       of flattened ones where none has moved.
class TraceWorld {
 public:
  /// \param before another moment of the scene, made with the same settings; may be null.
  /// \throws std::invalid_argument as instances_of(), solids_of() and the tracers do.
  TraceWorld(const Scene& scene, const WorldSettings& settings, const SceneFilter& takes = {},
             const TraceWorld* before = nullptr);

  bool has_meshes() const { return flat_ || placed_; }
  bool has_solids() const { return solids_ != nullptr; }
  /// Whether meshes are traced by two levels of structures.
  bool has_instances() const { return placed_ != nullptr; }
  const Instances& instances() const { return *instances_; }
  const SolidTracer& solids() const { return *solids_; }
  /// Whether structures of triangles are those of another world.
  bool shares_meshes_with(const TraceWorld& other) const {
    return flat_ ? flat_ == other.flat_ : placed_ && mesh_tracers_ == other.mesh_tracers_;
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(origins_.size()); }
  const SceneOrigin& origin(std::uint32_t item) const { return origins_[item]; }
  bool is_solid(std::uint32_t item) const { return item >= first_solid_; }
  const Solid& solid(std::uint32_t item) const { return *solid_list_[item - first_solid_]; }

  Level level() const { return level_; }
  const Aabb& bounds() const { return bounds_; }

  void closest_hits(std::span<const Ray<double>> rays, std::span<WorldHit> hits) const;
  /// The same of one ray, with the nodes, leaves and candidates that were examined.
  WorldHit closest_hit(const Ray<double>& ray, std::uint64_t& work) const;
  void any_hits(std::span<const Ray<double>> rays, std::span<std::uint8_t> is_hit) const;

 private:
  void find_meshes(std::span<const Ray<double>> rays, std::span<WorldHit> hits) const;
  void find_nearer_solids(std::span<const Ray<double>> rays, std::span<WorldHit> hits) const;
  WorldHit world_hit(const Hit<double>& hit) const;
  WorldHit solid_hit(const Hit<double>& hit) const;

  std::shared_ptr<const Instances> instances_;
  std::shared_ptr<const Tracer> flat_;  ///< One of these two, or none.
  std::unique_ptr<InstanceTracer> placed_;
  std::vector<std::shared_ptr<const Tracer>> mesh_tracers_;  ///< Of placed_.
  std::vector<std::uint32_t> firsts_;  ///< Of each instance its first triangle in the flattened mesh.
  std::unique_ptr<SolidTracer> solids_;
  std::vector<const Solid*> solid_list_;  ///< Its solids, which begin as item ...
  std::uint32_t first_solid_;             ///< ... of that number.
  std::vector<SceneOrigin> origins_;
  Aabb bounds_;
  Level level_;
};

}  // namespace sightline
