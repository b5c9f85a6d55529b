#pragma once
/// Scene and model files, changed at random.

#include <filesystem>
#include <string>
#include <vector>

#include "sightline/math/random.h"

namespace sightline {

/// A file that is read without complaint, and what it may lie beside.
struct SceneSeed {
  std::string name;  ///< With its extension.
  std::string bytes;
};

/// All of a folder that are scenes.
std::vector<SceneSeed> scene_seeds(const std::filesystem::path& folder);

/// Model files of at most so many bytes, below a folder; at most `most` of each extension, the smallest first.
std::vector<SceneSeed> model_seeds(const std::filesystem::path& folder, std::size_t most_bytes, std::size_t most);

/// Bytes changed, cut, doubled; of JSON also values, members and their names.
std::string mutant_of(const SceneSeed& seed, Random& random);

/// Reads a file and looks at all of what it says. Empty where it is read to a sound scene, or refused in one clear
/// line; else what is wrong.
std::string fault_of(const std::filesystem::path& path, bool& is_read);

}  // namespace sightline
