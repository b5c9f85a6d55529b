#include <array>
#include <glm/vec2.hpp>
#include <stdexcept>

#include "sightline/io/mesh_file.h"
#include "sightline/scene/scene_members.h"
#include "sightline/scene/scene_reader.h"
#include "sightline/scene/scenes.h"
#include "sightline/scene/simple_meshes.h"
#include "sightline/scene/solid_file.h"
#include "sightline/scene/solid_frame.h"
#include "sightline/scene/solids.h"

namespace sightline {
namespace {

int segments_of(const JsonValue& json) {
  return static_cast<int>(std::min<std::uint64_t>(json.whole_or("segments", 32), most_segments + 1));
}

double real_or(const JsonValue& json, const char* name, double otherwise) {
  const auto member = json.find(name);
  return member ? member->real() : otherwise;
}

glm::dvec2 pair_of(const JsonValue& json) {
  if (json.size() != 2) json.fail("2 numbers", std::to_string(json.size()));
  return {json[std::size_t{0}].real(), json[1].real()};
}

MeshGeometry sphere_of(const JsonValue& json) {
  check_members(json, "sphere");
  return make_sphere(json["radius"].real(), segments_of(json));
}

MeshGeometry box_of(const JsonValue& json) {
  check_members(json, "box");
  return make_box(vector_of(json["lo"]), vector_of(json["hi"]));
}

MeshGeometry quad_of(const JsonValue& json) {
  check_members(json, "quad");
  return make_quad(json["width"].real(), json["height"].real(), real_or(json, "repeat", 1));
}

MeshGeometry lathe_of(const JsonValue& json) {
  check_members(json, "lathe");
  std::vector<glm::dvec2> profile;
  const JsonValue points = json["profile"];
  for (std::size_t i = 0; i < points.size(); ++i) profile.push_back(pair_of(points[i]));
  const auto smooth = json.find("smooth");
  return make_lathe(profile, segments_of(json), smooth && smooth->truth());
}

bool is_scene_name(const std::string& spec) {
  for (const SceneInfo& info : scene_infos()) {
    if (spec.substr(0, spec.find(':')) == info.name) return true;
  }
  return false;
}

Vec3f single(const JsonValue& json) {
  if (json.size() != 3) json.fail("3 numbers");
  return {json[std::size_t{0}].number(), json[1].number(), json[2].number()};
}

}  // namespace

MeshGeometry SceneReader::mesh_of(const JsonValue& spec) {
  const std::string& name = spec.text();
  const bool is_name = is_scene_name(name);
  if (!is_name && name.find_first_of("./") == std::string::npos) {
    std::string known;
    for (const SceneInfo& info : scene_infos()) known += std::string(info.name) + " ";
    spec.fail("a mesh file, or a name of " + known + "with its size");
  }
  const std::string key = is_name ? name : file_of(spec).string();
  const auto found = loading_.meshes.find(key);
  if (found != loading_.meshes.end()) return found->second;
  MeshGeometry mesh;
  mesh.mesh = is_name ? load_scene(name, loading_.data_dir) : std::make_shared<const TriangleMesh>(read_mesh(key));
  return loading_.meshes[key] = mesh;
}

MeshGeometry SceneReader::triangles_of_geometry(const JsonValue& json) {
  const JsonValue vertices = json["vertices"], triangles = json["triangles"];
  MeshGeometry geometry;
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> corners;
  for (std::size_t i = 0; i < vertices.size(); ++i) positions.push_back(single(vertices[i]));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const JsonValue triangle = triangles[i];
    if (triangle.size() != 3) triangle.fail("3 vertices");
    auto& added = corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle[k].whole() >= positions.size())
        triangle[k].fail("a vertex below " + std::to_string(positions.size()));
      added[k] = static_cast<std::uint32_t>(triangle[k].whole());
    }
  }
  if (corners.empty()) triangles.fail("at least one triangle");
  const auto check_count = [&](const JsonValue& list) {
    if (list.size() != positions.size()) {
      list.fail("one for each of the " + std::to_string(positions.size()) + " vertices", std::to_string(list.size()));
    }
  };
  if (const auto normals = json.find("normals")) {
    check_count(*normals);
    for (std::size_t i = 0; i < normals->size(); ++i) {
      const Vec3d normal = vector_of((*normals)[i]);
      const double size = max_norm(normal);
      if (!(size > 0)) (*normals)[i].fail("a normal other than 0");
      geometry.normals.emplace_back(glm::normalize(normal / size));
    }
  }
  if (const auto uvs = json.find("uvs")) {
    check_count(*uvs);
    for (std::size_t i = 0; i < uvs->size(); ++i) {
      const JsonValue uv = (*uvs)[i];
      if (uv.size() != 2) uv.fail("2 numbers", std::to_string(uv.size()));
      geometry.uvs.emplace_back(uv[std::size_t{0}].number(), uv[1].number());
    }
  }
  geometry.mesh = std::make_shared<const TriangleMesh>(std::move(positions), std::move(corners));
  return geometry;
}

Geometry SceneReader::geometry_of(const std::string& name, const JsonValue& json) {
  check_members(json, "geometry");
  constexpr auto kinds =
      std::to_array<std::string_view>({"mesh", "solid", "csg", "sphere", "box", "quad", "lathe", "vertices"});
  const std::string kind(one_member(json, kinds));
  for (const char* member : {"triangles", "normals", "uvs"}) {
    if (const auto found = json.find(member); found && kind != "vertices") found->fail("\"vertices\" beside it", kind);
  }
  const JsonValue value = json[kind.c_str()];
  try {
    if (kind == "mesh") return {name, mesh_of(value)};
    if (kind == "solid") return {name, load_solid(value.text())};
    if (kind == "csg") return {name, solid_of(value)};
    if (kind == "sphere") return {name, sphere_of(value)};
    if (kind == "box") return {name, box_of(value)};
    if (kind == "quad") return {name, quad_of(value)};
    if (kind == "lathe") return {name, lathe_of(value)};
    return {name, triangles_of_geometry(json)};
  } catch (const std::invalid_argument& error) {
    value.fail("a shape that makes sense", error.what());
  }
}

}  // namespace sightline
