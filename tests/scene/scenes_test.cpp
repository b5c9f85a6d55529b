#include "sightline/scene/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "sightline/io/file_error.h"
#include "sightline/scene/flatten.h"
#include "sightline/scene/procedural.h"

namespace sightline {
namespace {

const std::filesystem::path no_data = "no/such/folder";

std::string refusal(const std::string& spec) {
  try {
    load_scene(spec, no_data);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "loaded";
}

std::uint64_t fingerprint(const TriangleMesh& mesh) {
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&hash](const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211u;
  };
  add(mesh.positions().data(), mesh.positions().size() * sizeof(Vec3f));
  add(mesh.triangles().data(), mesh.triangles().size() * sizeof(TriangleMesh::Corners));
  return hash;
}

TEST(Scenes, KeepWhatMeshesPromise) {
  for (const SceneInfo& info : scene_infos()) {
    if (info.name == "dragon") continue;  // not made but read
    EXPECT_LE(info.lowest, info.default_size);
    EXPECT_LE(info.default_size, info.highest);
    for (const int size : {info.lowest, info.default_size}) {
      const std::string spec = std::string(info.name) + ":" + std::to_string(size);
      const auto mesh = load_scene(spec, no_data);
      EXPECT_GT(mesh->size(), 0u) << spec;
      for (const Vec3f& p : mesh->positions()) ASSERT_TRUE(is_finite(p)) << spec;
      std::vector<bool> is_used(mesh->positions().size());
      for (const auto& triangle : mesh->triangles()) {
        for (const std::uint32_t corner : triangle) {
          ASSERT_LT(corner, is_used.size()) << spec;
          is_used[corner] = true;
        }
      }
      EXPECT_EQ(std::count(is_used.begin(), is_used.end(), false), 0) << spec;
      EXPECT_EQ(fingerprint(*mesh), fingerprint(*load_scene(spec, no_data))) << spec;
    }
    EXPECT_EQ(fingerprint(*load_scene(std::string(info.name), no_data)),
              fingerprint(*load_scene(std::string(info.name) + ":" + std::to_string(info.default_size), no_data)));
  }
}

/// What is loaded for tools that need no nodes is what the nodes place.
TEST(Scenes, AreNodesPlaced) {
  for (const SceneInfo& info : scene_infos()) {
    if (info.name == "dragon") continue;
    const std::string name(info.name);
    const Scene scene = make_scene(name, no_data);
    const SceneInstances placed = instances_of(scene);
    EXPECT_EQ(placed.solids_left_out, 0u);
    EXPECT_LE(placed.instances.triangles(), 500'000u) << name;
    EXPECT_EQ(fingerprint(placed.instances.flattened()), fingerprint(*load_scene(name, no_data))) << name;
    for (const Geometry& geometry : scene.geometries) {
      const MeshGeometry& mesh = std::get<MeshGeometry>(geometry.shape);
      EXPECT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.mesh->positions().size()) << name;
    }
  }
  EXPECT_EQ(make_scene("soup", no_data).graph.size(), 2u);
  EXPECT_THROW(make_scene("kettle", no_data), std::invalid_argument);
  EXPECT_THROW(make_scene("balls:6", no_data), std::invalid_argument);
  EXPECT_THROW(make_scene("kettle.obj", no_data), FileError);
}

TEST(Scenes, AreTheSameOnEveryMachine) {
  EXPECT_EQ(fingerprint(*load_scene("tetra:4", no_data)), 9464107670728130085u);
  EXPECT_EQ(fingerprint(*load_scene("levels:5", no_data)), 13071781447416238315u);
  EXPECT_EQ(fingerprint(*load_scene("soup:1000", no_data)), 8511394594318653203u);
  EXPECT_EQ(fingerprint(*load_scene("terrain:16", no_data)), 5205726892330826481u);
  EXPECT_EQ(fingerprint(*load_scene("sphere-flake:2", no_data)), 17357004014233903766u);
  EXPECT_EQ(fingerprint(*load_scene("teapot:8", no_data)), 14137386820571305366u);
}

TEST(Scenes, SizesCount) {
  for (const char* name : {"soup", "sticks", "integers", "flat", "copies"}) {
    EXPECT_EQ(load_scene(std::string(name) + ":77", no_data)->size(), 77u);
  }
  EXPECT_EQ(load_scene("terrain:9", no_data)->size(), 2u * 81);
  for (const unsigned level : {0u, 1u, 2u, 3u}) {
    const auto power = [level](unsigned base) { return static_cast<std::uint32_t>(std::pow(base, level) + 0.5); };
    EXPECT_EQ(make_menger(static_cast<int>(level)).size(), 2 * (2 * power(20) + 4 * power(8)));
  }
  EXPECT_EQ(make_sphere_flake(2).size(), (1u + 9 + 81) * 128);
}

TEST(Scenes, AreWhatTheirNamesSay) {
  const auto flat = load_scene("flat", no_data), integers = load_scene("integers", no_data);
  for (const Vec3f& p : flat->positions()) EXPECT_EQ(p.z, 0);
  for (const Vec3f& p : integers->positions()) EXPECT_EQ(p, glm::floor(p));
  const auto copies = load_scene("copies:5", no_data);
  for (const auto& triangle : copies->triangles()) EXPECT_EQ(triangle, copies->triangles()[0]);
  // The stadium is some hundred times as wide as the teapot in it, which has nearly all of the triangles.
  const auto stadium = load_scene("stadium", no_data), teapot = load_scene("teapot", no_data);
  EXPECT_GT(stadium->bounds().extent().x, 300 * teapot->bounds().extent().x);
  EXPECT_LT(stadium->size(), teapot->size() + 100);
}

TEST(Scenes, BadNamesAndSizes) {
  EXPECT_EQ(refusal("kettle").substr(0, 58), "scene: expected a mesh file or one of teapot dragon room s");
  EXPECT_NE(refusal("kettle").find("found \"kettle\""), std::string::npos);
  for (const std::string size : {"", "0", "-1", "1000000", "x", "8x", "99999999999999999999"}) {
    EXPECT_EQ(refusal("teapot:" + size), "scene teapot: expected a size from 1 to 128, found \"" + size + "\"");
  }
  EXPECT_THROW(load_scene("", no_data), std::invalid_argument);
  EXPECT_THROW(load_scene("kettle.obj", no_data), FileError);
  EXPECT_EQ(refusal("dragon:4"),
            "no/such/folder/cache/dragon_vrip_res4.ply: expected the Stanford dragon (run data/fetch, or take --scene "
            "teapot), found no file");
}

/// Where it has been fetched, the dragon has the figures that data/README.md gives.
TEST(Scenes, Dragon) {
  const std::filesystem::path data = SIGHTLINE_SOURCE_DIR "/data";
  if (!std::filesystem::exists(data / "cache" / "dragon_vrip_res4.ply")) {
    std::printf("The dragon has not been fetched (data/fetch): its figures are not checked.\n");
    return;
  }
  const auto dragon = load_scene("dragon:4", data);
  EXPECT_EQ(dragon->positions().size(), 5205u);
  EXPECT_EQ(dragon->size(), 11102u);
}

}  // namespace
}  // namespace sightline
