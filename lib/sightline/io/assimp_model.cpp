#include "sightline/io/assimp_model.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/DefaultIOSystem.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <memory>
#include <stdexcept>

#include "sightline/io/assimp_files.h"
#include "sightline/io/child_process.h"
#include "sightline/io/file_bytes.h"
#include "sightline/io/file_error.h"
#include "sightline/io/model_bytes.h"

namespace sightline {
namespace {

bool is_within(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path relative = std::filesystem::weakly_canonical(file, error)
                                             .lexically_relative(std::filesystem::weakly_canonical(folder, error));
  return !error && !relative.empty() && *relative.begin() != "..";
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

class FilesWithin final : public Assimp::DefaultIOSystem {
 public:
  explicit FilesWithin(std::filesystem::path folder) : folder_(std::move(folder)) {}
  bool Exists(const char* file) const override {
    return is_within(folder_, file) && Assimp::DefaultIOSystem::Exists(file);
  }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    std::error_code error;
    const bool is_file = is_within(folder_, file) && std::filesystem::is_regular_file(file, error);
    return is_file && mode[0] == 'r' ? Assimp::DefaultIOSystem::Open(file, mode) : nullptr;
  }

 private:
  std::filesystem::path folder_;
};

/// Runs in the child.
std::string bytes_by_assimp(const std::filesystem::path& path) {
  // Never destroyed: the process ends anyway, and on trees as deep as broken files have them destroying would crash.
  Assimp::Importer& importer = *new Assimp::Importer;
  importer.SetIOHandler(files_within(folder_of(path)));
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene =
      importer.ReadFile(path.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_ValidateDataStructure);
  if (!scene || !scene->mRootNode) throw std::runtime_error(importer.GetErrorString());
  return bytes_of(model_of(path, *scene));
}

}  // namespace

Assimp::IOSystem* files_within(const std::filesystem::path& folder) { return new FilesWithin(folder); }

Model read_by_assimp(const std::filesystem::path& path) {
  read_bytes(path);  // says what is wrong with it as a file
  try {
    return model_of(path, run_in_child([&] { return bytes_by_assimp(path); }));
  } catch (const ChildFailure& failure) {
    throw FileError(path, 0, "a model that Assimp reads", failure.what());
  }
}

const std::vector<std::string>& assimp_extensions() {
  static const std::vector<std::string> extensions = [] {
    std::string list;
    Assimp::Importer().GetExtensionList(list);  // "*.3ds;*.obj;..."
    std::vector<std::string> found;
    for (std::size_t first = 0; first < list.size();) {
      const std::size_t end = std::min(list.find(';', first), list.size());
      // JSON and XML are much else.
      if (const std::string each = list.substr(first + 1, end - first - 1); each != ".json" && each != ".xml") {
        found.push_back(each);
      }
      first = end + 1;
    }
    return found;
  }();
  return extensions;
}

std::filesystem::path find_image(const std::filesystem::path& model, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  while (name.starts_with("./")) name.erase(0, 2);
  if (name.empty() || name.find('\0') != std::string::npos) return {};
  const std::filesystem::path folder = folder_of(model), file = std::filesystem::path(name).filename();
  std::vector<std::filesystem::path> places{folder / file, folder / "textures" / file, folder / "images" / file};
  if (!std::filesystem::path(name).is_absolute()) places.insert(places.begin(), folder / name);
  for (const std::filesystem::path& place : places) {
    std::error_code error;
    if (!file.empty() && is_within(folder, place) && std::filesystem::is_regular_file(place, error)) {
      return place.lexically_normal();
    }
  }
  return {};
}

}  // namespace sightline
