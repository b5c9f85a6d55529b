#pragma once
/// Panels of noise in space.

#include <vtkImageData.h>

#include "viz/noise/chart_panels.h"

namespace sightline::viz {

vtkSmartPointer<vtkImageData> image_of(const FieldCube& cube);

/// Surfaces where the value is two fifths as large as it gets: orange above 0, blue below.
vtkSmartPointer<vtkRenderer> isosurface_view(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                             const PartPlace& place);
/// Values as a mist: the farther from 0, the denser.
vtkSmartPointer<vtkRenderer> volume_view(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                         const PartPlace& place);

}  // namespace sightline::viz
