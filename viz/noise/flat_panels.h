#pragma once
/// Panels of noise that are drawn in the plane.

#include <optional>

#include "viz/noise/field_grid.h"
#include "viz/noise/lattice_cell.h"
#include "viz/noise/panel.h"

namespace sightline::viz {

/// What all panels are about.
struct NoiseLook {
  NoiseField field;
  double x = 0, y = 0;          ///< The lower left corner of what is shown.
  double extent = 4;            ///< Of what is shown along each side.
  double slice = 0.5;           ///< z
  glm::dvec2 point{1.6, 1.35};  ///< Whose cell is explained; in lattice cells.
  std::optional<double> azimuth = std::nullopt,
                        elevation =
                            std::nullopt;  ///< Of what is in space, as of all cameras; not given: near the usual.
  double zoom = 1;
  double unit = 1;  ///< Pixels of the picture for each unit of the canvas.
};

/// Values as colors, with their scale.
void draw_slice(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look);
/// Arrows uphill.
void draw_gradients(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look);
/// The cell of a point, with the lattice around it.
void draw_lattice(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look);
/// White noise to the left, this noise to the right.
void draw_coherence(Canvas& canvas, const PanelFrame& panel, const NoiseLook& look);

}  // namespace sightline::viz
