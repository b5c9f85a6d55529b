#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

#include "sightline/render/exposure.h"

namespace sightline::render_tool {

/// What exposes a film, as expose() does.
using Exposer =
    std::function<bool(Film&, const PictureSource&, const ExposureOptions&, const std::atomic<bool>& stops)>;

/// What sightline-render does: its exit status. `data_dir` is where make_scene() finds what it reads.
/// \throws std::invalid_argument for a wrong command line, FileError and others where something fails.
int run(int argc, const char* const* argv, const std::filesystem::path& data_dir, const Exposer& exposer = expose);

/// The source of the picture that the command line asks for. Throws as run() does, and where it asks for none.
std::unique_ptr<PictureSource> source_of_command(int argc, const char* const* argv,
                                                 const std::filesystem::path& data_dir);

}  // namespace sightline::render_tool
