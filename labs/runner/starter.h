#pragma once
/// Starters are the solutions with what is to be written taken out, so that the two cannot drift apart.
///
///     // lab:hole FUNCTION | SECTION OF THE HANDOUT
///     ... what the student writes ...
///     // lab:end
///
/// becomes a call of not_yet_implemented(). What stands between "// lab:cut" and "// lab:end" is left out whole.

#include <filesystem>
#include <string>
#include <vector>

namespace sightline::labs {

/// A file of a lab with its holes. \throws FileError where the marks of `path`, whose text this is, do not fit together
std::string starter_of(const std::filesystem::path& path, const std::string& solution);

/// The lines that starter_of leaves out, blanks at both ends removed: what must not be found in a handout.
std::vector<std::string> secret_lines(const std::filesystem::path& path, const std::string& solution);

}  // namespace sightline::labs
