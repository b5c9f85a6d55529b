#include "sightline/io/model_file.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "sightline/io/assimp_model.h"
#include "sightline/io/file_bytes.h"
#include "sightline/io/file_error.h"
#include "sightline/io/gltf_model.h"
#include "sightline/io/mesh_file.h"
#include "sightline/io/polygons.h"

namespace sightline {
namespace {

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

Model of_mesh(const std::filesystem::path& path) {
  const TriangleMesh mesh = read_mesh(path);
  Model model;
  model.meshes.push_back({path.stem().string(), nothing, mesh.positions(), mesh.triangles(), {}, {}});
  model.nodes.push_back({path.stem().string(), nothing, {}, {0}, nothing, nothing});
  return model;
}

/// The first version has another structure altogether, which Assimp knows.
bool is_gltf_1(std::string_view bytes) {
  if (bytes.starts_with("glTF")) return bytes.size() > 4 && bytes[4] == 1;
  const std::size_t asset = bytes.find("\"asset\"");
  const std::size_t version = bytes.find("\"version\"", asset == std::string_view::npos ? 0 : asset);
  if (asset == std::string_view::npos || version == std::string_view::npos) return false;
  const std::size_t digit = bytes.find_first_of("0123456789", version);
  return digit != std::string_view::npos && bytes[digit] == '1';
}

}  // namespace

Model read_model(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".ply" || extension == ".stl" || extension == ".off") return of_mesh(path);
  const std::string bytes = read_bytes(path);
  if ((extension == ".gltf" || extension == ".glb") && !is_gltf_1(bytes)) return read_gltf(path, bytes);
  if (extension == ".obj") read_obj(path, bytes);  // says what is wrong with it
  if (!is_model_extension(path)) {
    throw FileError(path, 0, "a model's extension", extension.empty() ? "none" : "\"" + extension + "\"");
  }
  return read_by_assimp(path);
}

bool is_model_extension(const std::filesystem::path& path) {
  const std::vector<std::string>& known = assimp_extensions();
  return std::find(known.begin(), known.end(), extension_of(path)) != known.end();
}

}  // namespace sightline
