#pragma once
/// What a model file says, whatever its format: nodes, meshes, materials, images, lights and cameras.

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sightline/math/affine.h"
#include "sightline/math/vec.h"

namespace sightline {

inline constexpr std::uint32_t nothing = 0xffff'ffff;

/// Triangles with one material.
///   M1  Positions are finite, corners below positions.size(); normals, of unit length, and uvs are as many as
///       positions or none.
struct ModelMesh {
  std::string name;
  std::uint32_t material = nothing;
  std::vector<Vec3f> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Vec3f> normals;
  std::vector<glm::vec2> uvs;  ///< u to the right and v up, from the image's lower left corner.
};

/// An image by its file, or by the bytes of one.
struct ModelImage {
  std::string name;
  std::variant<std::filesystem::path, std::string> source;
  bool is_data = false;
};

/// Numbers as Material of scene/scene.h has them, images by number.
struct ModelMaterial {
  std::string name;
  Vec3f color{0.8f, 0.8f, 0.8f}, emission{0, 0, 0}, absorption{0, 0, 0};
  double roughness = 1, metallic = 0, transmission = 0, refractive_index = 1.5, normal_strength = 1;
  std::uint32_t color_image = nothing, normal_image = nothing;
};

/// Shines, or looks, along its node's -z.
struct ModelLight {
  enum class Kind : std::uint8_t { point, directional, spot, area };
  std::string name;
  Kind kind = Kind::point;
  Vec3f color{1, 1, 1};
  double intensity = 1;
  double inner_angle = 0, outer_angle = 45;  ///< Of spots: degrees from the axis.
  double width = 1, height = 1;              ///< Of areas.
};
struct ModelCamera {
  std::string name;
  double field_of_view = 40;  ///< Vertical, in degrees.
};

struct ModelNode {
  std::string name;
  std::uint32_t parent = nothing;  ///< Comes before the node.
  Affine local;                    ///< Finite; it may be singular.
  std::vector<std::uint32_t> meshes;
  std::uint32_t camera = nothing, light = nothing;
  bool is_visible = true;  ///< With all below it.
};

/// Keys of one part of a node's place; see scene/animation.h.
struct ModelTrack {
  enum class Part : std::uint8_t { translation, rotation, scale };
  std::uint32_t node = 0;
  Part part = Part::translation;
  bool is_step = false;
  std::vector<double> times;                  ///< Each above the one before.
  std::vector<std::array<double, 4>> values;  ///< x, y, z, and of quaternions w.
};
struct ModelAnimation {
  std::string name;
  std::vector<ModelTrack> tracks;
};

///   M2  All numbers are of the lists, or `nothing`; parents come before their children.
struct Model {
  std::vector<ModelNode> nodes;
  std::vector<ModelMesh> meshes;
  std::vector<ModelMaterial> materials;
  std::vector<ModelImage> images;
  std::vector<ModelLight> lights;
  std::vector<ModelCamera> cameras;
  std::vector<ModelAnimation> animations;
  std::vector<std::string> warnings;  ///< A line each.
};

/// Triangles, each placement counted.
std::uint64_t placed_triangles(const Model& model);

}  // namespace sightline
