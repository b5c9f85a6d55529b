#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "viz/color_ramp.h"

namespace sightline::viz {

/// Puts geometry into a space, in one color.
vtkSmartPointer<vtkActor> add_actor(vtkRenderer& renderer, vtkPolyData* data, const Rgb& color = {1, 1, 1},
                                    double opacity = 1);

}  // namespace sightline::viz
