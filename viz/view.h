#pragma once

#include <string>
#include <vector>

namespace sightline::viz {

class WindowFrame;

/// What sightline-view does with the words of its command line: the exit status. `data_folder` is where scenes are read
/// from, unless the words say otherwise. A window is shown in the frame, if there is one, and on its own otherwise.
/// \throws std::invalid_argument for wrong usage; FileError, ScreenError
int run_view(const std::vector<std::string>& words, const std::string& data_folder, WindowFrame* frame = nullptr);

}  // namespace sightline::viz
