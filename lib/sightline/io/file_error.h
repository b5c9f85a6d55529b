#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace sightline {

/// A file that cannot be read or written, told in one line: "file:line: expected ..., found ...".
class FileError : public std::runtime_error {
 public:
  /// `line` counts from 1; 0 where the place is not a line, and then left out. What is not printable in `expected` and
  /// `found`, which may quote the file, is replaced by '?', and long texts are cut.
  FileError(const std::filesystem::path& path, std::size_t line, const std::string& expected, const std::string& found);
};

}  // namespace sightline
