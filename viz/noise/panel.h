#pragma once
/// One of the parts that a sheet of pictures is made of.

#include <string>
#include <vector>

#include "viz/canvas.h"
#include "viz/paper.h"

namespace sightline::viz {

/// In the canvas's units.
struct PanelFrame {
  double x, y, width, height;
};

/// Writes a panel's title, and below it lines that say what is seen. What is left is for the picture.
inline PanelFrame framed(Canvas& canvas, const PanelFrame& panel, const std::string& title,
                         const std::vector<std::string>& lines) {
  canvas.text({panel.x, panel.y + 10}, title, {17, ink, Canvas::Align::left, true});
  double y = panel.y + 32;
  for (const std::string& line : lines) {
    canvas.text({panel.x, y}, line, {13, soft_ink});
    y += 18;
  }
  return {panel.x, y, panel.width, panel.y + panel.height - y};
}

/// The largest square in the frame, at its left.
inline PanelFrame square_of(const PanelFrame& frame) {
  const double side = frame.width < frame.height ? frame.width : frame.height;
  return {frame.x, frame.y, side, side};
}

}  // namespace sightline::viz
