#pragma once
/// Panels of noise that are charts.

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "viz/noise/flat_panels.h"

namespace sightline::viz {

/// Where a part of the window is, in pixels of the window for each unit of the canvas; `height` is the canvas's.
struct PartPlace {
  double scale, width, height;

  vtkSmartPointer<vtkRenderer> renderer(const PanelFrame& frame) const;
};

/// The ease of the noise with its slope and curvature; the other ease thin. None where there is no ease.
vtkSmartPointer<vtkRenderer> ease_chart(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                        const PartPlace& place);
/// How much of the variance lies at which frequency.
vtkSmartPointer<vtkRenderer> spectrum_chart(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                            const PartPlace& place);

}  // namespace sightline::viz
