#include "viz/partition_window.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <algorithm>

#include "viz/command_text.h"
#include "viz/space_camera.h"

namespace sightline::viz {
namespace {

constexpr int lowest_width = 400, lowest_height = 300;

}  // namespace

PartitionWindow::PartitionWindow(const Tracer& tracer, const CellFilter& filter, const Caption& caption,
                                 const View& view, std::string command, std::ostream& commands, WindowFrame* frame)
    : InteractiveWindow({.name = "partitions",
                         .title = caption.title,
                         .width = view.width,
                         .height = view.height,
                         .tells_command = false},
                        frame, commands),
      tracer_(tracer),
      filter_(filter),
      caption_(caption),
      view_(view),
      first_view_(view),
      partition_(select_cells(tracer, filter)),
      command_(std::move(command)) {
  if (!filter_.deepest) filter_.deepest = partition_.deepest;
  first_filter_ = filter_;
  show();
}

std::string PartitionWindow::command() const {
  std::string text =
      command_ + " --depth " + std::to_string(filter_.shallowest) + ':' + std::to_string(*filter_.deepest);
  if (filter_.leaves_only) text += " --leaves";
  if (filter_.slice) {
    text += std::string(" --slice ") + "xyz"[filter_.slice->axis] + '=' + shortest(filter_.slice->share);
  }
  if (filter_.max_cells != CellFilter{}.max_cells) text += " --max-cells " + std::to_string(filter_.max_cells);
  if (view_.azimuth) text += option_text("--azimuth", shortest(*view_.azimuth));
  if (view_.elevation) text += option_text("--elevation", shortest(*view_.elevation));
  if (view_.zoom != 1) text += option_text("--zoom", shortest(view_.zoom));
  return text + size_text(view_.width, view_.height);
}

std::vector<WindowKey> PartitionWindow::keys() const {
  std::vector<WindowKey> keys{{"drag", "turns"},
                              {"wheel, + and -", "closer and farther"},
                              {"Up, Down", "one depth less, one more"},
                              {"L", "leaves only"}};
  if (filter_.slice) keys.push_back({"Left, Right", "moves the slice"});
  keys.push_back({"X, Y, Z", "cuts across that axis, or no longer"});
  keys.push_back({"R", "back to the beginning"});
  return keys;
}

SharedView PartitionWindow::shared_view() const { return {{}, view_.azimuth, view_.elevation, view_.zoom}; }

void PartitionWindow::answer_key(const std::string& key) {
  CellFilter filter = filter_;
  const std::string axes = "xyz";
  const std::size_t axis = key.size() == 1 ? axes.find(static_cast<char>(key[0] | 0x20)) : std::string::npos;
  if (key == "Up") {
    filter.deepest = std::max(filter.shallowest, *filter.deepest - 1);
  } else if (key == "Down") {
    filter.deepest = std::min(*filter.deepest, partition_.total_deepest) + 1;
  } else if (key == "l" || key == "L") {
    filter.leaves_only = !filter.leaves_only;
  } else if (filter.slice && (key == "Left" || key == "Right")) {
    filter.slice->share = std::clamp(rounded(filter.slice->share + (key == "Left" ? -0.02 : 0.02), 1000), 0.0, 1.0);
  } else if (axis != std::string::npos) {
    const bool is_off = filter.slice && filter.slice->axis == static_cast<int>(axis);
    filter.slice = is_off ? std::nullopt : std::optional(Slice{static_cast<int>(axis), 0.5});
    view_.azimuth.reset(), view_.elevation.reset();
  } else if (key == "plus" || key == "KP_Add") {
    return zoom(1.15);
  } else if (key == "minus" || key == "KP_Subtract") {
    return zoom(1 / 1.15);
  } else if (key == "r" || key == "R") {
    const int width = view_.width, height = view_.height;
    view_ = first_view_;
    view_.width = width, view_.height = height;
    filter = first_filter_;
  } else {
    return;
  }
  choose(filter);
}

/// Keeps the former picture where the new filter leaves nothing to see.
void PartitionWindow::choose(const CellFilter& filter) {
  Partition partition = select_cells(tracer_, filter);
  if (partition.cells.empty()) return;
  filter_ = filter;
  partition_ = std::move(partition);
  show();
}

void PartitionWindow::press() {
  is_held_ = true, has_turned_ = false;
  from_ = hand();
}

/// Until the hand lets go only the camera goes around: what is drawn suits where it stood.
void PartitionWindow::move() {
  if (!is_held_) return;
  const auto at = hand();
  if (at == from_) return;
  constexpr double degrees = 0.4;  // for one pixel
  const Angles now = angles_of(view_, filter_.slice);
  view_.azimuth = rounded(std::fmod(now.azimuth - degrees * (at[0] - from_[0]), 360), 10);
  view_.elevation = std::clamp(rounded(now.elevation - degrees * (at[1] - from_[1]), 10), -90.0, 90.0);
  from_ = at;
  has_turned_ = true;
  auto* space = vtkRenderer::SafeDownCast(window().GetRenderers()->GetItemAsObject(1));
  vtkCamera& camera = *space->GetActiveCamera();
  const Axes axes = axes_toward(*view_.azimuth, *view_.elevation);
  const Vec3d eye = Vec3d(camera.GetFocalPoint()[0], camera.GetFocalPoint()[1], camera.GetFocalPoint()[2]) +
                    camera.GetDistance() * axes.z;
  camera.SetPosition(&eye[0]);
  camera.SetViewUp(&axes.y[0]);
  space->ResetCameraClippingRange();
  render();
}

void PartitionWindow::release() {
  is_held_ = false;
  if (has_turned_) show();
}

void PartitionWindow::zoom(double factor) {
  view_.zoom = std::clamp(rounded(view_.zoom * factor, 1000), 0.1, 100.0);
  show();
}

void PartitionWindow::fit() {
  const int width = std::max(area()[0], lowest_width), height = std::max(area()[1], lowest_height);
  if (width == view_.width && height == view_.height) return;
  view_.width = width, view_.height = height;
  show();
}

void PartitionWindow::show() {
  picture().show_in(window(), 1);
  render();
}

}  // namespace sightline::viz
