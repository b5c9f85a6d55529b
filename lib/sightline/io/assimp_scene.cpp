#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "sightline/io/assimp_files.h"
#include "sightline/io/assimp_model.h"
#include "sightline/io/embedded_image.h"

namespace sightline {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

std::string text_of(const aiString& text) { return {text.data, std::min<std::size_t>(text.length, sizeof text.data)}; }

/// What a color cannot be becomes the nearest that it can.
float light_of(float value) { return value > 0 && std::isfinite(value) ? value : 0; }
Vec3f color_of(const aiColor3D& c) { return {light_of(c.r), light_of(c.g), light_of(c.b)}; }
double share_of(float value, double otherwise) {
  return std::isfinite(value) ? std::clamp(double(value), 0., 1.) : otherwise;
}

class Copier {
 public:
  Copier(const std::filesystem::path& path, const aiScene& scene) : path_(path), scene_(scene) {}

  Model copy() {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i) model_.materials.push_back(material_of(*scene_.mMaterials[i]));
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) model_.meshes.push_back(mesh_of(*scene_.mMeshes[i]));
    for (unsigned i = 0; i < scene_.mNumLights; ++i) add(*scene_.mLights[i]);
    for (unsigned i = 0; i < scene_.mNumCameras; ++i) add(*scene_.mCameras[i]);
    add_nodes();
    return std::move(model_);
  }

 private:
  // ---- Materials and images

  ModelMaterial material_of(const aiMaterial& from) {
    ModelMaterial material;
    aiString name;
    if (from.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) material.name = text_of(name);
    aiColor3D color;
    if (from.Get(AI_MATKEY_BASE_COLOR, color) == aiReturn_SUCCESS ||
        from.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS) {
      material.color = color_of(color);
    }
    if (from.Get(AI_MATKEY_COLOR_EMISSIVE, color) == aiReturn_SUCCESS) material.emission = color_of(color);
    float value = 0;
    if (from.Get(AI_MATKEY_ROUGHNESS_FACTOR, value) == aiReturn_SUCCESS) {
      material.roughness = share_of(value, 1);
    } else if (from.Get(AI_MATKEY_SHININESS, value) == aiReturn_SUCCESS && value > 0 && std::isfinite(value)) {
      // The width of Phong's lobe as a roughness: Walter et al., "Microfacet Models for Refraction", 2007.
      material.roughness = std::sqrt(2 / (2 + double(value)));
    }
    if (from.Get(AI_MATKEY_METALLIC_FACTOR, value) == aiReturn_SUCCESS) material.metallic = share_of(value, 0);
    if (from.Get(AI_MATKEY_OPACITY, value) == aiReturn_SUCCESS) material.transmission = 1 - share_of(value, 1);
    if (from.Get(AI_MATKEY_REFRACTI, value) == aiReturn_SUCCESS && value >= 1 && std::isfinite(value)) {
      material.refractive_index = value;
    }
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      if (material.color_image == nothing) material.color_image = image_of(from, type, false);
    }
    material.normal_image = image_of(from, aiTextureType_NORMALS, true);
    return material;
  }

  std::uint32_t image_of(const aiMaterial& material, aiTextureType type, bool is_data) {
    aiString name;
    if (material.GetTexture(type, 0, &name) != aiReturn_SUCCESS || name.length == 0) return nothing;
    const std::string text = text_of(name);
    const auto [place, is_new] = images_.try_emplace({text, is_data}, nothing);
    if (!is_new) return place->second;
    ModelImage image{text, std::filesystem::path(), is_data};
    if (const aiTexture* embedded = scene_.GetEmbeddedTexture(text.c_str())) {
      // Of raw texels the format has no file; few formats have them, and small.
      std::string bytes;
      if (embedded->mHeight == 0) bytes.assign(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
      if (image_extension(bytes).empty()) return warn(text, "an embedded image of a format that is read");
      image.source = std::move(bytes);
    } else {
      std::filesystem::path file = find_image(path_, text);
      if (file.empty()) return warn(text, "an image in the folder of the model");
      image.source = std::move(file);
    }
    model_.images.push_back(std::move(image));
    return place->second = static_cast<std::uint32_t>(model_.images.size() - 1);
  }

  std::uint32_t warn(const std::string& name, const std::string& expected) {
    model_.warnings.push_back("texture \"" + name.substr(0, 80) + "\": expected " + expected + ", found none");
    return nothing;
  }

  // ---- Meshes

  ModelMesh mesh_of(const aiMesh& from) const {
    ModelMesh mesh;
    mesh.name = text_of(from.mName);
    if (from.mMaterialIndex < scene_.mNumMaterials) mesh.material = from.mMaterialIndex;
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      mesh.positions.push_back({from.mVertices[i].x, from.mVertices[i].y, from.mVertices[i].z});
    }
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
      const aiFace& face = from.mFaces[i];
      if (face.mNumIndices == 3) mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    for (unsigned i = 0; from.mNormals && i < from.mNumVertices; ++i) {
      const Vec3d normal(from.mNormals[i].x, from.mNormals[i].y, from.mNormals[i].z);
      const double length = glm::length(normal);
      if (!(length > 0) || !std::isfinite(length)) {  // the surface says it better
        mesh.normals.clear();
        break;
      }
      mesh.normals.emplace_back(normal / length);
    }
    for (unsigned i = 0; from.mTextureCoords[0] && i < from.mNumVertices; ++i) {
      const glm::vec2 uv(from.mTextureCoords[0][i].x, from.mTextureCoords[0][i].y);
      if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
        mesh.uvs.clear();
        break;
      }
      mesh.uvs.push_back(uv);
    }
    return mesh;
  }

  // ---- Lights, cameras and nodes

  void add(const aiLight& from) {
    ModelLight light;
    light.name = text_of(from.mName);
    switch (from.mType) {
      case aiLightSource_POINT:
        light.kind = ModelLight::Kind::point;
        break;
      case aiLightSource_DIRECTIONAL:
        light.kind = ModelLight::Kind::directional;
        break;
      case aiLightSource_SPOT:
        light.kind = ModelLight::Kind::spot;
        light.outer_angle = std::clamp(from.mAngleOuterCone * degrees / 2, 0., 90.);
        light.inner_angle = std::clamp(from.mAngleInnerCone * degrees / 2, 0., light.outer_angle);
        break;
      case aiLightSource_AREA:
        light.kind = ModelLight::Kind::area;
        light.width = light_of(from.mSize.x);
        light.height = light_of(from.mSize.y);
        break;
      default:
        return;  // light from everywhere is no light of a place
    }
    // Assimp multiplies the intensity in.
    const Vec3f color = color_of(from.mColorDiffuse);
    light.intensity = max_norm(color);
    if (light.intensity > 0) light.color = color / static_cast<float>(light.intensity);
    lights_[light.name] = {static_cast<std::uint32_t>(model_.lights.size()),
                           frame(from.mPosition, from.mDirection, from.mUp)};
    model_.lights.push_back(light);
  }

  void add(const aiCamera& from) {
    ModelCamera camera;
    camera.name = text_of(from.mName);
    const double aspect = from.mAspect > 0 && std::isfinite(from.mAspect) ? from.mAspect : 1;
    const double vertical = 2 * std::atan(std::tan(double(from.mHorizontalFOV) / 2) / aspect) * degrees;
    if (vertical >= 1 && vertical <= 179) camera.field_of_view = vertical;
    cameras_[camera.name] = {static_cast<std::uint32_t>(model_.cameras.size()),
                             frame(from.mPosition, from.mLookAt, from.mUp)};
    model_.cameras.push_back(camera);
  }

  /// At a position, -z along a direction; the identity where there is none.
  static Affine frame(const aiVector3D& at, const aiVector3D& along, const aiVector3D& up) {
    const Vec3d eye(at.x, at.y, at.z), to(along.x, along.y, along.z);
    Affine result;
    for (std::size_t i = 0; i < 3; ++i) result.rows[i][3] = eye[static_cast<int>(i)];
    const Vec3d back = -to, side = glm::cross(Vec3d(up.x, up.y, up.z), back);
    const bool has_side = glm::length(side) > 0 && std::isfinite(glm::length(side));
    const Vec3d other = std::fabs(back.y) < 0.9 * glm::length(back) ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0);
    if (!(glm::length(back) > 0) || !std::isfinite(glm::length(back))) return result;
    const Vec3d z = glm::normalize(back), x = glm::normalize(has_side ? side : glm::cross(other, back));
    const Vec3d y = glm::cross(z, x);
    for (int i = 0; i < 3; ++i) {
      auto& row = result.rows[static_cast<std::size_t>(i)];
      row[0] = x[i], row[1] = y[i], row[2] = z[i];
    }
    return result;
  }

  /// Depth-first, without calling itself: Assimp lets nodes be as deep as it survives.
  void add_nodes() {
    std::vector<std::pair<const aiNode*, std::uint32_t>> open{{scene_.mRootNode, nothing}};
    while (!open.empty()) {
      const auto [from, parent] = open.back();
      open.pop_back();
      const auto number = static_cast<std::uint32_t>(model_.nodes.size());
      ModelNode node;
      node.name = text_of(from->mName);
      node.parent = parent;
      for (unsigned row = 0; row < 3; ++row) {
        for (unsigned column = 0; column < 4; ++column)
          node.local.rows[row][column] = from->mTransformation[row][column];
      }
      for (unsigned i = 0; i < from->mNumMeshes; ++i) {
        // Meshes of points or lines alone have no triangles.
        const unsigned mesh = from->mMeshes[i];
        if (mesh >= model_.meshes.size() || !model_.meshes[mesh].triangles.empty()) node.meshes.push_back(mesh);
      }
      model_.nodes.push_back(std::move(node));
      add_held(from->mName, number);
      for (unsigned i = from->mNumChildren; i > 0; --i) open.emplace_back(from->mChildren[i - 1], number);
    }
  }

  /// Lights and cameras are a node's by its name, and stand within it.
  void add_held(const aiString& name, std::uint32_t number) {
    const auto light = lights_.find(text_of(name));
    const auto camera = cameras_.find(text_of(name));
    if (light != lights_.end()) {
      ModelNode held{light->first, number, light->second.second, {}, nothing, light->second.first};
      lights_.erase(light);
      model_.nodes.push_back(std::move(held));
    }
    if (camera != cameras_.end()) {
      ModelNode held{camera->first, number, camera->second.second, {}, camera->second.first, nothing};
      cameras_.erase(camera);
      model_.nodes.push_back(std::move(held));
    }
  }

  const std::filesystem::path& path_;
  const aiScene& scene_;
  Model model_;
  std::map<std::pair<std::string, bool>, std::uint32_t> images_;
  std::map<std::string, std::pair<std::uint32_t, Affine>> lights_, cameras_;  ///< Not yet placed.
};

}  // namespace

Model model_of(const std::filesystem::path& path, const aiScene& scene) { return Copier(path, scene).copy(); }

}  // namespace sightline
