#pragma once
/// What a page shows of structures on a scene: their cells, walks of the same rays, and their work.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "sightline/scene/camera.h"
#include "viz/walk/walk.h"
#include "viz/web/thin_mesh.h"

namespace sightline::viz {

struct DepthCount {
  std::size_t inner = 0, leaves = 0;
};

struct WebStructure {
  std::string label;  ///< As it was asked for.
  std::string description;
  std::size_t bytes = 0;
  std::vector<DepthCount> depths;   ///< All cells, by depth.
  std::vector<Cell> cells;          ///< The largest of them, shallow ones first.
  int readable_depth = 0;           ///< Down to which a picture of nested cells reads well.
  bool is_cut = false;              ///< Falls into so many parts at once that only a section reads well.
  std::vector<std::uint32_t> work;  ///< Nodes, leaves and candidates of each ray of the camera.
  std::vector<Walk> walks;          ///< One a ray.

  std::size_t cell_count() const;
};

struct WebRay {
  std::string label;  ///< Such as "--pick 600,450".
  Ray<float> ray;
};

struct WebModel {
  std::string scene;
  std::string command;  ///< By which the page can be had again.
  std::shared_ptr<const TriangleMesh> mesh;
  ThinMesh shown;
  Camera camera;  ///< Of the picture through whose pixels rays are picked.
  Vec3d focus;    ///< In the middle of that picture, around which the view turns.
  std::vector<WebRay> rays;
  std::vector<WebStructure> structures;
};

/// What a page can hold: triangles, and bytes of cells, of all structures and of one.
inline constexpr std::size_t web_triangles = 60'000, web_cell_bytes = 6'000'000, web_structure_bytes = 1'200'000;

/// Of each, where there are so many structures.
constexpr std::size_t web_bytes_each(std::size_t structures) {
  return std::min(web_structure_bytes, web_cell_bytes / std::max<std::size_t>(1, structures));
}

/// Without rays and structures yet. `focus` is where the camera looks at.
WebModel web_model(const std::string& scene, std::shared_ptr<const TriangleMesh> mesh, const Camera& camera,
                   const Vec3d& focus);

/// Of a picture as `camera` sees it, at a coarse size.
std::vector<std::uint32_t> work_of_picture(const Tracer& tracer, const Camera& camera);

/// Rays first, cells after them, so that a lazy structure has what they have asked for. The largest cells whose data
/// take no more than `cell_bytes`.
WebStructure web_structure(const Tracer& tracer, const std::string& label, const WebModel& model,
                           std::size_t cell_bytes);

/// The ray through a pixel near the middle of the picture at which anything is hit: of the smallest square around the
/// middle that has one. Of an empty picture that through its middle.
WebRay middle_ray(const Tracer& tracer, const Camera& camera);

}  // namespace sightline::viz
