#include "sightline/scene/solid_file.h"

#include <functional>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "sightline/csg/primitive_bounds.h"
#include "sightline/io/file_bytes.h"
#include "sightline/scene/solid_frame.h"

namespace sightline {
namespace {

Vec3d vector_or(const JsonValue& json, const char* name, const Vec3d& otherwise) {
  const auto member = json.find(name);
  return member ? vector_of(*member) : otherwise;
}

SolidShape quadric_of(const JsonValue& json) {
  const JsonValue numbers = json["q"];
  solid::Quadric quadric;
  if (numbers.size() != quadric.coefficients.size()) numbers.fail("10 numbers", std::to_string(numbers.size()));
  for (std::size_t i = 0; i < quadric.coefficients.size(); ++i) quadric.coefficients[i] = numbers[i].real();
  return quadric;
}

SolidShape mesh_of(const JsonValue& json) {
  TriangleList list = triangles_of(json);
  return std::make_shared<const ClosedMesh>(std::move(list.vertices), std::move(list.triangles));
}

struct ShapeKind {
  std::string_view name;
  SolidShape (*read)(const JsonValue&);
};
constexpr std::array<ShapeKind, 8> shape_kinds{{
    {"box",
     [](const JsonValue& j) -> SolidShape {
       return solid::Box{vector_of(j["lo"]), vector_of(j["hi"])};
     }},
    {"sphere",
     [](const JsonValue& j) -> SolidShape {
       return solid::Sphere{vector_of(j["c"]), j["r"].real()};
     }},
    {"half",
     [](const JsonValue& j) -> SolidShape {
       return solid::HalfSpace{vector_of(j["n"]), j["w"].real()};
     }},
    {"cylinder",
     [](const JsonValue& j) -> SolidShape {
       return solid::Cylinder{vector_of(j["p"]), vector_of(j["q"]), j["r"].real()};
     }},
    {"cone",
     [](const JsonValue& j) -> SolidShape {
       return solid::Cone{vector_of(j["p"]), vector_of(j["q"]), j["r"].real()};
     }},
    {"torus",
     [](const JsonValue& j) -> SolidShape {
       return solid::Torus{vector_or(j, "c", Vec3d(0)), vector_or(j, "a", Vec3d(0, 0, 1)), j["R"].real(),
                           j["r"].real()};
     }},
    {"quadric", quadric_of},
    {"mesh", mesh_of},
}};

template <class Kinds>
std::string names_of(const Kinds& kinds) {
  std::string names;
  for (const auto& kind : kinds) names += (names.empty() ? "" : ", ") + std::string(kind.name);
  return names;
}

/// What a node has from those around it.
struct Surroundings {
  Frame frame;
  std::string material;
};

SolidTree node_of(const JsonValue& json, const Surroundings& around);

SolidTree primitive_of(const JsonValue& json, const Surroundings& here) {
  const JsonValue kind = json["prim"];
  for (const ShapeKind& each : shape_kinds) {
    if (each.name != kind.text()) continue;
    try {
      SolidTree tree;
      tree.shape = each.read(json);
      tree.frame = here.frame;
      tree.material = here.material;
      check(tree.shape);
      check(tree.frame);
      return tree;
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(json.where() + ": " + error.what());
    }
  }
  kind.fail("one of " + names_of(shape_kinds));
}

SolidTree operation_of(const JsonValue& json, const Surroundings& here) {
  const JsonValue kind = json["op"], args = json["args"];
  SolidTree tree;
  tree.kind = SolidTree::Kind::operation;
  bool is_known = false;
  for (const OperationInfo& info : operation_infos) {
    if (info.name != kind.text()) continue;
    tree.operation = info.operation;
    is_known = true;
  }
  if (kind.text() == "compl") {
    tree.kind = SolidTree::Kind::complement;
    if (args.size() != 1) args.fail("1 argument", std::to_string(args.size()));
  } else if (!is_known) {
    kind.fail("one of " + names_of(operation_infos) + ", compl");
  }
  if (args.size() == 0) args.fail("at least 1 argument", "0");
  tree.args.reserve(args.size());
  for (std::size_t i = 0; i < args.size(); ++i) tree.args.push_back(node_of(args[i], here));
  return tree;
}

SolidTree node_of(const JsonValue& json, const Surroundings& around) {
  const bool is_primitive = json.find("prim").has_value(), is_operation = json.find("op").has_value();
  if (is_primitive == is_operation) json.fail("a member \"op\" or \"prim\"", is_primitive ? "both" : "none");
  Surroundings here = around;
  if (const auto frame = json.find("frame")) here.frame = frame_of(*frame) * around.frame;
  if (const auto material = json.find("material")) here.material = material->text();
  return is_primitive ? primitive_of(json, here) : operation_of(json, here);
}

}  // namespace

SolidTree solid_of(const JsonValue& json) { return node_of(json, {}); }

SolidTree read_solid(const std::filesystem::path& path) {
  const std::string text = read_bytes(path);
  const nlohmann::json json = parse_json(path, text);
  return solid_of(JsonValue(path, json));
}

TriangleList triangles_of(const JsonValue& json) {
  const JsonValue vertices = json["v"], triangles = json["f"];
  TriangleList list;
  list.vertices.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) list.vertices.push_back(vector_of(vertices[i]));
  list.triangles.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const JsonValue corners = triangles[i];
    if (corners.size() != 3) corners.fail("3 vertices");
    auto& triangle = list.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t corner = corners[k].whole();
      if (corner >= list.vertices.size()) {
        corners[k].fail("a vertex below " + std::to_string(list.vertices.size()));
      }
      triangle[k] = static_cast<std::uint32_t>(corner);
    }
  }
  return list;
}

}  // namespace sightline
