#pragma once
/// A scene made ready to be rendered.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sightline/render/effect.h"
#include "sightline/render/lamps.h"
#include "sightline/render/sky.h"
#include "sightline/render/surface_material.h"
#include "sightline/render/surfaces.h"
#include "sightline/render/trace_world.h"
#include "sightline/scene/camera.h"
#include "sightline/scene/scene.h"

namespace sightline {

/// A camera with a lens, at one moment.
struct Lens {
  Camera camera;
  double radius = 0;          ///< 0 is a pinhole.
  double focus_distance = 1;  ///< Along the view.
};

/// What there is at one moment of the time that the shutter is open.
///   R1  Where nothing is transparent, rays to lights ask `world`. Else they ask `opaque`, and go through what is in
///       `clear`, which together hold what is in `world`.
struct Moment {
  Scene posed;  ///< Heavy parts are shared with the other moments'.
  std::unique_ptr<TraceWorld> world, opaque, clear;
  std::unique_ptr<Surfaces> surfaces, clear_surfaces;
  std::vector<Lamp> lamps;
  std::uint32_t area_lamps = 0;  ///< How many of them are areas.
  Lens lens;
};

/// What integrators read. Immutable.
struct RenderScene {
  std::vector<std::unique_ptr<const Moment>> moments;  ///< At least one; samples take turns.
  std::unique_ptr<const MaterialTable> materials;
  std::unique_ptr<const Sky> sky;
  Ambient ambient;
  Fog fog;

  Effects effects;  ///< Those that are simulated.
  std::uint32_t depth = 8;
  double cut_off = 0;
  std::uint32_t light_samples = 1;
  double shadow_error2 = 0;  ///< The square that rays to area lamps may add to a sample's luminance; 0: all are sent.
  std::uint64_t seed = 0;
  bool has_sky = false;        ///< That is not black.
  bool sky_lights = false;     ///< Surfaces that scatter, too.
  bool has_footprints = true;  ///< Textures are filtered as wide as a pixel.
};

}  // namespace sightline
