#pragma once
/// Lab 01: improved Perlin noise, and sums of it.

#include "sightline/math/vec.h"

namespace student {

using namespace sightline;

/// Every number from 0 to 255 once, in Perlin's order. Perlin, "Improving Noise", 2002.
inline constexpr std::array<std::uint8_t, 256> permutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,  69,  142,
    8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,  94,  252, 219, 203,
    117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136, 171, 168, 68,  175, 74,  165,
    71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,
    55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,
    18,  169, 200, 196, 135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250,
    124, 123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189,
    28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,
    129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,
    242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114,
    67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

/// How often lattice_hash() was asked; the budget counts it.
inline std::uint64_t hash_count = 0;

/// 6 t^5 - 15 t^4 + 10 t^3, for t from 0 to 1.
inline double fade(double t) {
  // lab:hole fade | 1. From 0 to 1 without a corner
  return t * t * t * (t * (t * 6 - 15) + 10);
  // lab:end
}

/// The random number of lattice point (x, y, z), from 0 to 255: P[(P[(P[x] + y)] + z)], everything modulo 256.
/// Coordinates may be negative: -1 is the same as 255.
inline int lattice_hash(int x, int y, int z) {
  ++hash_count;
  // lab:hole lattice_hash | 2. A random number for every lattice point
  const auto p = [](int i) -> int { return permutation[static_cast<std::size_t>(i & 255)]; };
  return p(p(p(x) + y) + z);
  // lab:end
}

/// The dot product of `way` with the gradient that the four lowest bits of the hash choose from the table in the
/// handout.
inline double gradient_dot(int hash, const Vec3d& way) {
  // lab:hole gradient_dot | 3. Twelve gradients
  const int h = hash & 15;
  const double u = h < 8 ? way.x : way.y;
  const double v = h < 4 ? way.y : h == 12 || h == 14 ? way.x : way.z;
  return ((h & 1) == 0 ? u : -u) + ((h & 2) == 0 ? v : -v);
  // lab:end
}

/// a at s = 0, b at s = 1.
inline double lerp(double a, double b, double s) { return a + s * (b - a); }

/// Improved Perlin noise at p, whose coordinates lie within +-2^30: 0 at every lattice point.
inline double noise(const Vec3d& p) {
  // lab:hole noise | 4. Eight corners
  const Vec3d cell = glm::floor(p), t = p - cell;
  const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y), z = static_cast<int>(cell.z);
  const auto corner = [&](int i, int j, int k) {
    return gradient_dot(lattice_hash(x + i, y + j, z + k), t - Vec3d(i, j, k));
  };
  const double u = fade(t.x), v = fade(t.y), w = fade(t.z);
  const auto edge = [&](int j, int k) { return lerp(corner(0, j, k), corner(1, j, k), u); };
  const auto face = [&](int k) { return lerp(edge(0, k), edge(1, k), v); };
  return lerp(face(0), face(1), w);
  // lab:end
}

/// The sum over k = 0, ..., octaves - 1 of noise(2^k p) / 2^k.
inline double fractal_sum(Vec3d p, int octaves) {
  double sum = 0;
  // lab:hole fractal_sum | 5. Octaves
  double amplitude = 1;
  for (int k = 0; k < octaves; ++k) {
    sum += amplitude * noise(p);
    p *= 2.0;
    amplitude /= 2;
  }
  // lab:end
  return sum;
}

/// The same with |noise|: Perlin's turbulence.
inline double turbulence(Vec3d p, int octaves) {
  double sum = 0;
  // lab:hole turbulence | 6. Turbulence
  double amplitude = 1;
  for (int k = 0; k < octaves; ++k) {
    sum += amplitude * std::abs(noise(p));
    p *= 2.0;
    amplitude /= 2;
  }
  // lab:end
  return sum;
}

}  // namespace student
