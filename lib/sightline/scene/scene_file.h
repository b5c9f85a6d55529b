#pragma once
/// Scenes as JSON, with comments; data/README.md teaches the format, data/scene.schema.json is for editors.

#include <filesystem>
#include <string>

#include "sightline/scene/scene.h"

namespace sightline {

/// Reads a scene (.json), and all that it includes, uses and places; files are named relative to the one that names
/// them. Models (glTF and others) are read with their nodes, materials, textures and cameras, see io/model_file.h.
/// \throws FileError naming file and place ("scene.json:/objects/3/transform/0"), what is expected and what was found:
/// for what is not of the format, members that it does not have, names that are defined nowhere or twice, transforms
/// that cannot be undone, files and groups that contain themselves, and for more than graft.h's most_nodes.
Scene read_scene(const std::filesystem::path& path, const std::filesystem::path& data_dir);

/// Whether read_scene() knows its extension.
bool is_scene_file(const std::filesystem::path& path);

}  // namespace sightline
