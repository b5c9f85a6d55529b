#pragma once

#include <filesystem>

namespace sightline::bench {

/// A folder for files that nobody needs afterwards. It goes with this object, and as well where Ctrl-C or the end of
/// the session ends the program. One at a time.
class ScratchFolder {
 public:
  /// \throws std::runtime_error where none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// Of a file in it, of which there may be four.
  std::filesystem::path file(const char* name);

 private:
  std::filesystem::path path_;
};

}  // namespace sightline::bench
