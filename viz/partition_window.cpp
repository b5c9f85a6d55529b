#include "viz/partition_window.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <string_view>

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

/// Answers keys with a changed filter and a new picture from where the camera stands.
class Keys : public vtkCommand {
 public:
  static Keys* New() { return new Keys; }

  void watch(const Tracer& tracer, const CellFilter& filter, const PartitionPicture& picture, vtkRenderWindow& window) {
    tracer_ = &tracer;
    filter_ = filter;
    picture_ = &picture;
    window_ = &window;
    if (!filter_.deepest) filter_.deepest = picture.partition.deepest;
  }

  void Execute(vtkObject* caller, unsigned long, void*) override {
    auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
    const std::string_view key = interactor->GetKeySym() ? interactor->GetKeySym() : "";
    CellFilter filter = filter_;
    if (key == "Up") {
      filter.deepest = std::max(filter.shallowest, *filter.deepest - 1);
    } else if (key == "Down") {
      filter.deepest = std::min(*filter.deepest, picture_->partition.total_deepest) + 1;
    } else if (key == "l" || key == "L") {
      filter.leaves_only = !filter.leaves_only;
    } else if (filter.slice && (key == "Left" || key == "Right")) {
      filter.slice->share = std::clamp(filter.slice->share + (key == "Left" ? -0.02 : 0.02), 0.0, 1.0);
    } else {
      return;
    }
    show(filter, *interactor);
  }

 private:
  /// Keeps the former picture where the new filter leaves nothing to see.
  void show(const CellFilter& filter, vtkRenderWindowInteractor& interactor) {
    const Partition partition = select_cells(*tracer_, filter);
    if (partition.cells.empty()) return;
    filter_ = filter;
    const auto camera = camera_of(*window_);
    PartitionPicture picture{picture_->mesh, partition, filter.slice, picture_->caption, picture_->view};
    picture.view.width = window_->GetSize()[0];
    picture.view.height = window_->GetSize()[1];
    picture.show_in(*window_, 1);
    space(*window_).SetActiveCamera(camera);
    space(*window_).ResetCameraClippingRange();
    interactor.Render();
  }

  static vtkRenderer& space(vtkRenderWindow& window) {
    return *vtkRenderer::SafeDownCast(window.GetRenderers()->GetItemAsObject(1));
  }
  static vtkSmartPointer<vtkCamera> camera_of(vtkRenderWindow& window) { return space(window).GetActiveCamera(); }

  const Tracer* tracer_ = nullptr;
  CellFilter filter_;
  const PartitionPicture* picture_ = nullptr;
  vtkRenderWindow* window_ = nullptr;
};

}  // namespace

void open_partition_window(const Tracer& tracer, CellFilter filter, const PartitionPicture& first) {
  auto window = New<vtkRenderWindow>::New();
  window->SetWindowName(first.caption.title.c_str());
  window->SetSize(first.view.width, first.view.height);
  window->SetMultiSamples(8);
  first.show_in(*window, 1);

  auto interactor = New<vtkRenderWindowInteractor>::New();
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(New<vtkInteractorStyleTrackballCamera>::New());
  auto keys = New<Keys>::New();
  keys->watch(tracer, filter, first, *window);
  interactor->AddObserver(vtkCommand::KeyPressEvent, keys);
  window->Render();
  interactor->Start();
}

}  // namespace sightline::viz
