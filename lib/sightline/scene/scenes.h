#pragma once
/// Scenes by name, made on the spot, or read from a file. What is made is the same on every machine, as far as sines and
/// logarithms of the C library are, which float rounds.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "sightline/scene/scene.h"
#include "sightline/shape/mesh.h"

namespace sightline {

struct SceneInfo {
  std::string_view name;
  std::string_view description;  ///< What it is, and what its size counts.
  int default_size;
  int lowest, highest;  ///< Sizes that are allowed.
};

std::span<const SceneInfo> scene_infos();

/// `spec` is a scene's name ("teapot"), a name and a size ("teapot:16"), or the path of a mesh file. The dragon is read
/// from `data_dir`/cache. What is one mesh, as files are, becomes one node. Throws std::invalid_argument for an unknown
/// name or a size out of its limits, FileError for a file that is missing or broken.
Scene make_scene(const std::string& spec, const std::filesystem::path& data_dir);

/// The same as one mesh of all triangles, for those that need no more. Throws as make_scene does, and as instances_of()
/// and Instances::flattened() do.
std::shared_ptr<const TriangleMesh> load_scene(const std::string& spec, const std::filesystem::path& data_dir);

}  // namespace sightline
