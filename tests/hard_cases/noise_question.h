#pragma once
/// What noise is at a point, in fifty digits, and as a first program has it.

#include <array>
#include <glm/geometric.hpp>
#include <string>

#include "sightline/noise/noise.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {

/// Holds a value against the definition: gradients, or values, of the corners of the cell, blended in fifty digits. It
/// is within the bound where it is off by no more than 8 units in the last place of `size`: the way into the cell is
/// exact, so what rounds are a dozen operations on numbers below 2 (tests/noise/definition_test.cpp). On a lattice line
/// they are below twice the way from the nearest lattice point, if that is so small that the ease is 0 or 1. Errors are
/// told as parts of `size`: the value itself may be 0.
template <class T>
void judge_noise(Tally& tally, const Noise& noise, const glm::dvec3& at, T got, double size = 1);

inline constexpr std::array lattice_noises{NoiseKind::perlin, NoiseKind::improved, NoiseKind::value};
inline constexpr std::array gradient_noises{NoiseKind::perlin, NoiseKind::improved};

template <class T>
std::string who_asks(NoiseKind kind, std::string_view more = "") {
  return std::string(noise_infos[static_cast<std::size_t>(kind)].name) + (sizeof(T) == 4 ? ", float" : ", double") +
         std::string(more);
}

/// Gradient noise with the cubic ease, all in T, over the gradients that `noise` has. `cell_of` finds the lattice
/// point below a coordinate.
template <class T, class CellOf>
T naive_noise(const Noise& noise, const glm::vec<3, T>& p, const CellOf& cell_of) {
  const glm::vec<3, T> cell(cell_of(p.x), cell_of(p.y), cell_of(p.z)), f = p - cell, s = f * f * (T(3) - T(2) * f);
  std::array<T, 8> at{};
  for (int c = 0; c < 8; ++c) {
    const glm::vec<3, T> side(c & 1, c >> 1 & 1, c >> 2);
    const glm::vec<3, T> gradient(noise.sample(glm::dvec3(cell + side)).gradient);
    at[static_cast<std::size_t>(c)] = glm::dot(gradient, f - side);
  }
  for (int axis = 0, count = 4; axis < 3; ++axis, count /= 2) {
    for (std::size_t c = 0; c < static_cast<std::size_t>(count); ++c) {
      at[c] = at[2 * c] + s[axis] * (at[2 * c + 1] - at[2 * c]);
    }
  }
  return at[0];
}

}  // namespace sightline::hard
