#pragma once
/// Noise as textures use it: at a frequency, in octaves, bent by more noise, and without what is too fine to be seen.

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "sightline/noise/field_options.h"
#include "sightline/noise/noise.h"

namespace sightline {

/// The sum over octaves i of gain^i f(noise(lacunarity^i frequency P)).
///
/// Where a footprint is given, the width of what one value stands for, say of a pixel on the surface, octaves give way
/// to their mean: wholly, and without being computed, where a cell is narrower than two footprints, so that its one
/// cycle is beyond Nyquist's limit; not at all where it is wider than four.
/// Perlin, "An Image Synthesizer", 1985; Musgrave, in Ebert et al., "Texturing and Modeling", 1994.
class NoiseField {
 public:
  /// \throws std::invalid_argument naming the option that is out of its range.
  explicit NoiseField(const FieldOptions& options = {});

  const FieldOptions& options() const { return options_; }

  /// That of the first octave, in lattice cells: without frequency or warp.
  const Noise& noise() const { return octaves_.front().noise; }
  /// How many octaves a footprint leaves to compute.
  int octaves_within(double footprint) const;
  /// The sum of all octaves' amplitudes: what bounds of noise are multiplied by.
  double amplitude() const;
  /// What a footprint takes from the octaves: the root of the sum of their amplitudes' squares, less what is left of
  /// each. Times the standard deviation of one octave, it is that of what is not seen.
  double lost_amplitude(double footprint) const;

  template <int dims, class T>
  T operator()(const glm::vec<dims, T>& p, T footprint = 0) const;
  /// The value with its exact derivative, but in footprints.
  template <int dims, class T>
  NoiseSample<T, dims> sample(const glm::vec<dims, T>& p, T footprint = 0) const;

  /// At many points at once, equal to single ones to the last bit. \throws std::invalid_argument where there are not as
  /// many results as points.
  template <int dims, class T>
  void values(std::span<const glm::vec<dims, T>> points, std::span<T> values, T footprint = 0) const;
  template <int dims, class T>
  void samples(std::span<const glm::vec<dims, T>> points, std::span<NoiseSample<T, dims>> samples,
               T footprint = 0) const;
  /// The same, with a footprint for each point.
  template <int dims, class T>
  void samples(std::span<const glm::vec<dims, T>> points, std::span<const T> footprints,
               std::span<NoiseSample<T, dims>> samples) const;

 private:
  struct Octave {
    Noise noise;
    double frequency, amplitude;
  };

  template <int dims, class T, bool has_gradient>
  class Block;
  /// `footprints` has one for all points, or one for each.
  template <bool has_gradient, int dims, class T, class Take>
  void for_blocks(std::span<const glm::vec<dims, T>> points, std::span<const T> footprints, const Take& take) const;

  /// 1 where nothing of an octave is too fine, 0 where all is.
  double weight_of(const Octave& octave, double footprint) const;

  FieldOptions options_;
  std::vector<Octave> octaves_;
  std::vector<Noise> warps_;     ///< Of each axis, where there is a warp.
  std::array<double, 2> means_;  ///< Of f(noise) in the plane and in space.
};

}  // namespace sightline
