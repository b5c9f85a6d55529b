#pragma once
/// The picture of a carved solid, by the student's lists and by the library's.

#include "labs/check/check.h"

namespace sightline::labs::csg {

/// \throws SubjectTrouble
ImagePanel picture_by(Subject& subject);
ImagePanel true_picture();
/// Pixels in which another surface is seen, or one at another distance.
std::size_t wrong_pixels(Subject& subject);

}  // namespace sightline::labs::csg
