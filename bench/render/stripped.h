#pragma once

#include "sightline/render/picture_source.h"
#include "sightline/render/render_scene.h"

namespace sightline::bench {

/// The renderer with all deleted by hand that a scene of one kind does not use: Lambert surfaces of solids, of one
/// color or with a procedural texture, a single directional lamp and its shadow, one sample through each pixel's
/// middle, before nothing. What is left goes as render/integrator_of.h has it, wave by wave. It knows of no other
/// effect, and counts nothing. Of other scenes it makes nonsense. The same bits as the renderer's.
void add_stripped_samples(const RenderScene& scene, TileBuffer& tile);

}  // namespace sightline::bench
