#pragma once

#include <memory>
#include <vector>

#include "sightline/render/render_scene.h"
#include "sightline/render/render_settings.h"

namespace sightline {

/// Moments of a shutter that is open while something moves. More show motion more evenly; each takes memory for what
/// moves.
inline constexpr std::uint32_t most_moments = 16;

/// The scene's camera that the settings name, or else its first; nullptr where it has none.
/// \throws std::invalid_argument listing the cameras, where there is none of that name.
const SceneCamera* camera_of(const Scene& scene, const RenderSettings& settings);

/// The scene as it stands at the settings' time, or, where the shutter is open, at evenly spread times from there on;
/// at most `samples` of them. Where a scene has no light at all, a lamp shines from beside the camera, and a little
/// comes from everywhere, before a plain background.
/// \throws as TraceWorld does.
std::vector<std::unique_ptr<Moment>> moments_of(const Scene& scene, const RenderSettings& settings,
                                                std::uint32_t samples);

}  // namespace sightline
