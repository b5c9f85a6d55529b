#include "bench/solids/scratch_folder.h"

#include <stdlib.h>

#include <stdexcept>
#include <string>

namespace sightline::bench {

ScratchFolder::ScratchFolder(const std::vector<std::string_view>& names) {
  std::string pattern = (std::filesystem::temp_directory_path() / "sightline-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("expected to make a folder " + pattern + ", found none made");
  path_ = pattern;
  std::vector<std::filesystem::path> files;
  for (const std::string_view name : names) files.push_back(path_ / name);
  leftovers_ = std::make_unique<Leftovers>(files, std::vector{path_});
}

}  // namespace sightline::bench
