#pragma once
/// The cases of structures, and what they share.

#include "sightline/math/interval.h"
#include "tests/accel/law_scenes.h"
#include "tests/hard_cases/mesh_question.h"

namespace sightline::hard {

HardCase kd_planar();
HardCase kd_outside_cell();
HardCase kd_zero_direction();
HardCase kd_split_at_origin();
HardCase bih_overlap();
HardCase bih_clip_round();
HardCase grid_insert();
HardCase grid_outside_cell();
HardCase grid_drift();
HardCase grid_index_n();
HardCase grid_flat();
HardCase build_same_centroid();
HardCase bsp_on_plane();
HardCase bounding_sphere_far();
HardCase nan_inf_ray();

/// A naive structure asked the same: its tests of triangles are the library's, so that only its walk can fail.
template <class Structure>
void ask_structure(Tally& tally, const MeshQuestion& question, const Structure& structure) {
  for (std::size_t i = 0; i < question.rays().size(); ++i) {
    question.judge(tally, i, structure.closest(question.rays()[i]));
  }
}

/// The nearer one of the best hit so far and those of the triangles.
inline void keep_nearest(const TriangleMesh& mesh, std::span<const std::uint32_t> ids, const Ray<float>& ray,
                         Hit<float>& best) {
  const TriangleRay prepared = mesh.prepare(to_double(ray));
  for (const std::uint32_t id : ids) {
    prepared.for_each_crossing(mesh[id], [&](const Crossing& crossing) {
      const Hit<float> hit{static_cast<float>(crossing.t), id, 0, 0};
      if (hit.t > ray.t_min && hit.t <= ray.t_max && is_closer(hit, best)) best = hit;
    });
  }
}

/// Where the ray is in the box; empty where lo > hi.
inline Interval<float> naive_clip(const Aabb& box, const Ray<float>& ray) {
  Interval<float> range{ray.t_min, ray.t_max};
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < box.lo[axis] || ray.origin[axis] > box.hi[axis]) range.hi = -1;
      continue;
    }
    const float a = (box.lo[axis] - ray.origin[axis]) / ray.direction[axis],
                b = (box.hi[axis] - ray.origin[axis]) / ray.direction[axis];
    range.lo = std::max(range.lo, std::min(a, b)), range.hi = std::min(range.hi, std::max(a, b));
  }
  return range;
}

inline std::vector<std::uint32_t> all_ids(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> ids(mesh.size());
  for (std::uint32_t id = 0; id < mesh.size(); ++id) ids[id] = id;
  return ids;
}

}  // namespace sightline::hard
