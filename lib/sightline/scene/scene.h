#pragma once
/// What a scene file says: elements in a tree, and the lists that they refer to by number.
///
/// Light is radiance: what a pixel sees is what is sent toward it, where 1 is white. A white Lambert surface on which
/// light of irradiance E falls sends out E / pi.

#include <array>
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
#include "sightline/scene/render_hints.h"
#include "sightline/scene/scene_graph.h"
#include "sightline/scene/surroundings.h"
#include "sightline/shape/mesh.h"
#include "sightline/texture/color.h"
#include "sightline/texture/dents.h"

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

/// A function of space, in the coordinates of the geometry, by name and options ("wood:texture_frequency=3"), or an
/// image.
struct TextureSource {
  std::string name;
  std::variant<std::string, std::filesystem::path> source;
  bool is_data = false;              ///< An image of numbers, such as normals, not of colors.
  std::shared_ptr<const void> kept;  ///< Keeps a temporary file, of an image that was within another file.
};

/// How a surface takes light. Textures, by number, multiply what stands beside them.
///   M1  The share `metallic` reflects as a metal does: with `color` straight on, and more at grazing angles (Schlick).
///   M2  The share `transmission` of the rest is a smooth boundary between air and what is inside, which reflects by
///       Fresnel's law of `refractive_index` and refracts; light inside is absorbed by Beer's law, along lengths in
///       the world. `color` tints what passes through.
///   M3  What remains is Lambert's surface of `color`, below a clear coat that reflects by Fresnel's law where
///       `roughness` is below 1. With roughness 1 there is no coat, and so nothing but Lambert's surface.
///   M4  Reflections of M1 and M3 are a mirror's with roughness 0, and spread with it: GGX of alpha = roughness^2.
/// What is sent out by itself comes on top.
struct Material {
  std::string name;
  Color color{0.8, 0.8, 0.8};
  std::uint32_t color_texture = no_item;
  std::uint32_t normal_map = no_item;  ///< An image.
  double normal_strength = 1;
  std::optional<DentOptions> dents = {};  ///< In the coordinates of the geometry; on top of a normal map.
  double roughness = 1;                   ///< 0 is a mirror.
  double metallic = 0;                    ///< 1 is a metal, whose reflections have its color.
  double transmission = 0;                ///< The share of light that passes through.
  double refractive_index = 1.5;          ///< Of what is inside.
  Color absorption{0, 0, 0};              ///< Of light inside, per unit of length (Beer's law).
  Color emission{0, 0, 0};                ///< Radiance, on both sides.
};

/// What color times intensity are depends on the kind of light: of points and spots radiant intensity, so that a
/// surface that faces one at distance d takes in the irradiance color * intensity / d^2; of directional lights the
/// irradiance on a surface that faces them; of areas the radiance. Scales of nodes do not change it, though they do an
/// area's size.
struct PointLight {};
struct DirectionalLight {};  ///< Along its node's -z.
struct SpotLight {           ///< Around its node's -z; degrees from there. Full within the inner angle, then fades.
  double inner_angle = 0, outer_angle = 45;
};
struct AreaLight {  ///< A rectangle in its node's plane z = 0, around its origin, toward -z alone; rays do not see it.
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
  double field_of_view = 40;            ///< Vertical, in degrees.
  double aperture = 0;                  ///< Diameter of the lens in units of length in the world; 0 is a pinhole.
  double focus_distance = 0;            ///< Of what is sharp, along the view, in the world; above 0 where the lens is.
  std::array<double, 2> shutter{0, 0};  ///< Seconds of the animations when it opens and closes; one for no blur.
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
  Surroundings surroundings;
  Ambient ambient;
  Fog fog;
  RenderHints render;
  std::vector<std::string> warnings;  ///< What files named and did not give, such as missing images; a line each.
};

}  // namespace sightline
