#pragma once
/// What sightline-stability asks beside its table of hard cases: families of questions that get harder, and rays by the
/// million at closed meshes.

#include <filesystem>
#include <ostream>

namespace sightline {

/// Whether the command line has --families or --leaks.
bool asks_hunts(int argc, const char* const* argv);

/// Returns 0 where all promises were kept and nothing leaked, else 1. \throws std::invalid_argument for wrong usage,
/// FileError for a file that cannot be written.
int run_hunts(int argc, const char* const* argv, const std::filesystem::path& data_dir, std::ostream& out,
              std::ostream& messages);

}  // namespace sightline
