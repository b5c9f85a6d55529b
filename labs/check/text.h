#pragma once
/// Numbers for people: as short as they can be and still be the same.

#include <charconv>
#include <string>

#include "sightline/math/vec.h"

namespace sightline::labs {

inline std::string number(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

/// "(1 2 0.5)".
inline std::string text_of(const Vec3d& v) { return "(" + number(v.x) + " " + number(v.y) + " " + number(v.z) + ")"; }

}  // namespace sightline::labs
