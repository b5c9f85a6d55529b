#pragma once

#include <filesystem>

#include "sightline/io/model.h"
#include "sightline/scene/scene.h"

namespace sightline {

/// A model as a scene: its nodes below the root, with its materials, textures, lights and cameras.
/// \throws FileError for a node that cannot be undone, naming it by its path.
Scene scene_of(const std::filesystem::path& path, Model model);

/// read_model() as a scene.
Scene import_scene(const std::filesystem::path& path);

/// Whether import_scene() knows its extension.
bool is_model_file(const std::filesystem::path& path);

}  // namespace sightline
