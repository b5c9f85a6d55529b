#include "viz/noise/space_panels.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkOutlineFilter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cstdio>

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

void add_outline(vtkRenderer& renderer, vtkImageData* image) {
  auto outline = New<vtkOutlineFilter>::New();
  outline->SetInputData(image);
  auto mapper = New<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(outline->GetOutputPort());
  auto actor = New<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(faint_ink[0], faint_ink[1], faint_ink[2]);
  actor->GetProperty()->LightingOff();
  renderer.AddActor(actor);
}

/// From the right, in front and above, where the look does not say.
void look_at(vtkRenderer& renderer, const NoiseLook& look) {
  vtkCamera& camera = *renderer.GetActiveCamera();
  const Axes axes = axes_of(look);
  camera.SetPosition(&axes.z[0]);
  camera.SetFocalPoint(0, 0, 0);
  camera.SetViewUp(&axes.y[0]);
  renderer.ResetCamera();
  camera.Dolly(look.zoom);
  renderer.ResetCameraClippingRange();
}

std::string level_text(double level) {
  char text[64];
  std::snprintf(text, sizeof text, "where the value is %.2f (orange) or -%.2f (blue)", level, level);
  return text;
}

}  // namespace

Axes axes_of(const NoiseLook& look) {
  return axes_toward(look.azimuth.value_or(usual_azimuth), look.elevation.value_or(usual_elevation));
}

vtkSmartPointer<vtkImageData> image_of(const FieldCube& cube) {
  auto values = New<vtkFloatArray>::New();
  values->SetNumberOfTuples(static_cast<vtkIdType>(cube.values.size()));
  std::copy(cube.values.begin(), cube.values.end(), values->GetPointer(0));
  const double step = cube.extent / (cube.size - 1);
  auto image = New<vtkImageData>::New();
  image->SetDimensions(cube.size, cube.size, cube.size);
  image->SetSpacing(step, step, step);
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkRenderer> isosurface_view(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                             const PartPlace& place) {
  const FieldCube cube = cube_of(look.field, 72, look.extent, look.slice);
  const double level = 0.4 * largest_size(cube.values);
  const PanelFrame frame = framed(canvas, panel, "Isosurfaces", {level_text(level)});
  const auto renderer = place.renderer(frame);
  const auto image = image_of(cube);
  for (const double side : {-1.0, 1.0}) {
    auto surface = New<vtkFlyingEdges3D>::New();
    surface->SetInputData(image);
    surface->SetValue(0, side * level);
    surface->ComputeNormalsOn();
    auto mapper = New<vtkPolyDataMapper>::New();
    mapper->SetInputConnection(surface->GetOutputPort());
    mapper->ScalarVisibilityOff();
    auto actor = New<vtkActor>::New();
    actor->SetMapper(mapper);
    const Rgb color = diverging(0.95 * side);
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetAmbient(0.25);
    renderer->AddActor(actor);
  }
  add_outline(*renderer, image);
  look_at(*renderer, look);
  return renderer;
}

vtkSmartPointer<vtkRenderer> volume_view(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look,
                                         const PartPlace& place) {
  const FieldCube cube = cube_of(look.field, 72, look.extent, look.slice);
  const double largest = largest_size(cube.values);
  const PanelFrame frame = framed(canvas, panel, "Volume", {"the farther from 0, the denser"});
  const auto renderer = place.renderer(frame);
  const auto image = image_of(cube);
  auto colors = New<vtkColorTransferFunction>::New();
  auto opacity = New<vtkPiecewiseFunction>::New();
  for (int i = -8; i <= 8; ++i) {
    const double share = i / 8.0, value = share * largest, size = std::abs(share);
    const Rgb color = diverging(share);
    colors->AddRGBPoint(value, color[0], color[1], color[2]);
    opacity->AddPoint(value, size < 0.3 ? 0 : 0.5 * (size - 0.3) / 0.7);
  }
  auto property = New<vtkVolumeProperty>::New();
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(look.extent / 24);
  property->SetInterpolationTypeToLinear();
  auto mapper = New<vtkFixedPointVolumeRayCastMapper>::New();
  mapper->SetInputData(image);
  mapper->SetSampleDistance(static_cast<float>(look.extent / 144));
  mapper->AutoAdjustSampleDistancesOff();
  auto volume = New<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  renderer->AddVolume(volume);
  add_outline(*renderer, image);
  look_at(*renderer, look);
  return renderer;
}

}  // namespace sightline::viz
