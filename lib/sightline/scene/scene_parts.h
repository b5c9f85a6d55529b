#pragma once
/// What programs that make scenes do again and again.

#include <string>

#include "sightline/scene/scene.h"

namespace sightline {

/// Into the scene's lists; their numbers.
std::uint32_t add_geometry(Scene& scene, std::string name, MeshGeometry mesh);
std::uint32_t add_material(Scene& scene, Material material);

/// A node below `parent` that shows a geometry.
NodeId place(Scene& scene, NodeId parent, std::string name, const Transform& local, std::uint32_t geometry,
             std::uint32_t material = no_item);

/// A node below `parent` at `eye` that looks at `target`, `y_up` upward in the picture, and its camera. All in the
/// coordinates of `parent`; `y_up` is not along the view.
NodeId add_camera(Scene& scene, NodeId parent, std::string name, const Vec3d& eye, const Vec3d& target,
                  const Vec3d& y_up, double field_of_view);

/// A node below `parent` with a light that shines everywhere.
NodeId add_point_light(Scene& scene, NodeId parent, std::string name, const Vec3d& at, double intensity);

/// Turns +z toward a direction of any length but 0 by the shortest way; half a turn about y where that is -z.
Transform turn_to(const Vec3d& direction);

/// Takes what stands on z from 0 to 1, with radius 1, to the stretch between two points.
Transform stretch_between(const Vec3d& from, const Vec3d& to, double radius);

/// A scene of one node.
Scene scene_of(std::string name, std::shared_ptr<const TriangleMesh> mesh);

}  // namespace sightline
