#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sightline/io/image_file.h"

namespace sightline::scenes_tool {

struct Shown {
  std::string spec, description, facts;
  Image picture;
};

/// Writes each picture, all of them on one sheet (sheet.png), and a page that tells of them (index.html).
/// \throws FileError.
void write_page(const std::filesystem::path& folder, const std::vector<Shown>& list);

}  // namespace sightline::scenes_tool
