#pragma once
/// The one camera of all panels, for drawing and for tracing.

#include <optional>

#include "sightline/query/tracer.h"
#include "sightline/scene/camera.h"
#include "viz/compare/compare_look.h"
#include "viz/space_camera.h"

namespace sightline::viz {

SpaceCamera camera_for(const TriangleMesh& mesh, const CompareLook& look, double aspect);

/// The same for a picture of so many pixels.
Camera tracing_camera(const SpaceCamera& camera, int width, int height);

/// A ray from the left through the scene: of a few the one that comes farthest before it hits.
Ray<float> ray_across(const Tracer& tracer);

}  // namespace sightline::viz
