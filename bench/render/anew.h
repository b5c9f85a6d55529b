#pragma once

#include "sightline/render/picture_source.h"
#include "sightline/render/render_scene.h"

namespace sightline::bench {

/// A renderer for one kind of scene, written anew for it, sixteen rays at a time on the stack: Lambert surfaces of
/// solids, of one color or with a procedural texture, a single directional lamp and its shadow, one sample through each
/// pixel's middle, before nothing. It knows of no other effect, and counts nothing. Of other scenes it makes nonsense.
/// The same bits as the renderer's.
void add_anew_samples(const RenderScene& scene, TileBuffer& tile);

}  // namespace sightline::bench
