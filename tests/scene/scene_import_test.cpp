#include "sightline/scene/scene_import.h"

#include <gtest/gtest.h>

#include "sightline/io/file_error.h"
#include "sightline/scene/flatten.h"
#include "sightline/scene/gltf_export.h"
#include "sightline/scene/scene_file.h"
#include "tests/io/temporary_folder.h"
#include "tests/scene/scene_mutants.h"

namespace sightline {
namespace {

const std::filesystem::path scenes = SIGHTLINE_SOURCE_DIR "/data/scenes";

std::filesystem::path models() {
  const std::filesystem::path installed = "/usr/share/assimp/models";
  return std::filesystem::exists(installed) ? installed : SIGHTLINE_SOURCE_DIR "/data/cache/assimp-testmodels";
}

/// All that glTF can say of a scene is the same after a way there and back.
void expect_round_trip(const Scene& scene, const std::filesystem::path& path) {
  write_gltf(path, scene);
  const Scene back = read_scene(path, {});
  const SceneInstances before = instances_of(scene), after = instances_of(back);
  ASSERT_EQ(before.instances.size(), after.instances.size()) << path;
  ASSERT_GT(before.instances.size(), 0u) << path;
  for (std::uint32_t i = 0; i < before.instances.size(); ++i) {
    EXPECT_EQ(scene.graph.world(before.origins[i].node).matrix(), back.graph.world(after.origins[i].node).matrix());
    const TriangleMesh &mesh = before.instances.mesh_of(i), &other = after.instances.mesh_of(i);
    ASSERT_EQ(mesh.positions(), other.positions()) << path << " " << i;
    ASSERT_EQ(mesh.triangles(), other.triangles()) << path << " " << i;
    const std::uint32_t material = before.origins[i].material, same = after.origins[i].material;
    ASSERT_EQ(material == no_item, same == no_item);
    if (material == no_item) continue;
    EXPECT_EQ(scene.materials[material].name, back.materials[same].name);
    EXPECT_EQ(scene.materials[material].color, back.materials[same].color);
    EXPECT_EQ(scene.materials[material].roughness, back.materials[same].roughness);
    EXPECT_EQ(scene.materials[material].transmission, back.materials[same].transmission);
  }
  ASSERT_EQ(scene.cameras.size(), back.cameras.size());
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    EXPECT_EQ(scene.graph.world(scene.cameras[i].node).matrix(), back.graph.world(back.cameras[i].node).matrix());
    // Degrees become radians and degrees again.
    EXPECT_NEAR(scene.cameras[i].field_of_view, back.cameras[i].field_of_view, 0x1p-40);
  }
}

TEST(GltfExport, ComesBackBitForBit) {
  const TemporaryFolder folder;
  for (const char* name : {"rocket.json", "spheres.json", "forest.json", "kitchen-table.json"}) {
    Scene scene = read_scene(scenes / name, {});
    scene.animations.clear();  // whose nodes have no matrix
    expect_round_trip(scene, folder.path() / (std::string(name) + ".glb"));
    expect_round_trip(scene, folder.path() / (std::string(name) + ".gltf"));
  }
}

TEST(GltfExport, KeepsAnimations) {
  const TemporaryFolder folder;
  const Scene scene = read_scene(scenes / "rocket.json", {});
  write_gltf(folder.path() / "rocket.glb", scene);
  const Scene back = read_scene(folder.path() / "rocket.glb", {});
  ASSERT_EQ(back.animations.size(), 1u);
  ASSERT_EQ(back.animations[0].channels.size(), 1u);
  const Channel &before = scene.animations[0].channels[0], &after = back.animations[0].channels[0];
  EXPECT_EQ(before.rotation.times, after.rotation.times);
  EXPECT_EQ(back.graph.name(after.node), "orbit");
  EXPECT_EQ(after.rotation.values[1].w, static_cast<float>(before.rotation.values[1].w));
}

TEST(GltfExport, TellsWhatItLeavesOut) {
  const TemporaryFolder folder;
  const std::vector<std::string> warnings =
      write_gltf(folder.path() / "a.glb", read_scene(scenes / "kitchen-table.json", {}));
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings.back(), "light \"lamp\": glTF expected a point, a direction or a spot, found an area; left out");
  EXPECT_THROW(write_gltf(folder.path() / "a.obj", Scene()), FileError);
}

TEST(GltfExport, KeepsWhatIsHiddenHidden) {
  const TemporaryFolder folder;
  Scene scene = read_scene(scenes / "forest.json", {});
  const NodeId hut = scene.graph.find("/hut");
  ASSERT_NE(hut, no_node);
  const std::size_t before = instances_of(scene).instances.size();
  scene.graph.set_visible(hut, false);
  EXPECT_EQ(instances_of(scene).instances.size(), before - 2);
  expect_round_trip(scene, folder.path() / "forest.glb");
  EXPECT_FALSE(read_scene(folder.path() / "forest.glb", {}).graph.is_visible(hut));
}

TEST(SceneImport, KeepsNodesMaterialsTexturesAndCameras) {
  const Scene engine = import_scene(models() / "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
  EXPECT_GT(engine.graph.size(), 50u);
  EXPECT_GT(engine.materials.size(), 5u);
  const Scene boxed = import_scene(models() / "glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf");
  ASSERT_EQ(boxed.textures.size(), 1u);
  EXPECT_TRUE(std::filesystem::exists(std::get<std::filesystem::path>(boxed.textures[0].source)));
  EXPECT_EQ(boxed.materials.at(0).color_texture, 0u);
  const Scene cameras = import_scene(models() / "glTF2/cameras/Cameras.gltf");
  EXPECT_EQ(cameras.cameras.size(), 2u);
  const Scene spider = import_scene(models() / "OBJ/spider.obj");
  EXPECT_GE(spider.materials.size(), 5u);
  EXPECT_GE(spider.textures.size() + spider.warnings.size(), 1u);
}

/// Each is read, or refused in one clear line; and that within bounded time.
TEST(SceneImport, EveryModelOfDebians) {
  ASSERT_TRUE(std::filesystem::exists(models())) << "install assimp-testmodels, or run data/fetch models";
  int read = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models())) {
    if (!entry.is_regular_file() || !is_scene_file(entry.path()) || entry.path().extension() == ".json") continue;
    bool is_read = false;
    EXPECT_EQ(fault_of(entry.path(), is_read), "") << entry.path();
    ++(is_read ? read : refused);
    EXPECT_FALSE(is_read && entry.path().parent_path().filename() == "invalid") << entry.path();
  }
  RecordProperty("read", read);
  RecordProperty("refused", refused);
  EXPECT_GE(read, 150);
  EXPECT_GE(refused, 30);
}

TEST(SceneImport, WarningsAreLines) {
  Model model;
  model.warnings = {"texture \"a\nb\x1b\": expected an image, found none"};
  EXPECT_EQ(scene_of("model", std::move(model)).warnings.at(0), "texture \"a?b?\": expected an image, found none");
}

TEST(SceneImport, SingularNodesAreNamed) {
  const TemporaryFolder folder;
  const auto path = folder.write("flat.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "up", "children": [1]}, {"name": "flat", "scale": [1, 0, 1], "mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  try {
    import_scene(path);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()), path.string() +
                                             ": expected a transform of /up/flat that can be undone, found "
                                             "matrix: expected one that can be inverted");
  }
}

}  // namespace
}  // namespace sightline
