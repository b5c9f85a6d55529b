#pragma once

#include <vtkRenderWindow.h>

#include <filesystem>
#include <string>
#include <vector>

#include "viz/graph/graph_layout.h"
#include "viz/graph/graph_space.h"

namespace sightline::viz {

/// A scene's tree beside the scene, once or in a strip of frames.
struct GraphPicture {
  const DrawnScene& drawn;
  std::vector<GraphFrame> frames;
  GraphLook look;
  bool has_one_tree = true;  ///< Left of all frames; otherwise one in each.
  std::string title, subtitle;
  std::string verdict;              ///< What comes of a change; or empty.
  int width = 1600, height = 1000;  ///< Pixels.

  double aspect = 1;  ///< Width over height of what is in space; see aspect_of().

  GraphLayout layout() const { return {width, height, static_cast<int>(frames.size()), has_one_tree, aspect}; }
  SpaceCamera camera() const;

  /// Replaces what the window shows, from `camera` where one is given. `scale` is the number of the window's pixels
  /// for each of the picture's. The things of each frame.
  std::vector<GraphSpace> show_in(vtkRenderWindow& window, int scale,
                                  const std::optional<SpaceCamera>& fixed = std::nullopt) const;

  /// Needs a display (see PictureScreen) while it runs.
  void write_png(const std::filesystem::path& path) const;
};

/// "33 nodes, 15 with things, bounds: boxes of depth 0 to 5 of 5".
std::string summary(const DrawnScene& drawn, const GraphLook& look);
/// "drag of /top/left by (1, 0, 0): ...".
std::string verdict_of(const Change& change, const SceneGraph& graph);

}  // namespace sightline::viz
