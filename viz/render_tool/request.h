#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sightline/render/film_image.h"
#include "sightline/render/render_settings.h"

namespace sightline::render_tool {

/// A command line of sightline-render.
struct Request {
  std::string scene;
  std::string out;  ///< Of the picture; never empty.
  RenderSettings settings;
  std::vector<Aov> aovs;
  double exposure = 0;              ///< In powers of two.
  double checkpoint_interval = 60;  ///< In seconds; 0: only when stopped.
  bool is_plan = false;             ///< Nothing is rendered.
  bool resumes = false, previews = false, explains = false, is_quiet = false, is_dated = false;
  std::vector<std::pair<std::string, std::string>> told;  ///< What was asked for, as pictures tell it: name and value.
};

/// Of it, or the status to end with at once, where help was asked for and has been printed. Nothing is read or written.
/// \throws std::invalid_argument
std::optional<int> parse_request(int argc, const char* const* argv, Request& request);

}  // namespace sightline::render_tool
