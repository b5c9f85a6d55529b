#pragma once
/// Which effects a scene calls for, and what in it does.

#include <string>
#include <vector>

#include "sightline/render/effect.h"
#include "sightline/render/render_scene.h"

namespace sightline {

/// Something asks for an effect, such as "material 'glass' of /table/cup and 3 more".
struct EffectRequest {
  Effect effect;
  std::string who;
};

struct SceneAnalysis {
  Effects effects;                      ///< Those that are asked for and matter.
  std::vector<EffectRequest> requests;  ///< In the effects' order.
  std::vector<EffectRequest> declined;  ///< Asked for, and not simulated: why.
};

/// Of what is there at one moment. Only what stands in the world asks for something: an element that is hidden, one
/// below no root, a material that nothing is made of, a texture of such a material, and an operand that a solid has
/// lost ask for nothing.
/// \param is_moving whether the shutter is open for a time in which something moves.
SceneAnalysis analyze(const Moment& moment, const MaterialTable& materials, const Sky& sky, bool is_moving,
                      std::uint32_t samples);

}  // namespace sightline
