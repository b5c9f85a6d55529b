#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sightline/io/leftovers.h"
#include "sightline/render/film.h"
#include "viz/child_process.h"

namespace sightline::render_tool {

/// A window of sightline-view beside this program, which follows a picture in a temporary file. Both go with this
/// object.
class Preview {
 public:
  /// Begins with a picture of what is on the film. Where there is nothing to show it with, one line on standard error
  /// says so, and nothing more happens.
  Preview(const FilmState& film, double exposure);

  bool is_shown() const { return window_.has_value(); }
  void show(const FilmState& film);

 private:
  std::filesystem::path file_;
  double exposure_;
  std::optional<Leftovers> leftovers_;
  std::optional<viz::RunningProgram> window_;
};

}  // namespace sightline::render_tool
