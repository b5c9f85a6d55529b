#include "sightline/io/file_error.h"

#include <string_view>

namespace sightline {
namespace {

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  return line;
}

/// Half a character of UTF-8, or text that never was any, must not reach a terminal.
std::string plain(std::string_view text) {
  constexpr std::size_t longest = 300;
  std::string line = one_line(text.substr(0, longest));
  for (char& c : line) {
    if (static_cast<unsigned char>(c) > 0x7f) c = '?';
  }
  return text.size() > longest ? line + "..." : line;
}

}  // namespace

FileError::FileError(const std::filesystem::path& path, std::size_t line, const std::string& expected,
                     const std::string& found)
    : std::runtime_error(one_line(path.string()) + ":" + (line > 0 ? std::to_string(line) + ":" : "") + " expected " +
                         plain(expected) + ", found " + plain(found)) {}

}  // namespace sightline
