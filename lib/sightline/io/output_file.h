#pragma once
/// Files that appear whole or not at all.

#include <filesystem>
#include <memory>
#include <string_view>

namespace sightline {

class Leftovers;

/// A file under a temporary name in the folder of its final one, renamed by commit() and removed when that is not
/// reached. The temporary name keeps the extension, because writers choose their format by it.
///   O1  Without commit() nothing is left: neither the file nor a folder made for it that is still empty. That also
///       holds where a signal such as that of Ctrl-C ends the program, unless the program handles that signal itself.
///   O2  Symbolic links stay: what they point to is replaced, and keeps its mode.
///   O3  What is there and is no regular file (a device, a pipe), or is reached through /dev/stdout or its like, is
///       never replaced: temporary() is that file itself, and what is written to it is out at once.
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
  std::filesystem::path target_;  ///< Where the symbolic links of path_ lead.
  std::filesystem::path temporary_;
  std::unique_ptr<Leftovers> leftovers_;  ///< What goes without commit(); none where O3 holds.
};

/// Throws FileError.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace sightline
