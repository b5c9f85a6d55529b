#include "viz/walk/walk_view.h"

#include <cmath>

#include "viz/partition_picture.h"

namespace sightline::viz {
namespace {

vtkSmartPointer<vtkRenderer> add_layer(vtkRenderWindow& window, int layer) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetLayer(layer);
  renderer->SetBackground(1, 1, 1);
  renderer->InteractiveOff();
  window.SetNumberOfLayers(std::max(window.GetNumberOfLayers(), layer + 1));
  window.AddRenderer(renderer);
  return renderer;
}

}  // namespace

SpaceCamera WalkLook::camera(const WalkModel& model) const {
  const Panel space = layout().space;
  return walk_camera(model, azimuth, elevation, zoom, space.width / space.height);
}

std::string command_of(const WalkModel& model, std::size_t step, const WalkLook& look) {
  const WalkLook usual;
  std::string text = model.command + " --ray=" + text_of(model.walk.ray) + " --step " + std::to_string(step) +
                     camera_text(look.azimuth, look.elevation, look.zoom);
  if (look.width != usual.width || look.height != usual.height) text += size_text(look.width, look.height);
  return text;
}

std::optional<Ray<float>> ray_through_pixel(const WalkModel& model, const WalkLook& look, int x, int y) {
  const WalkLayout layout = look.layout();
  const double ux = (x + 0.5) / layout.unit(), uy = (y + 0.5) / layout.unit();
  const Panel& p = layout.space;
  if (!p.contains(ux, uy)) return std::nullopt;
  const SpaceCamera camera = look.camera(model);
  const double right = 2 * (ux - p.x) / p.width - 1, up = 1 - 2 * (uy - p.y) / p.height;
  const double half = camera.half_height_at(camera.focus), distance = glm::length(camera.eye - camera.focus);
  const Vec3d direction =
      glm::normalize(half * (right * camera.aspect * camera.axes.x + up * camera.axes.y) - distance * camera.axes.z);
  const Vec3f toward(direction);
  const Stretch shown = shown_stretch(model.tracer->mesh().bounds(), {Vec3f(camera.eye), toward});
  return Ray<float>{Vec3f(camera.eye + shown.from * direction), toward};
}

WalkView::WalkView(vtkRenderWindow& window, const TriangleMesh& coarse, std::size_t whole, double scale)
    : scale_(scale),
      drawn_(coarse.size() < whole ? ", drawn as " + with_commas(coarse.size()) : ""),
      flat_(add_layer(window, 0)),
      labels_(nullptr),
      space_(window, coarse, scale) {
  labels_ = add_layer(window, 2);
}

void WalkView::show(const WalkModel& model, std::size_t step, const WalkLook& look) {
  const WalkLayout layout = look.layout();
  Canvas flat(layout.height(), scale_ * layout.unit());
  draw_panels(flat, layout, model, step, {drawn_, command_of(model, step, look)});
  flat_->RemoveAllViewProps();
  flat.add_to(*flat_);
  space_.place(layout.space, layout);
  space_.show(model, step, axes_toward(look.azimuth, look.elevation));
  turn(model, step, look);
  flat_->DrawOn();
}

void WalkView::turn(const WalkModel& model, std::size_t step, const WalkLook& look) {
  flat_->DrawOff();  // what it has drawn stays in the window
  const WalkLayout layout = look.layout();
  const SpaceCamera camera = look.camera(model);
  space_.aim(camera);
  labels_->RemoveAllViewProps();
  Canvas labels(layout.height(), scale_ * layout.unit());
  draw_labels(labels, layout, model, step, camera);
  labels.add_to(*labels_);
}

}  // namespace sightline::viz
