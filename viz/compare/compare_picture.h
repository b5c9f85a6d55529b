#pragma once
/// Structures side by side: their walks, their work, how these differ, and how work is spread.

#include <vtkRenderWindow.h>

#include <filesystem>
#include <vector>

#include "viz/compare/compare_camera.h"
#include "viz/compare/compare_layout.h"
#include "viz/compare/compare_look.h"
#include "viz/compare/findings.h"
#include "viz/compare/histogram_charts.h"
#include "viz/compare/walk_space.h"

namespace sightline::viz {

struct ComparePicture {
  std::span<const Compared> compared;
  vtkSmartPointer<vtkPolyData> surface;  ///< See smooth_surface(); of the mesh of all.
  const CompareFindings& findings;
  CompareLook look;
  CompareSource source;
  int width, height;

  /// Which structures have a panel.
  std::vector<std::size_t> shown() const;
  CompareLayout layout() const { return {width, height, shown().size()}; }
  SpaceCamera camera() const;
  /// Replaces what the window shows. `scale` enlarges all, for drawing larger than the picture will be.
  void show_in(vtkRenderWindow& window, int scale) const;
  /// Drawn off screen at twice the size and averaged down. Needs a display (see PictureScreen) while it runs.
  void write_png(const std::filesystem::path& path) const;
  HistogramSheet histograms() const;
};

}  // namespace sightline::viz
