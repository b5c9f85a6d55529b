#pragma once

#include "viz/noise/noise_picture.h"

namespace sightline::viz {

/// Shows the picture, and others as keys ask for them, until the window is closed.
void open_noise_window(const NoisePicture& first);

}  // namespace sightline::viz
