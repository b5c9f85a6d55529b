#pragma once

#include <filesystem>
#include <string_view>

#include "sightline/io/model.h"

namespace sightline {

/// Reads glTF 2 and GLB: nodes, triangles with normals and places in images, materials, images, perspective cameras,
/// lights (KHR_lights_punctual) and animations of nodes. Meshes keep their vertices bit for bit. Skins and morph
/// targets are left as they rest. What is left out otherwise is told by a warning. \throws FileError, which names the
/// place as a JSON pointer: sparse and compressed accessors are refused.
Model read_gltf(const std::filesystem::path& path, std::string_view bytes);

}  // namespace sightline
