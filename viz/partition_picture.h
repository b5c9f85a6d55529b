#pragma once

#include <vtkRenderWindow.h>

#include <filesystem>
#include <optional>
#include <string>

#include "viz/coloring.h"
#include "viz/partition.h"

namespace sightline::viz {

/// From where a picture is taken: degrees around the vertical (y) axis from the front (+z), degrees above the horizon.
struct View {
  std::optional<double> azimuth;    ///< Not given: 24, or straight at the slice.
  std::optional<double> elevation;  ///< Not given: 20, or straight at the slice.
  double zoom = 1;
  int width = 1200;
  int height = 900;
};

/// Those that a view has where it does not say.
struct Angles {
  double azimuth, elevation;
};
Angles angles_of(const View& view, const std::optional<Slice>& slice);

struct Caption {
  std::string title;     ///< "kd-tree on dragon:3"
  std::string subtitle;  ///< What the structure is.
};

/// Cells over the shaded mesh, with a caption and a legend, on white: outlines colored by depth, deeper ones thinner,
/// the deepest cells tinted. With a slice, the plane's section through cells and mesh, and the mesh behind it.
struct PartitionPicture {
  const TriangleMesh& mesh;
  const Partition& partition;
  std::optional<Slice> slice;
  Caption caption;
  View view;

  /// Replaces what the window shows. `scale` enlarges text and lines, for drawing larger than the picture will be.
  void show_in(vtkRenderWindow& window, double scale) const;

  /// Drawn off screen at twice the size and averaged down. Needs a display (see PictureScreen) while it runs.
  void write_png(const std::filesystem::path& path) const;
};

/// "63 of 1,234 cells, depth 0 to 5 of 17".
std::string summary(const Partition& partition);

/// 1234567 as "1,234,567".
std::string with_commas(std::size_t count);

}  // namespace sightline::viz
