#pragma once
/// A sphere that noise dents: in its normals only, or in truth.

#include <cstdint>
#include <memory>
#include <vector>

#include "sightline/noise/noise_field.h"
#include "sightline/query/tracer.h"
#include "viz/canvas.h"

namespace sightline::viz {

/// Heights on the unit sphere: amplitude times a field.
struct Dents {
  NoiseField field;
  double amplitude;

  NoiseSample<double, 3> at(const Vec3d& p) const;
};

enum class DentKind {
  none,       ///< The sphere itself.
  normals,    ///< Its normals turned by the height's gradient: it stays a sphere.
  displaced,  ///< A mesh whose vertices are moved by the height.
};

/// A picture of the sphere from the front, in parallel light rays, and what it took.
struct DentedSphere {
  ColorGrid shaded;
  std::vector<std::uint8_t> is_covered;  ///< 1 for each pixel of the silhouette.
  std::size_t triangles = 0, bytes = 0;
  double nodes = 0, candidates = 0;           ///< For each pixel covered.
  double noise_samples = 0;                   ///< Likewise, those for the mesh not counted.
  double build_seconds = 0, nanoseconds = 0;  ///< On the wall: of the mesh and its structure; for each pixel covered.
};

/// `reach` is how far the picture shows, from the center to its sides, in radii of the sphere. `divisions` is along an
/// edge of the cube that the mesh is a blown-up one of.
DentedSphere dented_sphere(DentKind kind, const Dents& dents, int size, double reach, int divisions);

}  // namespace sightline::viz
