#pragma once
/// The colors of a walk's picture, of Okabe and Ito's palette ("Color universal design", 2008).

#include "viz/paper.h"
#include "viz/walk/walk_state.h"

namespace sightline::viz {

inline constexpr Rgb orange{0.902, 0.624, 0}, sky{0.337, 0.706, 0.914}, blue{0, 0.447, 0.698},
    purple{0.8, 0.475, 0.655}, vermillion{0.835, 0.369, 0}, gray{0.6, 0.62, 0.66}, pale{0.86, 0.87, 0.89};

/// Of the plane that divides a node.
inline constexpr Rgb split_color{0, 0.62, 0.45};

/// A color of this opacity on white.
inline Rgb over_white(Rgb color, double opacity) {
  for (double& component : color) component = 1 - opacity * (1 - component);
  return color;
}

inline Rgb color_of(CellState state) {
  switch (state) {
    case CellState::unseen:
    case CellState::beside:
      return pale;
    case CellState::opened:
      return gray;
    case CellState::pending:
      return blue;
    case CellState::culled:
      return purple;
    case CellState::current:
      break;
  }
  return orange;
}

inline Rgb color_of(const WalkStep& step) {
  if (step.is_hit) return vermillion;
  switch (step.kind) {
    case WalkStep::Kind::visit:
      return gray;
    case WalkStep::Kind::leaf:
      return orange;
    case WalkStep::Kind::cull:
      return purple;
    case WalkStep::Kind::candidate:
      break;
  }
  return step.is_crossed ? sky : ink;
}

}  // namespace sightline::viz
