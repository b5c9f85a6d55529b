#pragma once
/// What a picture costs, effect by effect.

#include <string>
#include <vector>

#include "sightline/render/render_counters.h"
#include "sightline/render/renderer.h"
#include "sightline/render/stage_clock.h"

namespace sightline {

/// What some samples of a picture took.
struct Bill {
  RenderCounters counters;
  StageTimes times;
  std::uint64_t samples = 0;  ///< Of all pixels together.
};

/// Takes samples of squares of pixels, spread evenly over the picture: about `pixels` of them, up to `samples` of each.
/// On one thread.
Bill sample_bill(const Renderer& renderer, std::uint32_t pixels = 20'000, std::uint32_t samples = 4);

/// The plan: each effect, who asked for it, and what it took of the bill; what was asked for and is not simulated, and
/// why; which integrator runs. Lines of text, the effects' columns aligned.
std::string plan_text(const Renderer& renderer, const Bill& bill);

}  // namespace sightline
