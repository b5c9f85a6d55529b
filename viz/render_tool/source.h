#pragma once
/// What the tool asks of the renderer, and nothing else: tests put another source behind the same tool.

#include <iosfwd>
#include <memory>
#include <string>

#include "sightline/render/picture_source.h"
#include "sightline/render/render_settings.h"
#include "sightline/scene/scene.h"

namespace sightline::render_tool {

/// \throws std::invalid_argument for settings that the scene does not allow.
std::unique_ptr<PictureSource> source_of(std::shared_ptr<const Scene> scene, const RenderSettings& settings);

/// What will be simulated, and who asked for it.
void print_plan(const PictureSource& source, std::ostream& out);

/// What was simulated, how often, and what it took.
std::string bill_of(const PictureSource& source, const RenderCounters& counters, double seconds);

}  // namespace sightline::render_tool
