#pragma once
/// Histograms of work per ray, side by side on common axes.

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

#include "viz/compare/work_statistics.h"
#include "viz/noise/chart_panels.h"

namespace sightline::viz {

struct HistogramPanel {
  std::string title, text;
  std::vector<HistogramBin> bins;  ///< The same of all panels, but for the rays.
  WorkStatistics statistics;
  PanelFrame frame;  ///< Of the chart, in units.
};

struct HistogramSheet {
  std::string title, unit;  ///< Unit: "steps", ...
  std::vector<HistogramPanel> panels;

  /// Along the axis: bins of one width for each doubling, those of no work apart to the left.
  static double position_of(double work);

  /// All charts in one renderer, for the whole window.
  vtkSmartPointer<vtkRenderer> renderer(const PartPlace& place) const;
  /// With the titles, which are no part of the charts elsewhere. Needs a display (see PictureScreen) while it runs.
  void write_svg(const std::filesystem::path& path, int width, int height, double unit_pixels) const;
};

}  // namespace sightline::viz
