#pragma once

#include <vector>

#include "sightline/noise/noise_field.h"

namespace sightline::viz {

/// How much of a field's variance lies at which frequency, whatever its direction: of the noise of the plane, in a
/// window 64 lattice cells wide that is faded out toward its sides (Hann).
struct Spectrum {
  std::vector<double> frequencies;  ///< Cycles per cell, in even steps up to 4.
  std::vector<double> densities;    ///< The share of the variance per cycle per cell. They integrate to 1.
  double below_quarter = 0;         ///< The share below 1/4 cycle per cell.
  double above_two = 0;             ///< The share above 2.
  double axis_over_diagonal = 0;    ///< Power along the axes over that along the diagonals, within 10 degrees.
};

Spectrum spectrum_of(const NoiseField& field);

}  // namespace sightline::viz
