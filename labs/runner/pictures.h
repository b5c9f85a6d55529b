#pragma once
/// Drawings become pictures: by the viewer, a program of its own, so that checks need nothing that draws.

#include <filesystem>

#include "labs/runner/workshop.h"

namespace sightline::labs {

/// Writes the drawing beside the picture, as JSON, and has the viewer draw it. False, and one line in `problem`, where
/// that is not built or fails.
bool draw_picture(const Workshop& workshop, const Drawing& drawing, const std::filesystem::path& picture,
                  std::string& problem);

}  // namespace sightline::labs
