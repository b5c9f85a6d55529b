#pragma once
/// Where solids stand, as files say it.

#include "sightline/io/json_value.h"
#include "sightline/shape/line.h"

namespace sightline {

/// Exactly 3 numbers.
Vec3d vector_of(const JsonValue&);

/// Of {"translate": [x, y, z], "rotate": {"axis": [x, y, z], "degrees": angle}, "scale": size or [x, y, z]}, each of
/// which may be missing: scaled first, then turned counter-clockwise as seen from the axis' tip, then moved. Where only
/// whole numbers and powers of two, or quarter turns about coordinate axes, are asked for, nothing is rounded.
/// \throws FileError for a scale of 0 and an axis without length.
Frame frame_of(const JsonValue&);

}  // namespace sightline
