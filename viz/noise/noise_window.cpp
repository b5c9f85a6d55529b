#include "viz/noise/noise_window.h"

#include <vtkCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <string_view>

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

class Keys : public vtkCommand {
 public:
  static Keys* New() { return new Keys; }

  void watch(const NoisePicture& first, vtkRenderWindow& window) {
    look_ = first.look;
    only_ = first.only;
    window_ = &window;
  }

  void Execute(vtkObject* caller, unsigned long, void*) override {
    auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
    const std::string_view key = interactor->GetKeySym() ? interactor->GetKeySym() : "";
    FieldOptions options = look_.field.options();
    if (key == "Left" || key == "Right") {
      look_.slice += (key == "Left" ? -1 : 1) / (16 * options.frequency);
    } else if (key == "space") {
      ++options.noise.seed;
    } else if (key == "e" || key == "E") {
      options.noise.ease = options.noise.ease == Ease::cubic ? Ease::quintic : Ease::cubic;
    } else if (key.size() == 1 && key[0] >= '0' && key[0] <= '8') {
      only_ =
          key[0] == '0' ? std::nullopt : std::optional(noise_panel_infos[static_cast<std::size_t>(key[0] - '1')].panel);
    } else {
      return;
    }
    look_.field = NoiseField(options);
    NoisePicture picture{look_, only_, std::max(window_->GetSize()[0], NoisePicture::lowest_width),
                         std::max(window_->GetSize()[1], NoisePicture::lowest_height)};
    picture.show_in(*window_, 1);
    interactor->Render();
  }

 private:
  NoiseLook look_;
  std::optional<NoisePanel> only_;
  vtkRenderWindow* window_ = nullptr;
};

}  // namespace

void open_noise_window(const NoisePicture& first) {
  auto window = New<vtkRenderWindow>::New();
  window->SetWindowName("noise");
  window->SetSize(first.width, first.height);
  window->SetMultiSamples(8);
  first.show_in(*window, 1);
  auto interactor = New<vtkRenderWindowInteractor>::New();
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(New<vtkInteractorStyleTrackballCamera>::New());
  auto keys = New<Keys>::New();
  keys->watch(first, *window);
  interactor->AddObserver(vtkCommand::KeyPressEvent, keys);
  window->Render();
  interactor->Start();
}

}  // namespace sightline::viz
