#pragma once

#include <filesystem>

namespace sightline::render_tool {

/// What sightline-render does: its exit status. `data_dir` is where make_scene() finds what it reads.
/// \throws std::invalid_argument for a wrong command line, FileError and others where something fails.
int run(int argc, const char* const* argv, const std::filesystem::path& data_dir);

}  // namespace sightline::render_tool
