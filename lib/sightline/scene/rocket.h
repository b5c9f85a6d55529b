#pragma once
/// A rocket's shape; how it flies is told in rocket_motion.h, and neither needs the other.

#include "sightline/scene/scene.h"

namespace sightline {

/// Nodes "/rocket" with "body", "nose", "fin 1" to "fin 4" and "flame" below it; it stands on y = 0, 5.5 tall.
Scene rocket();

}  // namespace sightline
