#pragma once
/// A page that shows a WebModel in any browser: one file that asks for nothing else.

#include <string>

#include "viz/web/web_model.h"

namespace sightline::viz {

/// Whether three.js was there when this was built.
bool has_web_library();

/// \throws std::runtime_error without three.js, in one line that says what to install
std::string web_page(const WebModel& model);

}  // namespace sightline::viz
