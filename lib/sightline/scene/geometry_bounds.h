#pragma once

#include "sightline/math/enclosure.h"
#include "sightline/scene/scene.h"

namespace sightline {

/// What holds a geometry in its own coordinates.
/// \throws std::invalid_argument where a solid makes no sense, as Solid does.
Enclosure enclosure_of(const Geometry& geometry);

}  // namespace sightline
