#pragma once
/// Structures side by side: their walks, their work, how these differ, and how work is spread.

#include <vtkRenderWindow.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "viz/compare/compare_camera.h"
#include "viz/compare/compare_layout.h"
#include "viz/compare/compare_look.h"
#include "viz/compare/findings.h"
#include "viz/compare/histogram_charts.h"
#include "viz/compare/walk_space.h"

namespace sightline::viz {

Vec3d point_of_hit(const Walk& walk);

/// A part of a panel that shows what is around the hit, larger; in units.
struct CompareInset {
  PanelFrame frame;
  SpaceCamera camera;
};

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
  /// Where in the frame the ray hits, whatever is in front of it; nothing beside the frame.
  std::optional<Canvas::Point> place_of_hit(const Walk& walk, const PanelFrame& frame) const;
  /// Of a panel's picture where the ray hits; nothing where that is not seen.
  std::optional<CompareInset> inset_in(const Walk& walk, const PanelFrame& frame) const;
  /// Through the middle of a pixel, where a panel or its inset shows the scene.
  std::optional<Ray<float>> ray_through_pixel(int x, int y) const;
  /// Replaces what the window shows. `scale` enlarges all, for drawing larger than the picture will be.
  void show_in(vtkRenderWindow& window, int scale) const;
  /// Drawn off screen at twice the size and averaged down. Needs a display (see PictureScreen) while it runs.
  void write_png(const std::filesystem::path& path) const;
  HistogramSheet histograms() const;
};

/// The ray through a pixel of the picture, where a panel shows the scene, whatever its inset is.
std::optional<Ray<float>> ray_through_pixel(const TriangleMesh& mesh, const CompareLook& look,
                                            const CompareLayout& layout, int x, int y);

}  // namespace sightline::viz
