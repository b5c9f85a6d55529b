#pragma once

#include <filesystem>
#include <vector>

#include "sightline/io/model.h"

namespace sightline {

/// Reads any format that Assimp knows, in a process of its own (child_process.h), because Assimp 5.2 neither refuses
/// nor survives every broken file. It opens files in the folder of `path` and below only. Polygons are cut into
/// triangles, points and lines left out; each mesh is as Assimp gives it, vertices that its parts share included.
/// \throws FileError for what Assimp refuses, crashes on, or does not come to an end with; and as check_model() does.
Model read_by_assimp(const std::filesystem::path& path);

/// The extensions, with their dots, of formats that are read by it.
const std::vector<std::string>& assimp_extensions();

/// An image that a model names: within the folder of the model, of this name, or else of this file name beside the
/// model or in its textures or images folder. Empty where there is none.
std::filesystem::path find_image(const std::filesystem::path& model, std::string name);

}  // namespace sightline
