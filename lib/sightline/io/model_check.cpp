#include <cmath>

#include "sightline/io/file_error.h"
#include "sightline/io/gltf_check.h"
#include "sightline/io/model_bytes.h"

namespace sightline {
namespace {

class Checker {
 public:
  Checker(const std::filesystem::path& path, const Model& model) : path_(path), model_(model) {}

  void check() const {
    for (const ModelMesh& mesh : model_.meshes) check(mesh);
    for (const ModelMaterial& material : model_.materials) check(material);
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) check(model_.nodes[i], i);
    for (const ModelLight& light : model_.lights) {
      require(is_good(light.color) && is_good(light.intensity) && light.kind <= ModelLight::Kind::area &&
                  light.inner_angle >= 0 && light.inner_angle <= light.outer_angle && light.outer_angle <= 90,
              "lights", light.name);
    }
    for (const ModelCamera& camera : model_.cameras) {
      require(camera.field_of_view > 0 && camera.field_of_view < 180, "cameras", camera.name);
    }
    for (const ModelAnimation& animation : model_.animations) {
      for (const ModelTrack& track : animation.tracks) {
        bool is_sound = track.node < model_.nodes.size() && track.part <= ModelTrack::Part::scale &&
                        track.times.size() == track.values.size() && !track.times.empty();
        for (std::size_t i = 0; i < track.times.size() && is_sound; ++i) {
          is_sound = std::isfinite(track.times[i]) && (i == 0 || track.times[i] > track.times[i - 1]);
          for (const double value : track.values[i]) is_sound = is_sound && std::isfinite(value);
        }
        require(is_sound, "animations with times that grow", animation.name);
      }
    }
    const std::uint64_t triangles = placed_triangles(model_);
    if (triangles == 0) throw FileError(path_, 0, "at least one triangle", "none");
    if (triangles > most_triangles) {
      throw FileError(path_, 0, "at most " + std::to_string(most_triangles) + " triangles where nodes place them",
                      "more");
    }
  }

 private:
  void require(bool is_so, const std::string& what, const std::string& name) const {
    if (!is_so)
      throw FileError(path_, 0, what + " whose numbers make sense", "others in \"" + name.substr(0, 60) + "\"");
  }
  static bool is_number(std::uint32_t number, std::size_t count) { return number == nothing || number < count; }
  static bool is_good(double value) { return value >= 0 && std::isfinite(value); }
  static bool is_good(const Vec3f& color) { return is_good(color.x) && is_good(color.y) && is_good(color.z); }

  void check(const ModelMesh& mesh) const {
    const std::size_t count = mesh.positions.size();
    require(is_number(mesh.material, model_.materials.size()), "meshes", mesh.name);
    require(mesh.normals.empty() || mesh.normals.size() == count, "normals", mesh.name);
    require(mesh.uvs.empty() || mesh.uvs.size() == count, "places in images", mesh.name);
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_finite(mesh.positions[i])) {
        throw FileError(
            path_, 0, "coordinates finite as floats",
            "NaN or infinity in vertex " + std::to_string(i) + " of mesh \"" + mesh.name.substr(0, 60) + "\"");
      }
    }
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        if (corner >= count) {
          throw FileError(path_, 0, "vertex numbers below " + std::to_string(count), std::to_string(corner));
        }
      }
    }
    for (const Vec3f& normal : mesh.normals) require(is_finite(normal), "normals", mesh.name);
    for (const glm::vec2& uv : mesh.uvs)
      require(std::isfinite(uv.x) && std::isfinite(uv.y), "places in images", mesh.name);
  }

  void check(const ModelMaterial& m) const {
    const auto is_share = [](double value) { return value >= 0 && value <= 1; };
    require(is_good(m.color) && is_good(m.emission) && is_good(m.absorption) && is_share(m.roughness) &&
                is_share(m.metallic) && is_share(m.transmission) && is_good(m.refractive_index) &&
                is_good(m.normal_strength) && is_number(m.color_image, model_.images.size()) &&
                is_number(m.normal_image, model_.images.size()),
            "materials", m.name);
  }

  void check(const ModelNode& node, std::size_t number) const {
    if (!is_finite(node.local)) {
      throw FileError(path_, 0, "finite transforms", "NaN or infinity in node \"" + node.name.substr(0, 60) + "\"");
    }
    require(node.parent == nothing || node.parent < number, "nodes after their parents", node.name);
    require(is_number(node.camera, model_.cameras.size()) && is_number(node.light, model_.lights.size()), "nodes",
            node.name);
    for (const std::uint32_t mesh : node.meshes) require(mesh < model_.meshes.size(), "nodes", node.name);
  }

  const std::filesystem::path& path_;
  const Model& model_;
};

}  // namespace

std::uint64_t placed_triangles(const Model& model) {
  std::uint64_t triangles = 0;
  for (const ModelNode& node : model.nodes) {
    for (const std::uint32_t mesh : node.meshes) triangles += model.meshes[mesh].triangles.size();
  }
  return triangles;
}

void check_model(const std::filesystem::path& path, const Model& model) { Checker(path, model).check(); }

}  // namespace sightline
