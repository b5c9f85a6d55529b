#include "sightline/scene/scene_import.h"

#include <map>
#include <stdexcept>
#include <utility>

#include "sightline/io/embedded_image.h"
#include "sightline/io/file_error.h"
#include "sightline/io/model_file.h"
#include "sightline/scene/graft.h"

namespace sightline {
namespace {

Material material_of(const ModelMaterial& from) {
  Material material;
  material.name = from.name;
  material.color = from.color;
  material.color_texture = from.color_image;
  material.normal_map = from.normal_image;
  material.normal_strength = from.normal_strength;
  material.roughness = from.roughness;
  material.metallic = from.metallic;
  material.transmission = from.transmission;
  material.refractive_index = from.refractive_index;
  material.absorption = from.absorption;
  material.emission = from.emission;
  return material;
}

Light light_of(const ModelLight& from) {
  Light light;
  light.name = from.name;
  light.color = from.color;
  light.intensity = from.intensity;
  switch (from.kind) {
    case ModelLight::Kind::point:
      light.kind = PointLight{};
      break;
    case ModelLight::Kind::directional:
      light.kind = DirectionalLight{};
      break;
    case ModelLight::Kind::spot:
      light.kind = SpotLight{from.inner_angle, from.outer_angle};
      break;
    case ModelLight::Kind::area:
      light.kind = AreaLight{from.width, from.height};
  }
  return light;
}

TextureSource texture_of(ModelImage&& from) {
  TextureSource texture{from.name, std::filesystem::path(), from.is_data, nullptr};
  if (const auto* path = std::get_if<std::filesystem::path>(&from.source)) {
    texture.source = *path;
  } else {
    auto file = keep_image(std::get<std::string>(from.source));
    texture.source = file->path();
    texture.kept = std::move(file);
  }
  return texture;
}

template <class T, class Of>
void set(Track<T>& track, const ModelTrack& from, Of&& of) {
  track.times = from.times;
  track.interpolation = from.is_step ? Interpolation::step : Interpolation::linear;
  for (const auto& value : from.values) track.values.push_back(of(value));
}

/// Tracks of one node become one channel.
Animation animation_of(const ModelAnimation& from, const std::vector<NodeId>& ids) {
  Animation animation{from.name, {}, true};
  std::map<NodeId, std::size_t> places;
  for (const ModelTrack& track : from.tracks) {
    const auto [place, is_new] = places.try_emplace(ids[track.node], animation.channels.size());
    if (is_new) animation.channels.emplace_back().node = ids[track.node];
    Channel& channel = animation.channels[place->second];
    const auto vector = [](const std::array<double, 4>& v) { return Vec3d(v[0], v[1], v[2]); };
    switch (track.part) {
      case ModelTrack::Part::translation:
        set(channel.translation, track, vector);
        break;
      case ModelTrack::Part::rotation:
        set(channel.rotation, track, [](const auto& v) { return glm::dquat(v[3], v[0], v[1], v[2]); });
        break;
      case ModelTrack::Part::scale:
        set(channel.scale, track, vector);
    }
  }
  return animation;
}

/// Names out of files may hold anything.
std::string one_line(std::string text) {
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte >= 0x7f) c = '?';
  }
  return text;
}

}  // namespace

Scene scene_of(const std::filesystem::path& path, Model model) {
  Scene scene;
  scene.name = path.stem().string();
  scene.warnings = std::move(model.warnings);
  for (const ModelMaterial& material : model.materials) scene.materials.push_back(material_of(material));
  for (ModelImage& image : model.images) scene.textures.push_back(texture_of(std::move(image)));
  std::vector<std::uint32_t> materials;
  for (ModelMesh& mesh : model.meshes) {
    materials.push_back(mesh.material);
    auto triangles = std::make_shared<const TriangleMesh>(std::move(mesh.positions), std::move(mesh.triangles));
    scene.geometries.push_back(
        {mesh.name, MeshGeometry{std::move(triangles), std::move(mesh.normals), std::move(mesh.uvs)}});
  }
  std::vector<NodeId> ids;
  for (const ModelNode& node : model.nodes) {
    const NodeId parent = node.parent == nothing ? root_node : ids[node.parent];
    const auto refuse = [&](const char* found) {
      throw FileError(path, 0,
                      "a transform of " + scene.graph.path(parent) + (parent == root_node ? "" : "/") + node.name +
                          " that can be undone",
                      found);
    };
    if (scene.graph.size() + 1 + node.meshes.size() > most_nodes) {
      throw FileError(path, 0, "at most " + std::to_string(most_nodes) + " nodes", "more");
    }
    Transform local;
    try {
      if (!node.local.is_identity()) local = Transform::of(node.local);
    } catch (const std::invalid_argument& error) {
      refuse(error.what());
    }
    const NodeId id = scene.graph.add(parent, node.name, local);
    ids.push_back(id);
    scene.graph.set_visible(id, node.is_visible);
    // A node of a graph has one geometry at most, so that those of several materials stand below it.
    for (const std::uint32_t mesh : node.meshes) {
      const NodeId place = node.meshes.size() == 1 ? id : scene.graph.add(id, model.meshes[mesh].name);
      scene.graph.set_geometry(place, mesh);
      scene.graph.set_material(place, materials[mesh]);
    }
    if (node.light != nothing) {
      scene.lights.push_back(light_of(model.lights[node.light]));
      scene.lights.back().node = id;
    }
    if (node.camera != nothing) {
      scene.cameras.push_back({model.cameras[node.camera].name, id, model.cameras[node.camera].field_of_view});
    }
  }
  for (const ModelAnimation& from : model.animations) {
    Animation animation = animation_of(from, ids);
    try {
      check(animation, scene.graph);
      scene.animations.push_back(std::move(animation));
    } catch (const std::invalid_argument& error) {
      scene.warnings.push_back(std::string(error.what()) + "; left out");
    }
  }
  for (std::string& warning : scene.warnings) warning = one_line(std::move(warning));
  return scene;
}

Scene import_scene(const std::filesystem::path& path) { return scene_of(path, read_model(path)); }

bool is_model_file(const std::filesystem::path& path) { return is_model_extension(path); }

}  // namespace sightline
