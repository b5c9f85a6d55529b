#pragma once
/// Costs as a chart: a curve an axis against the plane's position, or the cheapest candidates as bars.

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

#include "viz/build/decision.h"
#include "viz/color_ramp.h"

namespace sightline::viz {

/// Distinct in gray and to the color-blind. Wong, "Points of view: Color blindness", 2011.
inline constexpr std::array<Rgb, 3> axis_colors{Rgb{0.84, 0.37, 0.00}, Rgb{0.00, 0.45, 0.70}, Rgb{0.64, 0.31, 0.50}};

/// What the chart shows of the costs: those far above are cut off, so that the interesting ones are seen.
struct CostRange {
  double lo = 0, hi = 1;
  std::size_t beyond = 0;  ///< Candidates above.
};
CostRange cost_range(const Decision& decision);

/// A renderer that holds nothing else, of so many pixels. `scale` enlarges text and lines.
vtkSmartPointer<vtkRenderer> chart_of(const Decision& decision, const std::string& title, double width, double height,
                                      double scale);

/// Needs a display (see PictureScreen) while it runs. \throws FileError
void write_chart_svg(const std::filesystem::path& path, const Decision& decision, const std::string& title);

}  // namespace sightline::viz
