#pragma once

#include <filesystem>
#include <string>

namespace sightline {

/// All of a regular file. Throws FileError: no such file, a folder or device, not readable, or empty.
std::string read_bytes(const std::filesystem::path& path);

}  // namespace sightline
