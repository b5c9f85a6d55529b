#include "viz/window_frame.h"

#include <vtkCommand.h>
#include <vtkInteractorStyleUser.h>
#include <vtkRendererCollection.h>

#include <algorithm>

#include "viz/interactive_window.h"
#include "viz/paper.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

vtkSmartPointer<vtkRenderer> blank() {
  auto renderer = New<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  renderer->InteractiveOff();
  return renderer;
}

}  // namespace

class WindowFrame::Events : public vtkCommand {
 public:
  static Events* New() { return new Events; }
  void tell(WindowFrame& frame) { frame_ = &frame; }
  void Execute(vtkObject*, unsigned long event, void*) override { frame_->answer(event); }

 private:
  WindowFrame* frame_ = nullptr;
};

WindowFrame::WindowFrame(const std::string& title, int width, int height, int samples)
    : window_(New<vtkRenderWindow>::New()),
      interactor_(New<vtkRenderWindowInteractor>::New()),
      top_(blank()),
      foot_(blank()),
      help_(blank()) {
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

WindowFrame::~WindowFrame() { kept_.window.reset(); }

void WindowFrame::enter(InteractiveWindow& window) {
  shown_ = &window;
  window_->GetRenderers()->RemoveAllItems();
  window_->SetNumberOfLayers(1);
  viewports_.clear();
  if (clock_ != 0) interactor_->DestroyTimer(clock_);
  clock_ = 0;
}

void WindowFrame::leave(const InteractiveWindow& window) {
  if (shown_ == &window) shown_ = nullptr;
}

void WindowFrame::keep(OpenWindow open) {
  kept_.window.reset();  // refers to what is held
  kept_ = std::move(open);
}

void WindowFrame::start_clock(unsigned long milliseconds) {
  if (clock_ == 0) clock_ = interactor_->CreateRepeatingTimer(milliseconds);
}

void WindowFrame::run() { interactor_->Start(); }

// ---- Events

void WindowFrame::answer(unsigned long event) {
  if (!shown_) return;
  const int* at = interactor_->GetEventPosition();
  switch (event) {
    case vtkCommand::LeftButtonPressEvent:
      if (bar_ && at[1] >= window_->GetSize()[1] - WindowBar::height) {
        bar_->press(at[0]);
      } else {
        shown_->press();
      }
      break;
    case vtkCommand::MouseMoveEvent:
      shown_->move();
      break;
    case vtkCommand::LeftButtonReleaseEvent:
      shown_->release();
      break;
    case vtkCommand::MouseWheelForwardEvent:
      shown_->zoom(1.15);
      break;
    case vtkCommand::MouseWheelBackwardEvent:
      shown_->zoom(1 / 1.15);
      break;
    case vtkCommand::ConfigureEvent:
      shown_->fit();
      break;
    case vtkCommand::TimerEvent:
      shown_->tick();
      break;
    case vtkCommand::KeyPressEvent:
      answer_key();
      break;
    default:
      return;
  }
  if (bar_) bar_->settle();
}

void WindowFrame::answer_key() {
  const std::string key = interactor_->GetKeySym() ? interactor_->GetKeySym() : "";
  if (key == "q" || key == "Q") return interactor_->ExitCallback();
  if (bar_ && bar_->answer_key(key)) return;
  shown_->answer_common_key(key);
}

// ---- The picture

void WindowFrame::squeeze(int foot, int top) {
  const double height = window_->GetSize()[1], low = foot / height, share = 1 - (foot + top) / height;
  vtkRendererCollection& all = *window_->GetRenderers();
  for (int i = 0; i < all.GetNumberOfItems(); ++i) {
    auto* renderer = vtkRenderer::SafeDownCast(all.GetItemAsObject(i));
    if (renderer == top_ || renderer == foot_ || renderer == help_) continue;
    Viewport now;
    std::copy_n(renderer->GetViewport(), 4, now.begin());
    auto& [asked, squeezed] = viewports_[renderer];
    if (now != squeezed) asked = now;  // by F1, it is new or has been set anew
    squeezed = {asked[0], low + share * asked[1], asked[2], low + share * asked[3]};
    renderer->SetViewport(squeezed.data());
  }
}

void WindowFrame::draw_strips(int foot, int top) {
  const int width = window_->GetSize()[0], height = window_->GetSize()[1];
  const auto place = [&](vtkRenderer& strip, int low, int strip_height, const Canvas& canvas) {
    strip.SetViewport(0, double(low) / height, 1, double(low + strip_height) / height);
    strip.RemoveAllViewProps();
    canvas.add_to(strip);
    if (!window_->HasRenderer(&strip)) window_->AddRenderer(&strip);
  };
  if (top > 0) {
    Canvas canvas(top, 1);
    bar_->draw(canvas, width);
    place(*top_, height - top, top, canvas);
  }
  if (foot > 0) {
    Canvas canvas(foot, 1);
    const Canvas::TextStyle style{15, soft_ink};
    const double keys = canvas.text_width("H: keys", style) + 24;
    canvas.text({14, foot / 2.0}, canvas.shortened(shown_->command(), style, width - keys - 40), style);
    canvas.text({width - 14.0, foot / 2.0}, "H: keys", {15, soft_ink, Canvas::Align::right});
    place(*foot_, 0, foot, canvas);
  }
}

void WindowFrame::draw_help(int layer) {
  help_->RemoveAllViewProps();
  if (!shown_->has_help()) {
    if (window_->HasRenderer(help_)) window_->RemoveRenderer(help_);
    return;
  }
  std::vector<WindowKey> keys = shown_->keys();
  keys.push_back({"S", "writes the picture here, and prints the command that does"});
  keys.push_back({"H; Q", "shows and hides this; closes"});
  if (bar_) {
    keys.push_back({"A", "the next structure"});
    keys.push_back({"F1 to F8, or the bar", "another page, with scene, structure, ray and view"});
  }
  const double width = window_->GetSize()[0], height = window_->GetSize()[1];
  constexpr double line = 31, side = 30, column = 250;
  const double unit = std::min({1.0, width / 960, height / (line * double(keys.size()) + 60)});
  Canvas canvas(height / unit, unit);
  const Canvas::TextStyle bold{19, ink, Canvas::Align::left, true}, plain{19, ink};
  double text_width = 0;
  for (const WindowKey& key : keys) text_width = std::max(text_width, canvas.text_width(key.meaning, plain));
  const double box_width = side + column + text_width + side, box_height = line * double(keys.size()) + 2 * side - 10;
  const double x = (width / unit - box_width) / 2, y = (height / unit - box_height) / 2;
  canvas.rectangle({x - 2, y - 2}, box_width + 4, box_height + 4, ink);
  canvas.rectangle({x, y}, box_width, box_height, {1, 1, 1});
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double at = y + side + 10 + line * double(i);
    canvas.text({x + side, at}, keys[i].key, bold);
    canvas.text({x + side + column, at}, keys[i].meaning, plain);
  }
  canvas.add_to(*help_);
  window_->SetNumberOfLayers(layer + 1);
  help_->SetLayer(layer);
  if (!window_->HasRenderer(help_)) window_->AddRenderer(help_);
}

void WindowFrame::render() {
  const int foot = shown_->foot(), top = bar_ ? WindowBar::height : 0;
  squeeze(foot, top);
  draw_strips(foot, top);
  int highest = 0;
  vtkRendererCollection& all = *window_->GetRenderers();
  for (int i = 0; i < all.GetNumberOfItems(); ++i) {
    auto* renderer = vtkRenderer::SafeDownCast(all.GetItemAsObject(i));
    if (renderer != help_) highest = std::max(highest, renderer->GetLayer());
  }
  draw_help(highest + 1);
  window_->Render();
}

}  // namespace sightline::viz
