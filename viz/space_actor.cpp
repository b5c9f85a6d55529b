#include "viz/space_actor.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace sightline::viz {

vtkSmartPointer<vtkActor> add_actor(vtkRenderer& renderer, vtkPolyData* data, const Rgb& color, double opacity) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(opacity);
  renderer.AddActor(actor);
  return actor;
}

}  // namespace sightline::viz
