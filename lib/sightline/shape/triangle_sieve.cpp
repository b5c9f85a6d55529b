#include "sightline/shape/triangle_sieve.h"

namespace sightline {

void TriangleBlock::store(const Triangle& triangle, std::uint32_t id, float* rows_begin, std::uint32_t count,
                          std::uint32_t lane) {
  float* at = rows_begin + lane;
  const auto write = [&](float value) { *std::exchange(at, at + count) = value; };
  for (const Vec3f* corner : {&triangle.a, &triangle.b, &triangle.c}) {
    for (int axis = 0; axis < 3; ++axis) write((*corner)[axis]);
  }
  write(std::bit_cast<float>(id));
}

}  // namespace sightline
