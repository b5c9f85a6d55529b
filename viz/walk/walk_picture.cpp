#include "viz/walk/walk_picture.h"

#include <algorithm>
#include <chrono>

#include "viz/walk/coarse_mesh.h"
#include "viz/walk/walk_window.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

template <class Draw>
double median_of(int count, vtkRenderWindow& window, Draw&& draw) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  for (int i = 0; i < count; ++i) {
    const auto start = Clock::now();
    draw(i);
    window.Render();
    window.WaitForCompletion();
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  std::ranges::nth_element(times, times.begin() + count / 2);
  return times[static_cast<std::size_t>(count / 2)];
}

}  // namespace

void write_walk_png(const std::filesystem::path& path, const WalkModel& model, std::size_t step, const WalkLook& look,
                    const TriangleMesh& coarse) {
  write_picture(path, look.width, look.height, [&](vtkRenderWindow& window, int scale) {
    WalkView(window, coarse, model.tracer->mesh().size(), scale).show(model, step, look);
  });
}

FrameTimes measure_frames(const WalkModel& model, const WalkLook& look, int count) {
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(look.width, look.height);
  const TriangleMesh coarse = coarse_mesh(model.tracer->mesh(), WalkWindow::most_triangles);
  WalkView view(*window, coarse, model.tracer->mesh().size(), 1);
  view.show(model, 0, look);
  window->Render();
  FrameTimes times{0, 0, coarse.size()};
  times.turn = median_of(count, *window, [&](int i) {
    WalkLook turned = look;
    turned.azimuth += 3 * i;
    view.turn(model, model.last_step(), turned);
  });
  times.step = median_of(count, *window,
                         [&](int i) { view.show(model, static_cast<std::size_t>(i) % (model.last_step() + 1), look); });
  return times;
}

}  // namespace sightline::viz
