#pragma once

#include <filesystem>

#include "sightline/io/model.h"

struct aiScene;

namespace Assimp {
class IOSystem;
}

namespace sightline {

/// Lets Assimp read files in a folder and below it, and none elsewhere. The importer deletes it.
Assimp::IOSystem* files_within(const std::filesystem::path& folder);

/// What Assimp made of a file, copied. Its numbers are not checked yet.
Model model_of(const std::filesystem::path& path, const aiScene& scene);

}  // namespace sightline
