#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viz/render_tool/request.h"

namespace sightline::render_tool {

/// What metadata tells beside what was asked for.
struct Provenance {
  std::uint32_t samples = 1;
  double share = 1;    ///< Of all samples that are on the film.
  double seconds = 0;  ///< That it took; told where dates are asked for.
};

/// The files that a request ends in: the picture first, then one for each AOV where the format has no room for it.
std::vector<std::filesystem::path> picture_files(const Request& request);

/// Writes them, each whole or not at all. \throws FileError
void write_pictures(const Request& request, const FilmState& film, const Provenance& provenance);

/// An AOV as a picture for eyes: near is light, far dark; normals as red, green and blue; ids as colors of their own;
/// cost and samples from dark to light on a logarithmic scale.
LayeredImage visible(const FilmState& film, Aov aov);

}  // namespace sightline::render_tool
