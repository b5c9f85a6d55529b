#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sightline/scene/scene.h"

namespace sightline {

/// Writes a scene as glTF 2 in one file: GLB (.glb), or JSON with its data in base64 (.gltf). Nodes keep their places
/// to the last bit of double, meshes theirs of float and are shared by all nodes that show them with one material; PNG
/// and JPEG images come along; lights by KHR_lights_punctual; animations, whose nodes get translation, rotation and
/// scale for their matrix. Returns what the format has no words for, a line each: solids, area lights, functions of
/// space, other images.
/// \throws FileError for another extension, a file that cannot be written, and more than 4 GiB.
std::vector<std::string> write_gltf(const std::filesystem::path& path, const Scene& scene);

}  // namespace sightline
