#include "sightline/scene/scene_file.h"

#include <gtest/gtest.h>

#include "sightline/io/file_error.h"
#include "sightline/scene/flatten.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

Scene read(const TemporaryFolder& folder, const std::string& text) {
  return read_scene(folder.write("scene.json", text), "no/data");
}

/// What is wrong with it, behind the name of the file.
std::string refusal(const TemporaryFolder& folder, const std::string& text) {
  try {
    read(folder, text);
  } catch (const FileError& error) {
    const std::string what = error.what(), file = (folder.path() / "scene.json").string();
    return what.starts_with(file) ? what.substr(file.size()) : what;
  }
  return "read";
}

const MeshGeometry& mesh_at(const Scene& scene, NodeId node) {
  return std::get<MeshGeometry>(scene.geometries.at(scene.graph.geometry(node)).shape);
}

TEST(SceneFile, SaysWhatItSays) {
  const TemporaryFolder folder;
  const Scene scene = read(folder, R"({
    // A comment with a "quote and a { brace.
    "textures": {"grain": {"procedural": "wood"}}, /* another [ */
    "materials": {"oak": {"color": [0.5, 0.25, 1], "color_texture": "grain", "roughness": 0.25, "absorption": "#ff0000"}},
    "geometries": {"tri": {"vertices": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]], "normals": [[0,0,2],[0,0,2],[0,0,2]], "uvs": [[0,0],[1,0],[0,1]]}},
    "objects": [
      {"name": "a", "material": "oak", "transform": [{"translate": [1, 2, 3]}, {"scale": 2}], "children": [
        {"name": "b", "geometry": "tri", "transform": [{"rotate": {"axis": [0, 0, 1], "degrees": 90}}, {"translate": [1, 0, 0]}]}]},
      {"name": "c", "parent": "b", "light": {"kind": "spot", "inner_angle": 10, "outer_angle": 20, "intensity": 3}},
      {"name": "eye", "transform": [{"look_at": {"eye": [0, 0, 5], "target": [0, 0, 0]}}], "camera": {"field_of_view": 50}}
    ]})");
  ASSERT_EQ(scene.graph.size(), 5u);
  EXPECT_EQ(scene.graph.path(2), "/a/b");
  EXPECT_EQ(scene.graph.path(3), "/a/b/c");
  // First moved by 1 along x, then turned, then twice as large, then moved.
  EXPECT_EQ(scene.graph.world(2).point(Vec3d(0)), Vec3d(1, 4, 3));
  EXPECT_EQ(scene.graph.world(2).point(Vec3d(1, 0, 0)), Vec3d(1, 6, 3));
  EXPECT_EQ(scene.graph.material(1), 0u);
  EXPECT_EQ(scene.materials[0].color, Color(0.5f, 0.25f, 1));
  EXPECT_EQ(scene.materials[0].absorption, Color(1, 0, 0));
  EXPECT_EQ(scene.materials[0].color_texture, 0u);
  EXPECT_EQ(scene.materials[0].roughness, 0.25);
  EXPECT_EQ(mesh_at(scene, 2).normals[1], Vec3f(0, 0, 1));
  EXPECT_EQ(mesh_at(scene, 2).uvs[1], glm::vec2(1, 0));
  EXPECT_EQ(std::get<SpotLight>(scene.lights.at(0).kind).outer_angle, 20);
  EXPECT_EQ(scene.cameras.at(0).field_of_view, 50);
  EXPECT_EQ(scene.graph.world(4).matrix(), Transform::translation({0, 0, 5}).matrix());
}

TEST(SceneFile, GroupsStandWhereTheyAreUsed) {
  const TemporaryFolder folder;
  const Scene scene = read(folder, R"({
    "geometries": {"ball": {"sphere": {"radius": 1, "segments": 8}}},
    "groups": {"pair": [{"geometry": "ball"}, {"geometry": "ball", "transform": [{"translate": [2, 0, 0]}]}],
               "four": [{"use": "pair"}, {"use": "pair", "transform": [{"translate": [0, 5, 0]}]}]},
    "objects": [{"use": "four"}, {"geometry": "ball", "transform": [{"translate": [0, 9, 0]}], "repeat": {"count": 3, "transform": [{"translate": [1, 0, 0]}]}}]})");
  const SceneInstances flat = instances_of(scene);
  ASSERT_EQ(flat.instances.size(), 7u);
  EXPECT_EQ(flat.instances.meshes().size(), 1u);
  EXPECT_EQ(flat.instances.placements()[3].point({0, 0, 0}), Vec3f(2, 5, 0));
  EXPECT_EQ(flat.instances.placements()[6].point({0, 0, 0}), Vec3f(2, 9, 0));
}

TEST(SceneFile, IncludesAndScenesWithinScenes) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  folder.write("sub/materials.json", R"({"materials": {"red": {"color": [1, 0, 0]}}})");
  folder.write("sub/ball.json", R"({"include": "materials.json", "geometries": {"g": {"sphere": {"radius": 1}}},
    "objects": [{"name": "ball", "geometry": "g", "material": "red"}],
    "animations": [{"channels": [{"node": "ball", "translation": {"times": [0, 1], "values": [[0,0,0],[1,0,0]]}}]}]})");
  const Scene scene = read(folder, R"({"include": ["sub/materials.json", "sub/../sub/materials.json"],
    "materials": {"blue": {"color": [0, 0, 1]}},
    "objects": [{"name": "one", "scene": "sub/ball.json"}, {"name": "two", "scene": "sub/ball.json"}, {"scene": "tetra:1"}]})");
  EXPECT_EQ(scene.materials.at(0).name, "red");
  EXPECT_EQ(scene.graph.path(2), "/one/ball");
  EXPECT_EQ(scene.graph.path(4), "/two/ball");
  EXPECT_EQ(scene.graph.geometry(2), scene.graph.geometry(4));
  EXPECT_EQ(scene.materials.at(scene.graph.material(4)).name, "red");
  ASSERT_EQ(scene.animations.size(), 2u);
  EXPECT_EQ(scene.animations[1].channels[0].node, 4u);
}

TEST(SceneFile, BadOnesAreRefusedInOneLine) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> cases[] = {
      {"{\n\"objects\": [\n}", ":3: expected JSON, found '}' at byte 16"},
      {"[]", ":/: expected an object, found []"},
      {R"({"objekts": []})",
       R"(:/: expected members of a scene, which are $schema, name, include, textures, materials, geometries, groups, objects, animations, background, ambient, fog, render, found "objekts" (is "objects" meant?))"},
      {R"({"objects": [{"geometry": {"sphere": {"radius": "big"}}}]})",
       R"(:/objects/0/geometry/sphere/radius: expected a number, found "big")"},
      {R"({"objects": [{"geometry": {"sphere": {"radius": -1}}}]})",
       ":/objects/0/geometry/sphere: expected a shape that makes sense, found expected a radius above 0"},
      {R"({"objects": [{"geometry": {"spheer": {}}}]})", R"(found "spheer" (is "sphere" meant?))"},
      {R"({"objects": [{"geometry": {"mesh": "teapot:2", "solid": "widget"}}]})",
       ":/objects/0/geometry: expected one of mesh, solid, csg, sphere, box, quad, lathe, vertices, found mesh, solid"},
      {R"({"objects": [{"geometry": {"mesh": "kettle"}}]})",
       ":/objects/0/geometry/mesh: expected a mesh file, or a name of teapot"},
      {R"({"objects": [{"geometry": {"mesh": "teapot:0"}}]})", "expected a size from 1 to 128"},
      {R"({"objects": [{"geometry": {"solid": "kettle"}}]})",
       ":/objects/0/geometry/solid: expected a shape that makes sense"},
      {R"({"objects": [{"geometry": {"csg": {"prim": "sphere", "c": [0,0,0], "r": -2}}}]})",
       ":/objects/0/geometry/csg: expected a shape"},
      {R"({"objects": [{"geometry": "ball"}], "geometries": {"bowl": {"sphere": {"radius": 1}}}})",
       R"(:/objects/0/geometry: expected one of the geometries that are defined (bowl), found "ball")"},
      {R"({"objects": [{"material": "red"}]})",
       R"(:/objects/0/material: expected one of the materials that are defined (none), found "red")"},
      {R"({"objects": [{"name": "rocket", "children": [{"name": "fin", "transform": [{"translate": [0,0,0]}, {"scale": 0}]}]}]})",
       ":/objects/0/children/0/transform/1: expected a transform of /rocket/fin that can be undone, found scaling: "
       "expected factors other than 0"},
      {R"({"objects": [{"transform": [{"matrix": [1,0,0,0, 1,0,0,0, 0,0,1,0]}]}]})",
       "found matrix: expected one that can be inverted"},
      {R"({"objects": [{"transform": [{"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,1,1]}]}]})",
       ":/objects/0/transform/0/matrix/14: expected 0: the fourth row is 0 0 0 1, found 1"},
      {R"({"objects": [{"transform": [{"scale": 1e-200}, {"scale": 1e-200}]}]})",
       ":/objects/0/transform/1: expected a transform of /? that can be undone, found one beyond the range of double"},
      {R"({"objects": [{"transform": [{"translate": [0,0,0], "scale": 1}]}]})",
       ":/objects/0/transform/0: expected one of translate, rotate, scale, matrix, look_at, found translate, scale"},
      {R"({"objects": [{"transform": [{"look_at": {"eye": [1,1,1], "target": [1,1,1]}}]}]})",
       "expected a target other than the eye"},
      {R"({"objects": [{"transform": [{"rotate": {"axis": [0,0,0], "degrees": 1}}]}]})",
       "expected an axis other than 0"},
      {R"({"materials": {"m": {"color": [1, -1, 0]}}})",
       ":/materials/m/color/1: expected a number of at least 0, found -1"},
      {R"({"materials": {"m": {"color": "red"}}})", R"(:/materials/m/color: expected a color such as "#ff8000")"},
      {R"({"materials": {"m": {"roughness": 2}}})",
       ":/materials/m/roughness: expected a number from 0.0 to 1.0, found 2"},
      {R"({"textures": {"t": {"procedural": "wool"}}})",
       ":/textures/t/procedural: expected a texture with its options, found no texture 'wool'"},
      {R"({"textures": {"t": {"image": "none.png"}}})", "none.png: expected a file, found No such file"},
      {R"({"textures": {"t": {"image": "/etc/passwd"}}})", ":/textures/t/image: expected a path relative to this file"},
      {R"({"objects": [{"light": {"kind": "lamp"}}]})",
       ":/objects/0/light/kind: expected one of point, directional, spot, area"},
      {R"({"objects": [{"light": {"kind": "point", "width": 1}}]})",
       R"(:/objects/0/light/width: expected it at a light of kind "area")"},
      {R"({"objects": [{"camera": {"field_of_view": 180}}]})",
       ":/objects/0/camera/field_of_view: expected a number from 1.0 to 179.0"},
      {R"({"objects": [{"parent": "nobody"}]})",
       ":/objects/0/parent: expected the name of an object that stands before"},
      {R"({"objects": [{"name": "x"}, {"name": "x"}, {"parent": "x"}]})",
       ":/objects/2/parent: expected a name that one object has"},
      {R"({"groups": {"a": [{"use": "b"}], "b": [{"use": "a"}]}, "objects": [{"use": "a"}]})",
       ":/groups/b/0/use: expected a group that does not contain itself, found a -> b -> a"},
      {R"({"objects": [{"repeat": {"count": 5000000}}]})",
       ":/objects/0/repeat/count: expected a number from 1 to 4194304, found 5000000"},
      {R"({"objects": [{"repeat": {"count": 2000, "transform": [{"scale": 2}]}}]})",
       "expected transforms that can be undone, found another after 1024 times"},
      {R"({"objects": [{"geometry": {"vertices": [[0,0,0]], "triangles": [[0,0,1]]}}]})",
       "/triangles/0/2: expected a vertex below 1, found 1"},
      {R"({"objects": [{"geometry": {"vertices": [[0,0,1e39]], "triangles": [[0,0,0]]}}]})",
       "/vertices/0/2: expected a number that is finite as a float"},
      {R"({"objects": [{"name": "n"}], "animations": [{"channels": [{"node": "n", "scale": {"times": [0, 0], "values": [1, 1]}}]}]})",
       "/scale/times/1: expected a time after the one before"},
      {R"({"objects": [{"name": "n"}], "animations": [{"channels": [{"node": "n", "scale": {"times": [0], "values": [0]}}]}]})",
       ":/animations/0: expected an animation that can be played"},
      {R"({"objects": [{"scene": "none.glb"}]})", "none.glb: expected a file, found No such file"},
      {R"({"objects": 1e999})", "expected a number that a double holds, found 1e999"}};
  for (const auto& [text, expected] : cases) {
    const std::string found = refusal(folder, text);
    EXPECT_NE(found.find(expected), std::string::npos) << text << "\n  " << found << "\n  " << expected;
    EXPECT_EQ(found.find('\n'), std::string::npos);
  }
}

TEST(SceneFile, CyclesAreNamed) {
  const TemporaryFolder folder;
  folder.write("b.json", R"({"include": "c.json"})");
  folder.write("c.json", R"({"objects": [{"scene": "scene.json"}]})");
  EXPECT_NE(refusal(folder, R"({"include": "b.json"})").find("found scene.json -> b.json -> c.json -> scene.json"),
            std::string::npos);
  EXPECT_NE(refusal(folder, R"({"include": "scene.json"})").find("found scene.json -> scene.json"), std::string::npos);
  for (int i = 0; i < 40; ++i) {
    folder.write("deep" + std::to_string(i) + ".json", R"({"include": "deep)" + std::to_string(i + 1) + R"(.json"})");
  }
  EXPECT_NE(refusal(folder, R"({"include": "deep0.json"})").find("files at most 32 deep"), std::string::npos);
}

TEST(SceneFile, DeepScenes) {
  const TemporaryFolder folder;
  std::string text = R"({"objects": [{"name": "n0"})";
  for (int i = 1; i < 10'000; ++i) {
    text += ",{\"name\": \"n" + std::to_string(i) + "\", \"parent\": \"n" + std::to_string(i - 1) + "\"}";
  }
  const Scene scene = read(folder, text + "]}");
  EXPECT_EQ(scene.graph.size(), 10'001u);
  EXPECT_EQ(scene.graph.parent(10'000), 9'999u);

  std::string nested, ends;
  for (int i = 0; i < 450; ++i) {
    nested += R"([{"children":)";
    ends += "}]";
  }
  EXPECT_EQ(read(folder, "{\"objects\":" + nested + "[]" + ends + "}").graph.size(), 451u);
  std::string groups = R"("g0": [{}])";
  for (int i = 1; i < 2'000; ++i) {
    groups += ", \"g" + std::to_string(i) + R"(": [{"use": "g)" + std::to_string(i - 1) + "\"}]";
  }
  EXPECT_NE(refusal(folder, R"({"groups": {)" + groups + R"(}, "objects": [{"use": "g1999"}]})").find("500 deep"),
            std::string::npos);
}

TEST(SceneFile, WideScenesAndTooLargeOnes) {
  const TemporaryFolder folder;
  std::string text = R"({"objects": [{})";
  for (int i = 1; i < 100'000; ++i) text += R"(,{"transform":[{"translate":[)" + std::to_string(i) + ",0,0]}]}";
  EXPECT_EQ(read(folder, text + "]}").graph.size(), 100'001u);
  // Ten of ten of ten ... of them.
  std::string groups = R"("g0": [{"repeat": {"count": 10}}])";
  for (int i = 1; i < 12; ++i) {
    groups +=
        ", \"g" + std::to_string(i) + R"(": [{"repeat": {"count": 10}, "use": "g)" + std::to_string(i - 1) + "\"}]";
  }
  EXPECT_NE(refusal(folder, R"({"groups": {)" + groups + R"(}, "objects": [{"use": "g11"}]})").find("4194304 nodes"),
            std::string::npos);
}

}  // namespace
}  // namespace sightline
