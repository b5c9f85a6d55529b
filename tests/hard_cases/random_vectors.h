#pragma once
/// Vectors by chance, and as text.

#include <string>

#include "sightline/math/random.h"
#include "sightline/math/vec.h"
#include "tests/hard_cases/solid_question.h"

namespace sightline::hard {

/// In the cube from -1 to 1.
inline Vec3d random_in_cube(Random& random) {
  const double x = 2 * random.uniform_double() - 1, y = 2 * random.uniform_double() - 1;
  return {x, y, 2 * random.uniform_double() - 1};
}

inline Vec3d random_on_sphere(Random& random) {
  for (;;) {
    const Vec3d v = random_in_cube(random);
    const double length = glm::length(v);
    if (length > 0.1 && length < 1) return v / length;
  }
}

/// Of whole numbers from -size to size.
inline Vec3d random_lattice_vector(Random& random, std::uint32_t size) {
  const auto one = [&] { return double(random.below(2 * size + 1)) - size; };
  const double x = one(), y = one();
  return {x, y, one()};
}

inline std::string vector_text(const Vec3d& v) {
  return "(" + all_digits(v.x) + ", " + all_digits(v.y) + ", " + all_digits(v.z) + ")";
}

}  // namespace sightline::hard
