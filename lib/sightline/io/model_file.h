#pragma once

#include <filesystem>

#include "sightline/io/model.h"

namespace sightline {

/// Reads a model with its nodes, materials, images, lights, cameras and animations. glTF 2 is read by gltf_model.h, and
/// what has triangles alone (PLY, STL, OFF) by mesh_file.h; all else goes through Assimp in a process of its own, OBJ
/// once obj_reader.cpp finds nothing wrong with it. Images that are not found are told by warnings.
/// \throws FileError.
Model read_model(const std::filesystem::path& path);

bool is_model_extension(const std::filesystem::path& path);

}  // namespace sightline
