#pragma once
/// Files that appear whole or not at all.

#include <filesystem>
#include <string_view>

namespace sightline {

/// A file under a temporary name in the folder of its final one, renamed by commit() and removed when that is not
/// reached. The temporary name keeps the extension, because writers choose their format by it.
class OutputFile {
 public:
  /// Makes the temporary file, and the folders above it that are missing. Throws FileError where that is impossible or
  /// `path` is a folder.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Gives the file its name, replacing one that was there. Throws FileError.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

/// Throws FileError.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace sightline
