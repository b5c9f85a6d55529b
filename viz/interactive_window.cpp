#include "viz/interactive_window.h"

#include <vtkCommand.h>
#include <vtkInteractorStyleUser.h>

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

}  // namespace

class InteractiveWindow::Events : public vtkCommand {
 public:
  static Events* New() { return new Events; }
  void tell(InteractiveWindow& window) { window_ = &window; }
  void Execute(vtkObject*, unsigned long event, void*) override { window_->answer(event); }

 private:
  InteractiveWindow* window_ = nullptr;
};

InteractiveWindow::InteractiveWindow(const std::string& title, int width, int height, int samples)
    : window_(New<vtkRenderWindow>::New()), interactor_(New<vtkRenderWindowInteractor>::New()) {
  window_->SetWindowName(title.c_str());
  window_->SetSize(width, height);
  window_->SetMultiSamples(samples);
  interactor_->SetRenderWindow(window_);
  auto style = New<vtkInteractorStyleUser>::New();
  interactor_->SetInteractorStyle(style);
  auto events = New<Events>::New();
  events->tell(*this);
  for (const auto event :
       {vtkCommand::LeftButtonPressEvent, vtkCommand::MouseMoveEvent, vtkCommand::LeftButtonReleaseEvent,
        vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent, vtkCommand::KeyPressEvent,
        vtkCommand::ConfigureEvent, vtkCommand::TimerEvent}) {
    interactor_->AddObserver(event, events);
  }
  style->AddObserver(vtkCommand::CharEvent, events);  // keys have no other meaning than here
}

void InteractiveWindow::run() { interactor_->Start(); }

void InteractiveWindow::start_clock(unsigned long milliseconds) {
  if (!has_clock_) interactor_->CreateRepeatingTimer(milliseconds);
  has_clock_ = true;
}

void InteractiveWindow::answer(unsigned long event) {
  switch (event) {
    case vtkCommand::LeftButtonPressEvent:
      return press();
    case vtkCommand::MouseMoveEvent:
      return move();
    case vtkCommand::LeftButtonReleaseEvent:
      return release();
    case vtkCommand::MouseWheelForwardEvent:
      return zoom(1.15);
    case vtkCommand::MouseWheelBackwardEvent:
      return zoom(1 / 1.15);
    case vtkCommand::ConfigureEvent:
      return fit();
    case vtkCommand::TimerEvent:
      return tick();
    case vtkCommand::KeyPressEvent: {
      const std::string key = interactor_->GetKeySym() ? interactor_->GetKeySym() : "";
      return key == "q" || key == "Q" ? interactor_->ExitCallback() : answer_key(key);
    }
    default:
      return;
  }
}

}  // namespace sightline::viz
