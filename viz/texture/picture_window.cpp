#include "viz/texture/picture_window.h"

#include <vtkInteractorStyleUser.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

namespace sightline::viz {

void open_picture_window(const std::string& title, int width, int height,
                         const std::function<void(vtkRenderWindow&, int)>& show) {
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetWindowName(title.c_str());
  window->SetSize(width, height);
  window->SetMultiSamples(8);
  show(*window, 1);
  auto interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(vtkSmartPointer<vtkInteractorStyleUser>::New());
  window->Render();
  interactor->Start();
}

}  // namespace sightline::viz
