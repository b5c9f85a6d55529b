#include "viz/csg_window.h"

#include <vtkCommand.h>
#include <vtkInteractorStyleUser.h>

#include <algorithm>
#include <ostream>
#include <string_view>

#include "viz/csg_table.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

}  // namespace

class CsgWindow::Events : public vtkCommand {
 public:
  static Events* New() { return new Events; }

  void tell(CsgWindow& window) { window_ = &window; }

  void Execute(vtkObject* caller, unsigned long event, void*) override {
    auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
    if (event == vtkCommand::LeftButtonPressEvent) {
      window_->press();
    } else if (event == vtkCommand::ConfigureEvent) {
      window_->fit();
    } else {
      const std::string_view key = interactor->GetKeySym() ? interactor->GetKeySym() : "";
      if (key == "r" || key == "R") window_->choose(window_->first_);
    }
  }

 private:
  CsgWindow* window_ = nullptr;
};

CsgWindow::CsgWindow(const CsgPicture& first, std::ostream& tables)
    : picture_(first),
      first_(first.ladder.ray),
      tables_(tables),
      window_(New<vtkRenderWindow>::New()),
      interactor_(New<vtkRenderWindowInteractor>::New()) {
  window_->SetWindowName(("csg " + first.name).c_str());
  window_->SetSize(first.width, first.height);
  window_->SetMultiSamples(8);
  interactor_->SetRenderWindow(window_);
  interactor_->SetInteractorStyle(New<vtkInteractorStyleUser>::New());
  auto events = New<Events>::New();
  events->tell(*this);
  for (const auto event : {vtkCommand::LeftButtonPressEvent, vtkCommand::KeyPressEvent, vtkCommand::ConfigureEvent}) {
    interactor_->AddObserver(event, events);
  }
  show();
}

void CsgWindow::run() { interactor_->Start(); }

void CsgWindow::press() {
  // The window's rows count from below, where the picture's last one is.
  const int x = interactor_->GetEventPosition()[0], y = picture_.height - 1 - interactor_->GetEventPosition()[1];
  if (const auto ray = ray_through_pixel(picture_.solid, picture_.width, picture_.height, x, y)) choose(*ray);
}

void CsgWindow::choose(const Ray<double>& ray) {
  picture_.ladder = picture_.solid.climb(ray, picture_.ladder.level);
  tables_ << '\n' << ladder_table(picture_.ladder, picture_.solid, picture_.name) << std::flush;
  show();
}

/// The picture grows and shrinks with the window.
void CsgWindow::fit() {
  const int width = std::max(window_->GetSize()[0], CsgLayout::lowest_width);
  const int height = std::max(window_->GetSize()[1], CsgLayout::lowest_height);
  if (width == picture_.width && height == picture_.height) return;
  picture_.width = width, picture_.height = height;
  show();
}

void CsgWindow::show() {
  picture_.show_in(*window_, 1);
  window_->Render();
}

}  // namespace sightline::viz
