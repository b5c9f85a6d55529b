#pragma once
/// What a scene file says: elements in a tree, and the lists that they refer to by number.

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sightline/csg/solid_tree.h"
#include "sightline/scene/animation.h"
#include "sightline/scene/scene_graph.h"
#include "sightline/shape/mesh.h"
#include "sightline/texture/color.h"

namespace sightline {

/// Triangles, and what shading knows of their vertices: normals and places in images, of each vertex or none.
struct MeshGeometry {
  std::shared_ptr<const TriangleMesh> mesh;
  std::vector<Vec3f> normals;  ///< Of unit length.
  std::vector<glm::vec2> uvs;
};

/// A mesh or a solid, in coordinates of its own, that any number of nodes may share.
struct Geometry {
  std::string name;
  std::variant<MeshGeometry, SolidTree> shape;
};

/// A function of space by name and options ("wood:texture_frequency=3"), or an image.
struct TextureSource {
  std::string name;
  std::variant<std::string, std::filesystem::path> source;
  bool is_data = false;              ///< An image of numbers, such as normals, not of colors.
  std::shared_ptr<const void> kept;  ///< Keeps a temporary file, of an image that was within another file.
};

/// How a surface takes light. Textures, by number, multiply what stands beside them.
struct Material {
  std::string name;
  Color color{0.8, 0.8, 0.8};
  std::uint32_t color_texture = no_item;
  std::uint32_t normal_map = no_item;
  double normal_strength = 1;
  double roughness = 1;           ///< 0 is a mirror.
  double metallic = 0;            ///< 1 is a metal, whose reflections have its color.
  double transmission = 0;        ///< The share of light that passes through.
  double refractive_index = 1.5;  ///< Of what is inside.
  Color absorption{0, 0, 0};      ///< Of light inside, per unit of length (Beer's law).
  Color emission{0, 0, 0};
};

struct PointLight {};
struct DirectionalLight {};  ///< Along its node's -z.
struct SpotLight {           ///< Around its node's -z; degrees from there.
  double inner_angle = 0, outer_angle = 45;
};
struct AreaLight {  ///< A rectangle in its node's plane z = 0, around its origin, toward -z.
  double width = 1, height = 1;
};
struct Light {
  std::string name;
  NodeId node = root_node;
  std::variant<PointLight, DirectionalLight, SpotLight, AreaLight> kind;
  Color color{1, 1, 1};
  double intensity = 1;
};

/// Looks along its node's -z, y up.
struct SceneCamera {
  std::string name;
  NodeId node = root_node;
  double field_of_view = 40;  ///< Vertical, in degrees.
};

struct Scene {
  std::string name;
  SceneGraph graph;
  std::vector<Geometry> geometries;
  std::vector<Material> materials;
  std::vector<TextureSource> textures;
  std::vector<Light> lights;
  std::vector<SceneCamera> cameras;
  std::vector<Animation> animations;
  std::vector<std::string> warnings;  ///< What files named and did not give, such as missing images; a line each.
};

}  // namespace sightline
