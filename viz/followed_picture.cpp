#include "viz/followed_picture.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkInteractorStyleImage.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

#include "sightline/io/image_file.h"
#include "sightline/io/srgb.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr int widest = 1600, highest = 1000;  // of the window, in pixels
constexpr unsigned long look_interval = 250;  // in milliseconds

vtkSmartPointer<vtkImageData> screen_data(const Image& image) {
  auto data = New<vtkImageData>::New();
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* to = static_cast<unsigned char*>(data->GetScalarPointer());
  const auto channels = static_cast<std::size_t>(image.channels), width = static_cast<std::size_t>(image.width);
  for (auto y = static_cast<std::size_t>(image.height); y-- > 0;) {  // VTK counts rows from below
    for (std::size_t x = 0; x < width; ++x) {
      const float* pixel = &image.pixels[(y * width + x) * channels];
      for (std::size_t i = 0; i < 3; ++i) {
        *to++ = static_cast<unsigned char>(std::lround(255 * encode_srgb(pixel[channels < 3 ? 0 : i])));
      }
    }
  }
  return data;
}

std::filesystem::file_time_type changed(const std::filesystem::path& file, std::error_code& error) {
  return std::filesystem::last_write_time(file, error);
}

class Looks : public vtkCommand {
 public:
  static Looks* New() { return new Looks; }
  void watch(FollowedPicture& picture) { picture_ = &picture; }

  void Execute(vtkObject* caller, unsigned long, void*) override {
    if (!picture_->look()) static_cast<vtkRenderWindowInteractor*>(caller)->TerminateApp();
  }

 private:
  FollowedPicture* picture_ = nullptr;
};

}  // namespace

struct FollowedPicture::Shown {
  std::filesystem::path file;
  std::filesystem::file_time_type time;
  vtkRenderWindow& window;
  vtkSmartPointer<vtkRenderer> renderer = New<vtkRenderer>::New();
  vtkSmartPointer<vtkImageActor> actor = New<vtkImageActor>::New();
};

FollowedPicture::FollowedPicture(const std::filesystem::path& file, vtkRenderWindow& window)
    : shown_(std::make_unique<Shown>(file, std::filesystem::file_time_type{}, window)) {
  std::error_code ignored;
  shown_->time = changed(file, ignored);
  const Image image = read_image(file);
  shown_->actor->SetInputData(screen_data(image));
  shown_->actor->InterpolateOff();
  shown_->renderer->AddActor(shown_->actor);
  shown_->renderer->SetBackground(0.2, 0.2, 0.2);
  vtkCamera& camera = *shown_->renderer->GetActiveCamera();
  camera.ParallelProjectionOn();
  camera.SetFocalPoint((image.width - 1) / 2.0, (image.height - 1) / 2.0, 0);
  camera.SetPosition((image.width - 1) / 2.0, (image.height - 1) / 2.0, 1);
  camera.SetParallelScale(image.height / 2.0);
  const double scale =
      std::min({1.0, static_cast<double>(widest) / image.width, static_cast<double>(highest) / image.height});
  window.SetSize(std::max(1, static_cast<int>(image.width * scale)),
                 std::max(1, static_cast<int>(image.height * scale)));
  window.AddRenderer(shown_->renderer);
}

FollowedPicture::~FollowedPicture() = default;

bool FollowedPicture::look() {
  std::error_code error;
  const auto time = changed(shown_->file, error);
  if (error) return false;
  if (time == shown_->time) return true;
  shown_->time = time;
  try {
    shown_->actor->SetInputData(screen_data(read_image(shown_->file)));
    shown_->window.Render();
  } catch (const std::exception&) {
    // Not whole yet: it changes once more.
  }
  return true;
}

void open_picture(const std::filesystem::path& file, bool follows) {
  auto window = New<vtkRenderWindow>::New();
  window->SetWindowName(file.filename().c_str());
  FollowedPicture picture(file, *window);
  auto interactor = New<vtkRenderWindowInteractor>::New();
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(New<vtkInteractorStyleImage>::New());
  window->Render();
  auto looks = New<Looks>::New();
  if (follows) {
    looks->watch(picture);
    interactor->Initialize();
    interactor->AddObserver(vtkCommand::TimerEvent, looks);
    interactor->CreateRepeatingTimer(look_interval);
  }
  interactor->Start();
}

}  // namespace sightline::viz
