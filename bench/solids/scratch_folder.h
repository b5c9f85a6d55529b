#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "sightline/io/leftovers.h"

namespace sightline::bench {

/// A folder for files that nobody needs afterwards. It goes with this object, and as well where a signal ends the
/// program (io/leftovers.h).
class ScratchFolder {
 public:
  /// All that may be in it. \throws std::runtime_error where none can be made.
  explicit ScratchFolder(const std::vector<std::string_view>& names);

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<Leftovers> leftovers_;
};

}  // namespace sightline::bench
