#include "viz/csg_window.h"

#include <vtkCommand.h>
#include <vtkInteractorStyleUser.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <iostream>
#include <string_view>

#include "viz/csg_table.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

class Clicks : public vtkCommand {
 public:
  static Clicks* New() { return new Clicks; }

  void watch(const CsgPicture& first, vtkRenderWindow& window) {
    first_ = &first;
    window_ = &window;
  }

  void Execute(vtkObject* caller, unsigned long event, void*) override {
    auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
    if (event == vtkCommand::KeyPressEvent) {
      const std::string_view key = interactor->GetKeySym() ? interactor->GetKeySym() : "";
      if (key == "r" || key == "R") show(first_->ladder.ray);
      return;
    }
    // The window's rows count from below.
    const int x = interactor->GetEventPosition()[0], y = height() - 1 - interactor->GetEventPosition()[1];
    const SolidPanel panel = CsgLayout(width(), height()).panel();
    if (x < panel.x || x >= panel.x + panel.width || y < panel.y || y >= panel.y + panel.height) return;
    const Camera camera = panel_camera(first_->solid, width(), height());
    show(ray_through(camera, x - panel.x + 0.5, y - panel.y + 0.5));
  }

 private:
  int width() const { return std::max(window_->GetSize()[0], CsgLayout::lowest_width); }
  int height() const { return std::max(window_->GetSize()[1], CsgLayout::lowest_height); }

  void show(const Ray<double>& ray) {
    CsgPicture picture = *first_;
    picture.ladder = picture.solid.climb(ray, picture.ladder.level);
    picture.width = width(), picture.height = height();
    std::cout << '\n' << ladder_table(picture.ladder, picture.solid, picture.name) << std::flush;
    picture.show_in(*window_, 1);
    window_->Render();
  }

  const CsgPicture* first_ = nullptr;
  vtkRenderWindow* window_ = nullptr;
};

}  // namespace

void open_csg_window(const CsgPicture& first) {
  auto window = New<vtkRenderWindow>::New();
  window->SetWindowName(("csg " + first.name).c_str());
  window->SetSize(first.width, first.height);
  window->SetMultiSamples(8);
  first.show_in(*window, 1);
  auto interactor = New<vtkRenderWindowInteractor>::New();
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(New<vtkInteractorStyleUser>::New());
  auto clicks = New<Clicks>::New();
  clicks->watch(first, *window);
  interactor->AddObserver(vtkCommand::LeftButtonPressEvent, clicks);
  interactor->AddObserver(vtkCommand::KeyPressEvent, clicks);
  window->Render();
  interactor->Start();
}

}  // namespace sightline::viz
