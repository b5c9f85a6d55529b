/// Broken files: whatever is in them, reading gives a mesh that keeps its promises or one FileError of one line.
#include <gtest/gtest.h>

#include "sightline/io/file_error.h"
#include "sightline/io/mesh_file.h"
#include "sightline/math/random.h"
#include "tests/io/mesh_seeds.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

/// True when a mesh was read.
bool read_or_refuse(const std::filesystem::path& path) {
  try {
    const TriangleMesh mesh = read_mesh(path);
    EXPECT_GT(mesh.size(), 0u);
    for (const Vec3f& p : mesh.positions()) EXPECT_TRUE(is_finite(p));
    for (const auto& triangle : mesh.triangles()) {
      for (const std::uint32_t corner : triangle) EXPECT_LT(corner, mesh.positions().size());
    }
    return true;
  } catch (const FileError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find('\n'), std::string::npos);
    EXPECT_NE(what.find(": expected "), std::string::npos) << what;
    EXPECT_NE(what.find(", found "), std::string::npos) << what;
    return false;
  }
}

std::string mutated(std::string bytes, Random& random) {
  static const std::vector<std::string> tokens = {"-1",
                                                  "0",
                                                  "99999999999",
                                                  "4294967295",
                                                  "nan",
                                                  "-inf",
                                                  "1e39",
                                                  " ",
                                                  "\n",
                                                  "//",
                                                  "#",
                                                  "\"",
                                                  "{",
                                                  "[",
                                                  "\\",
                                                  "3",
                                                  std::string(4, '\xff'),
                                                  std::string(4, '\0')};
  for (std::uint32_t changes = 1 + random.below(3); changes > 0 && !bytes.empty(); --changes) {
    const std::uint32_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
    switch (random.below(7)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes[at] = static_cast<char>(random.next());
        break;
      case 2:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
        break;
      case 3:
        bytes.insert(at, tokens[random.below(static_cast<std::uint32_t>(tokens.size()))]);
        break;
      case 4:
        bytes.erase(at, 1 + random.below(8));
        break;
      case 5:
        bytes.insert(at, bytes.substr(random.below(static_cast<std::uint32_t>(bytes.size())), 24));
        break;
      default: {
        const std::string& token = tokens[random.below(static_cast<std::uint32_t>(tokens.size()))];
        bytes.replace(at, std::min(token.size(), bytes.size() - at), token);
      }
    }
  }
  return bytes;
}

TEST(MeshFuzz, MutantsAreReadOrRefused) {
  constexpr int mutants = 1000;
  const TemporaryFolder folder;
  for (const MeshSeed& seed : mesh_seeds()) {
    Random random(7);
    int read = 0;
    for (int i = 0; i < mutants; ++i) {
      const std::string bytes = mutated(seed.bytes, random);
      read += read_or_refuse(folder.write("mutant" + seed.extension, bytes));
      ASSERT_FALSE(HasFailure()) << seed.extension << ", mutant " << i << ":\n" << bytes;
    }
    EXPECT_GT(read, mutants / 100) << seed.extension;
    EXPECT_LT(read, mutants * 99 / 100) << seed.extension;
  }
}

/// No prefix that cuts off more than closing words and blanks is a mesh.
TEST(MeshFuzz, EveryPrefixIsRefused) {
  const TemporaryFolder folder;
  for (const MeshSeed& seed : mesh_seeds()) {
    // OBJ does not say how much there is of it, so it may end after any statement; the name behind "endsolid" may be
    // cut.
    const std::size_t whole = seed.extension == ".obj"          ? seed.bytes.find("f 1 2")
                              : seed.bytes.starts_with("solid") ? seed.bytes.find("endsolid")
                                                                : seed.bytes.size() - 2;
    for (std::size_t size = 1; size < whole; ++size) {
      const bool read = read_or_refuse(folder.write("prefix" + seed.extension, seed.bytes.substr(0, size)));
      const bool is_text_end = seed.bytes.substr(size).find_first_not_of("0123456789. \n") == std::string::npos;
      EXPECT_TRUE(!read || is_text_end) << seed.extension << " cut to " << size;
    }
  }
}

TEST(MeshFuzz, NoiseIsRefused) {
  const TemporaryFolder folder;
  Random random(3);
  for (const char* extension : {".obj", ".off", ".ply", ".stl", ".gltf", ".glb"}) {
    for (int i = 0; i < 200; ++i) {
      std::string bytes(1 + random.below(400), ' ');
      for (char& c : bytes) c = static_cast<char>(random.next());
      EXPECT_FALSE(read_or_refuse(folder.write(std::string("noise") + extension, bytes)));
    }
  }
}

/// Debian's own models, among them those that are broken on purpose.
TEST(MeshFuzz, DebianModels) {
  const std::filesystem::path fetched = SIGHTLINE_SOURCE_DIR "/data/cache/assimp-testmodels";
  const std::filesystem::path installed = "/usr/share/assimp/models";
  const std::filesystem::path models = std::filesystem::exists(installed) ? installed : fetched;
  ASSERT_TRUE(std::filesystem::exists(models)) << "install assimp-testmodels, or run data/fetch models";
  int read = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models)) {
    const std::string extension = entry.path().extension().string();
    for (const char* known : {".obj", ".off", ".ply", ".stl", ".STL", ".gltf", ".glb"}) {
      if (extension != known) continue;
      const bool is_read = read_or_refuse(entry.path());
      (is_read ? read : refused) += 1;
      EXPECT_FALSE(is_read && entry.path().parent_path().filename() == "invalid") << entry.path();
    }
  }
  EXPECT_GE(read, 40);
  EXPECT_GE(refused, 20);
}

}  // namespace
}  // namespace sightline
