#include "viz/build/build_window.h"

#include <vtkCommand.h>
#include <vtkInteractorStyleUser.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

}  // namespace

std::optional<std::size_t> node_after(const BuildTree& tree, std::size_t node, const std::string& key) {
  const BuildNode& here = tree[node];
  if (key == "Home") return 0;
  if (key == "Up") return here.parent;
  if (key == "Down") return here.children.empty() ? std::nullopt : std::optional(here.children.front());
  if (key == "Tab") {
    if (!here.parent) return std::nullopt;
    const std::vector<std::size_t>& siblings = tree[*here.parent].children;
    const auto at = std::find(siblings.begin(), siblings.end(), node) - siblings.begin();
    return siblings[static_cast<std::size_t>(at + 1) % siblings.size()];
  }
  if (key != "Right" && key != "Left") return std::nullopt;
  const auto step = tree.step_of(node);
  if (!step) return here.parent;  // a leaf is beside the steps: back to the division that made it
  if (key == "Left") return *step == 0 ? std::nullopt : std::optional(tree.steps()[*step - 1]);
  return *step + 1 == tree.steps().size() ? std::nullopt : std::optional(tree.steps()[*step + 1]);
}

std::string picture_name(const BuildStory& story, const BuildStep& step) {
  return "build-" + story.structure().accelerator + '-' + std::to_string(story.tree()[step.node].cell.node) + ".png";
}

class BuildWindow::Events : public vtkCommand {
 public:
  static Events* New() { return new Events; }
  void tell(BuildWindow& window) { window_ = &window; }
  void Execute(vtkObject*, unsigned long event, void*) override { window_->answer(event); }

 private:
  BuildWindow* window_ = nullptr;
};

BuildWindow::BuildWindow(const BuildStory& story, std::size_t node, const BuildLook& look)
    : story_(story),
      step_(story.step_at(node)),
      look_(look),
      window_(New<vtkRenderWindow>::New()),
      interactor_(New<vtkRenderWindowInteractor>::New()) {
  window_->SetWindowName(("build " + story.structure().accelerator + " on " + story.scene()).c_str());
  window_->SetSize(look.width, look.height);
  window_->SetMultiSamples(8);
  interactor_->SetRenderWindow(window_);
  auto style = New<vtkInteractorStyleUser>::New();
  interactor_->SetInteractorStyle(style);
  auto events = New<Events>::New();
  events->tell(*this);
  for (const auto event :
       {vtkCommand::LeftButtonPressEvent, vtkCommand::MouseMoveEvent, vtkCommand::LeftButtonReleaseEvent,
        vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent, vtkCommand::KeyPressEvent,
        vtkCommand::ConfigureEvent}) {
    interactor_->AddObserver(event, events);
  }
  style->AddObserver(vtkCommand::CharEvent, events);  // keys have no other meaning than here
  show();
}

void BuildWindow::run() { interactor_->Start(); }

void BuildWindow::answer(unsigned long event) {
  switch (event) {
    case vtkCommand::LeftButtonPressEvent:
      is_turning_ = true;
      hand_x_ = interactor_->GetEventPosition()[0], hand_y_ = interactor_->GetEventPosition()[1];
      return;
    case vtkCommand::LeftButtonReleaseEvent:
      is_turning_ = false;
      return;
    case vtkCommand::MouseMoveEvent:
      if (is_turning_) turn();
      return;
    case vtkCommand::MouseWheelForwardEvent:
      look_.zoom = std::min(100.0, look_.zoom * 1.15);
      return show();
    case vtkCommand::MouseWheelBackwardEvent:
      look_.zoom = std::max(0.1, look_.zoom / 1.15);
      return show();
    case vtkCommand::ConfigureEvent: {
      const int width = window_->GetSize()[0], height = window_->GetSize()[1];
      if (width == look_.width && height == look_.height) return;
      look_.width = std::max(width, BuildPicture::lowest_width);
      look_.height = std::max(height, BuildPicture::lowest_height);
      return show();
    }
    case vtkCommand::KeyPressEvent:
      return answer_key(interactor_->GetKeySym() ? interactor_->GetKeySym() : "");
    default:
      return;
  }
}

void BuildWindow::turn() {
  const int x = interactor_->GetEventPosition()[0], y = interactor_->GetEventPosition()[1];
  look_.azimuth = std::fmod(look_.azimuth - 0.4 * (x - hand_x_), 360);
  look_.elevation = std::clamp(look_.elevation - 0.4 * (y - hand_y_), -90.0, 90.0);
  hand_x_ = x, hand_y_ = y;
  show();
}

void BuildWindow::answer_key(const std::string& key) {
  if (key == "q" || key == "Q") return interactor_->ExitCallback();
  if (key == "h" || key == "H") {
    look_.has_help = !look_.has_help;
    return show();
  }
  if (key == "s" || key == "S") {
    BuildLook look = look_;
    look.has_help = false;
    const std::string name = picture_name(story_, step_);
    BuildPicture{story_, step_, look}.write_png(name);
    std::cerr << name << '\n';
    return;
  }
  if (const auto node = node_after(story_.tree(), step_.node, key)) go_to(*node);
}

void BuildWindow::go_to(std::size_t node) {
  step_ = story_.step_at(node);
  show();
}

void BuildWindow::show() {
  BuildPicture{story_, step_, look_}.show_in(*window_, 1);
  window_->Render();
}

}  // namespace sightline::viz
