#include "sightline/io/mesh_file.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "sightline/io/file_error.h"
#include "tests/io/mesh_seeds.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

std::string refusal(const std::filesystem::path& path) {
  try {
    read_mesh(path);
  } catch (const FileError& error) {
    return error.what();
  }
  return "read";
}

class MeshFile : public testing::Test {
 protected:
  TriangleMesh read(const std::string& name, const std::string& bytes) { return read_mesh(folder_.write(name, bytes)); }

  /// What is said of these bytes, after the folder and file name.
  std::string refused(const std::string& name, const std::string& bytes) {
    const std::string what = refusal(folder_.write(name, bytes));
    const std::string prefix = (folder_.path() / name).string() + ":";
    return what.starts_with(prefix) ? what.substr(prefix.size()) : what;
  }

  TemporaryFolder folder_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? "nothing to replace" : text.replace(at, from.size(), to);
}

Vec3f pyramid_corner(std::size_t face, std::size_t corner) {
  const auto& p = pyramid_points[pyramid_faces[face][corner]];
  return {p[0], p[1], p[2]};
}

TEST_F(MeshFile, EveryFormatGivesTheSameTrianglesInTheFilesOrder) {
  for (const MeshSeed& seed : mesh_seeds()) {
    const TriangleMesh mesh = read("seed" + seed.extension, seed.bytes);
    EXPECT_EQ(mesh.positions().size(), seed.vertices) << seed.extension;
    ASSERT_EQ(mesh.size(), seed.triangles) << seed.extension;
    if (seed.triangles != 6) continue;
    for (std::uint32_t i = 0; i < 6; ++i) {
      EXPECT_EQ(mesh[i].a, pyramid_corner(i, 0)) << seed.extension << i;
      EXPECT_EQ(mesh[i].b, pyramid_corner(i, 1)) << seed.extension << i;
      EXPECT_EQ(mesh[i].c, pyramid_corner(i, 2)) << seed.extension << i;
    }
  }
}

TEST_F(MeshFile, NodesPlaceMeshesAndMirroringKeepsTheOutside) {
  const TriangleMesh mesh = read("seed.glb", glb_seed());
  EXPECT_EQ(mesh[0].b, Vec3f(2, 2, 3));
  EXPECT_EQ(mesh[6].a, Vec3f(1, 2, 3));
  EXPECT_EQ(mesh[11].b, Vec3f(1 + 2 * 0.5f, 2 + 2 * 0.5f, 3 - 2 * 1.25f));  // corners b and c have changed places
  EXPECT_EQ(mesh[11].c, Vec3f(1, 2, 3));
}

TEST_F(MeshFile, ExtensionsInCapitals) { EXPECT_EQ(read("SEED.STL", stl_seed(false)).size(), 6u); }

TEST_F(MeshFile, BinaryHeaderThatBeginsWithSolid) {
  EXPECT_EQ(read("seed.stl", stl_seed(false).replace(0, 5, "solid")).size(), 6u);
}

TEST_F(MeshFile, PolygonsBecomeTriangles) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  EXPECT_EQ(read("square.obj", square).size(), 2u);
  // An arrow head: the cut has to go through its inner corner.
  const TriangleMesh arrow = read("arrow.off", "OFF\n4 1 0\n0 0 0\n2 1 0\n0 2 0\n1 1 0\n4 0 1 2 3\n");
  ASSERT_EQ(arrow.size(), 2u);
  float area = 0;
  for (std::uint32_t i = 0; i < 2; ++i) area += glm::cross(arrow[i].b - arrow[i].a, arrow[i].c - arrow[i].a).z / 2;
  EXPECT_FLOAT_EQ(area, 1);
}

TEST_F(MeshFile, TrianglesWithoutAreaStay) {
  EXPECT_EQ(read("thin.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\nf 3 3 3\n").size(), 3u);
  EXPECT_EQ(read("thin.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n3 1 1 1\n").size(), 2u);
}

TEST_F(MeshFile, CoordinatesAreTheNearestFloats) {
  const TriangleMesh mesh =
      read("fine.obj", "v 0.1 1e-45 1.00000006\nv 3.4028234e38 -0.3 16777217\nv 0 0 1e-400\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions()[0], Vec3f(0.1f, std::numeric_limits<float>::denorm_min(), 1.00000006f));
  EXPECT_EQ(mesh.positions()[1], Vec3f(3.4028234e38f, -0.3f, 16777216));
}

TEST_F(MeshFile, VerticesThatAreNearlyEqualStayApart) {
  EXPECT_EQ(read("small.obj", "v 0 0 0\nv 1e-9 0 0\nv 0 1e-9 0\nf 1 2 3\n").positions().size(), 3u);
}

TEST_F(MeshFile, WhatIsNotAFile) {
  EXPECT_NE(refusal(folder_.path() / "none.ply").find("none.ply: expected a file, found"), std::string::npos);
  std::filesystem::create_directory(folder_.path() / "folder.ply");
  EXPECT_NE(refusal(folder_.path() / "folder.ply").find(": expected a file, found a folder"), std::string::npos);
  EXPECT_EQ(refused("empty.ply", ""), " expected a file with something in it, found an empty one");
  EXPECT_EQ(refused("mesh.xyz", "1 2 3"),
            " expected one of the extensions .obj .ply .stl .off .gltf .glb, found \".xyz\"");
  EXPECT_NE(refused("mesh", "1 2 3").find("found none"), std::string::npos);
}

TEST_F(MeshFile, RefusalsNameThePlace) {
  EXPECT_EQ(refused("a.obj", replaced(obj_seed(), "f 1 2 3", "f 1 2 6")),
            "12: expected a vertex number up to 5, found 6");
  EXPECT_EQ(refused("a.obj", replaced(obj_seed(), "f 1 2 3", "f 1 2 -6")),
            "12: expected a vertex number from 1, or from -5 to -1, found -6");
  EXPECT_EQ(refused("a.obj", replaced(obj_seed(), "f 1 2 3", "f 1 2")),
            "12: expected a polygon of 3 to 4096 corners, found 2");
  EXPECT_EQ(refused("a.obj", replaced(obj_seed(), "v 0.000000", "v nan")),
            "4: expected a coordinate, finite as a float, found \"nan\"");
  EXPECT_EQ(refused("a.obj", replaced(obj_seed(), "v 0.0", "w 0.0")), "4: expected a statement of OBJ, found \"w\"");
  EXPECT_EQ(refused("a.off", replaced(off_seed(), "1.000000", "1e39")),
            "4: expected a coordinate, finite as a float, found \"1e39\"");
  EXPECT_EQ(refused("a.off", replaced(off_seed(), "5 6", "4000000000 6")),
            "13: expected vertex 11 of 4000000000, found the end of the file");
  EXPECT_EQ(refused("a.off", replaced(off_seed(), "3 0 1 2", "3 0 1 5")),
            "8: expected a vertex number below 5, found 5");
  EXPECT_EQ(refused("a.ply", replaced(ply_seed("ascii"), "vertex 5", "vertex 4000000000")),
            "16: expected the end of the line, found \"2\"");
  EXPECT_EQ(refused("a.ply", replaced(ply_seed("ascii"), "3 0 1 2", "3 0 1 -1")),
            "16: expected a vertex number below 5, found -1");
  EXPECT_EQ(refused("a.ply", replaced(ply_seed("ascii"), "3 0 1 2", "3 0 1 5")),
            "16: expected a vertex number below 5, found 5");
  EXPECT_EQ(refused("a.ply", replaced(ply_seed("ascii"), "3 3 0 4\n", "")),
            "20: expected face 5 of 6, found the end of the file");
  EXPECT_EQ(refused("a.ply", replaced(ply_seed("ascii"), "property float z", "property float w")),
            " expected one property z in the header, found none");
  EXPECT_EQ(refused("a.ply", replaced(ply_seed("binary_little_endian"), "face 6", "face 4000000000")),
            " expected face 6 of 4000000000, found the end of the file");
  EXPECT_EQ(refused("a.stl", stl_seed(false).substr(0, 383)), " expected 384 bytes for 6 facets, found 383 bytes");
  EXPECT_EQ(refused("a.stl", replaced(stl_seed(true), "endloop", "vertex")),
            "7: expected \"endloop\", found \"vertex\"");
  EXPECT_EQ(refused("a.gltf", replaced(gltf_seed(), "\"count\":18", "\"count\":19")),
            "/accessors/1: expected elements within the view's 36 bytes, found 19 elements");
  EXPECT_EQ(refused("a.gltf", replaced(gltf_seed(), "\"children\":[1]", "\"children\":[0]")),
            "/nodes/0: expected a node in one place of the tree, found another way to it");
  EXPECT_EQ(refused("a.gltf", replaced(gltf_seed(), "\"mesh\":0,\"t", "\"mesh\":4,\"t")),
            "/meshes: expected at least 5 elements, found 1");
  EXPECT_EQ(refused("a.gltf", replaced(gltf_seed(), "[2,2,-2]", "[2,1e30,1e60]")),
            "/nodes/1/scale/2: expected a number that is finite as a float, found 1e+60");
  EXPECT_EQ(refused("a.gltf", replaced(gltf_seed(), "]}]", "]}")).substr(0, 17), "2: expected JSON,");
  EXPECT_EQ(refused("a.glb", glb_seed() + "more").substr(0, 9), " expected");
}

TEST_F(MeshFile, WithoutTriangles) {
  EXPECT_EQ(refused("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2\n"), " expected at least one triangle, found none");
  EXPECT_EQ(refused("a.off", "OFF 3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), " expected at least one triangle, found none");
  EXPECT_EQ(refused("a.stl", "solid s\nendsolid s\n"), " expected at least one triangle, found none");
  EXPECT_EQ(refused("a.stl", std::string(84, '\0')), " expected at least one triangle, found none");
  EXPECT_EQ(refused("a.gltf", R"({"asset":{"version":"2.0"}})"), " expected at least one triangle, found none");
}

TEST_F(MeshFile, NanInBinaryFiles) {
  const auto put_nan = [](std::string bytes, std::size_t at) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(bytes.data() + at, &nan, sizeof nan);
    return bytes;
  };
  const std::string ply = ply_seed("binary_little_endian"), glb = glb_seed();
  EXPECT_EQ(refused("a.ply", put_nan(ply, ply.find("end_header") + 11 + 12 * 3)),
            " expected coordinates finite as floats, found NaN or infinity in vertex 3 of 5");
  EXPECT_EQ(refused("a.stl", put_nan(stl_seed(false), 84 + 50 * 2 + 12)),
            " expected finite coordinates, found NaN or infinity in facet 2");
  EXPECT_EQ(refused("a.glb", put_nan(glb, glb.size() - 96 + 12)),
            "/accessors/0: expected finite coordinates, found NaN or infinity in vertex 1");
}

TEST_F(MeshFile, GltfBufferInAFileOfItsOwn) {
  folder_.write("the buffer.bin", gltf_buffer());
  EXPECT_EQ(read("a.gltf", gltf_json("\"the%20buffer.bin\"")).size(), 12u);
  EXPECT_NE(refusal(folder_.write("b.gltf", gltf_json("\"none.bin\""))).find("none.bin: expected a file"),
            std::string::npos);
  EXPECT_EQ(refused("c.gltf", gltf_json("\"http://host/a.bin\"")),
            "/buffers/0/uri: expected a file relative to this one, found \"http://host/a.bin\"");
}

/// A small file must not ask for much: 4,000 nodes that place a mesh of 40,000 triangles.
TEST_F(MeshFile, PlacingMoreTrianglesThanFitIsRefused) {
  std::string nodes, roots;
  for (int i = 0; i < 4000; ++i) {
    nodes += (i > 0 ? "," : "") + std::string(R"({"mesh":0})");
    roots += (i > 0 ? "," : "") + std::to_string(i);
  }
  folder_.write("zeros.bin", std::string(120'000 * 12, '\0'));
  EXPECT_EQ(
      refused("a.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + nodes +
                            R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[
{"bufferView":0,"componentType":5126,"count":120000,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":1440000}],
"buffers":[{"byteLength":1440000,"uri":"zeros.bin"}]})"),
      "/meshes/0: expected at most 134217728 triangles and vertices where nodes place them, found more");
}

TEST_F(MeshFile, ReadByManyThreadsAtOnce) {
  const std::filesystem::path path = folder_.write("seed.ply", ply_seed("ascii"));
  std::vector<std::thread> threads;
  std::array<std::uint32_t, 4> sizes{};
  for (std::uint32_t& size : sizes) threads.emplace_back([&path, &size] { size = read_mesh(path).size(); });
  for (std::thread& thread : threads) thread.join();
  for (const std::uint32_t size : sizes) EXPECT_EQ(size, 6u);
}

}  // namespace
}  // namespace sightline
