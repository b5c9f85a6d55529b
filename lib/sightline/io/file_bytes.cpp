#include "sightline/io/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "sightline/io/file_error.h"

namespace sightline {

std::string read_bytes(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  // A pipe or a device might never end.
  if (!std::filesystem::is_regular_file(status)) {
    throw FileError(path, 0, "a file",
                    std::filesystem::is_directory(status) ? "a folder"
                    : error                               ? error.message()
                    : std::filesystem::exists(status)     ? "a device or a pipe"
                                                          : "nothing");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path, 0, "a file that can be read", std::strerror(errno));
  std::string bytes(std::filesystem::file_size(path, error), '\0');
  if (!error) file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (error || !file) throw FileError(path, 0, "a file that can be read", "a failure on the way");
  if (bytes.empty()) throw FileError(path, 0, "a file with something in it", "an empty one");
  return bytes;
}

}  // namespace sightline
