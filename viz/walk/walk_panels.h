#pragma once
/// The flat parts of a walk's picture: hierarchy, treemap, facts, timeline, legend.

#include "viz/canvas.h"
#include "viz/space_camera.h"
#include "viz/walk/walk_model.h"

namespace sightline::viz {

struct WalkWords {
  std::string mesh;     ///< What is drawn of the mesh.
  std::string command;  ///< That gives this picture.
};

void draw_panels(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::size_t step,
                 const WalkWords& words);

/// What stands beside points in space: these move with the camera.
void draw_labels(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::size_t step,
                 const SpaceCamera& camera);

}  // namespace sightline::viz
