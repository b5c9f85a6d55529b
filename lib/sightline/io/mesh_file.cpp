#include "sightline/io/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <optional>

#include "sightline/io/file_bytes.h"
#include "sightline/io/file_error.h"
#include "sightline/io/gltf_check.h"
#include "sightline/io/polygons.h"
#include "sightline/shape/mesh_builder.h"

namespace sightline {
namespace {

struct Format {
  std::string_view extension;
  Polygons (*read)(const std::filesystem::path&, std::string_view);  ///< Null: glTF.
  bool repeats_vertices;
};

constexpr auto formats = std::to_array<Format>({{".obj", read_obj, false},
                                                {".ply", read_ply, false},
                                                {".stl", read_stl, true},
                                                {".off", read_off, false},
                                                {".gltf", nullptr, false},
                                                {".glb", nullptr, false}});

const Format& format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string known;
  for (const Format& format : formats) {
    if (extension == format.extension) return format;
    known += (known.empty() ? "" : " ") + std::string(format.extension);
  }
  throw FileError(path, 0, "one of the extensions " + known, extension.empty() ? "none" : "\"" + extension + "\"");
}

/// Collects the meshes of a scene where its nodes place them.
class Flattener {
 public:
  Flattener(const std::filesystem::path& path, const aiScene& scene) : path_(path), scene_(scene) {
    add(*scene.mRootNode, aiMatrix4x4());
  }

  TriangleMesh take() { return {std::move(positions_), std::move(triangles_)}; }

 private:
  /// As deep as gltf_check.h lets nodes be.
  void add(const aiNode& node, const aiMatrix4x4& above) {
    const aiMatrix4x4 placement = above * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], placement);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], placement);
  }

  void add(const aiMesh& mesh, const aiMatrix4x4& placement) {
    const auto first = static_cast<std::uint32_t>(positions_.size());
    const bool is_placed = placement != aiMatrix4x4();
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D p = is_placed ? placement * mesh.mVertices[i] : mesh.mVertices[i];
      positions_.push_back({p.x, p.y, p.z});
      if (!is_finite(positions_.back())) {
        throw FileError(path_, 0, "coordinates finite as floats",
                        "NaN or infinity in vertex " + std::to_string(i) + " where its node places it");
      }
    }
    // Mirroring turns triangles inside out.
    const bool is_mirrored = placement.Determinant() < 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) continue;
      std::array<std::uint32_t, 3> corners;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        if (face.mIndices[corner] >= mesh.mNumVertices) throw FileError(path_, 0, "a vertex", "an index out of range");
        corners[corner] = first + face.mIndices[corner];
      }
      if (is_mirrored) std::swap(corners[1], corners[2]);
      triangles_.push_back(corners);
    }
  }

  const std::filesystem::path& path_;
  const aiScene& scene_;
  std::vector<Vec3f> positions_;
  std::vector<TriangleMesh::Corners> triangles_;
};

/// `bytes` are checked, so a failure here is of Assimp, or of memory.
TriangleMesh import(const std::filesystem::path& path, const std::string& bytes, const char* format) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, format);
  if (!scene || !scene->mRootNode) throw FileError(path, 0, "a mesh", importer.GetErrorString());
  return Flattener(path, *scene).take();
}

TriangleMesh joined(const TriangleMesh& mesh) {
  MeshBuilder builder;
  builder.mesh(mesh);
  return builder.take();
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path) {
  const Format& format = format_of(path);
  const std::string bytes = read_bytes(path);
  std::string checked;
  std::uint64_t triangles = 0;
  if (format.read) {
    const Polygons polygons = format.read(path, bytes);
    triangles = polygons.triangles();
    if (triangles > 0) checked = as_ply(polygons);
  } else {
    CheckedGltf gltf = check_gltf(path, bytes);
    triangles = gltf.triangles;
    checked = std::move(gltf.glb);
  }
  if (triangles == 0) throw FileError(path, 0, "at least one triangle", "none");
  if (triangles > most_triangles) {
    throw FileError(path, 0, "at most " + std::to_string(most_triangles) + " triangles", std::to_string(triangles));
  }
  TriangleMesh mesh = import(path, checked, format.read ? "ply" : "glb");
  if (mesh.size() != triangles) {
    throw FileError(path, 0, "polygons that can be cut into " + std::to_string(triangles) + " triangles",
                    std::to_string(mesh.size()));
  }
  return format.repeats_vertices ? joined(mesh) : mesh;
}

}  // namespace sightline
