#pragma once
/// Panels of noise in space.

#include <vtkImageData.h>

#include "viz/noise/chart_panels.h"
#include "viz/space_camera.h"

namespace sightline::viz {

inline constexpr double usual_azimuth = 26.6, usual_elevation = 19.4;
/// From where space is seen.
Axes axes_of(const NoiseLook& look);

vtkSmartPointer<vtkImageData> image_of(const FieldCube& cube);

/// Surfaces where the value is two fifths as large as it gets: orange above 0, blue below.
vtkSmartPointer<vtkRenderer> isosurface_view(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                             const PartPlace& place);
/// Values as a mist: the farther from 0, the denser.
vtkSmartPointer<vtkRenderer> volume_view(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                         const PartPlace& place);

}  // namespace sightline::viz
