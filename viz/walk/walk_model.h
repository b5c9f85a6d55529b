#pragma once
/// A walk with what its pictures show beside: sizes of its cells, and what the ray has caused to be made.

#include <string>

#include "viz/command_text.h"
#include "viz/walk/walk_layout.h"

namespace sightline::viz {

struct WalkModel {
  const Tracer* tracer = nullptr;
  std::string structure, scene;  ///< As on the command line.
  std::string command;           ///< All of the command line but the ray, the step and the camera.
  Walk walk;
  std::vector<std::size_t> candidates;  ///< Below each of walk.cells.
  std::vector<std::uint8_t> is_new;     ///< Of each of walk.cells: made for this ray, by a lazy structure.
  std::size_t cells_before = 0;         ///< Of the structure, before this ray.

  std::size_t last_step() const { return walk.steps.empty() ? 0 : walk.steps.size() - 1; }
};

/// Asks the tracer for the ray's walk. Refers to the tracer.
WalkModel model_of(const Tracer& tracer, const Ray<float>& ray);

/// The same of another ray; a lazy structure goes on growing, and the command tells by which rays it has grown.
WalkModel walk_again(const WalkModel& model, const Ray<float>& ray);

/// The part of the ray that is shown: across the mesh's bounds, and a little before and behind.
struct Stretch {
  double from, to;
};
Stretch shown_stretch(const Aabb& bounds, const Ray<float>& ray);

/// From the left in front and a little above, across the middle.
Ray<float> usual_ray(const Aabb& bounds);
/// The same, where it meets nothing another from there that hits. Does not make a lazy structure grow.
Ray<float> usual_ray(const Tracer& tracer);

}  // namespace sightline::viz
