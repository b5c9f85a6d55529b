#pragma once
/// Pictures of a walk in files, and how fast they would follow a hand.

#include <filesystem>
#include <functional>
#include <span>

#include "viz/walk/walk_view.h"

namespace sightline::viz {

/// Drawn of the mesh in a picture.
inline constexpr std::size_t most_picture_triangles = 120'000;

/// Needs a display (see PictureScreen).
void write_walk_png(const std::filesystem::path& path, const WalkModel& model, std::size_t step, const WalkLook& look,
                    const TriangleMesh& coarse);

/// What takes a window how long, in milliseconds, as the median of `count` times.
struct FrameTimes {
  double turn, step;
  std::size_t triangles;
};
FrameTimes measure_frames(const WalkModel& model, const WalkLook& look, int count);

}  // namespace sightline::viz
