#include "sightline/io/child_process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "sightline/io/file_error.h"
#include "sightline/io/model_bytes.h"
#include "sightline/math/random.h"

namespace sightline {
namespace {

std::string failure(const std::function<std::string()>& work, const ChildLimits& limits = {}) {
  try {
    run_in_child(work, limits);
  } catch (const ChildFailure& error) {
    return error.what();
  }
  return "answered";
}

TEST(ChildProcess, Answers) {
  const std::string large(10'000'000, 'x');
  EXPECT_EQ(run_in_child([&] { return large; }), large);
  EXPECT_EQ(run_in_child([] { return std::string(); }), "");
  int value = 1;
  EXPECT_EQ(run_in_child([&] { return std::to_string(value = 2); }), "2");
  EXPECT_EQ(value, 1);
}

TEST(ChildProcess, EndsInOneLine) {
  EXPECT_EQ(failure([]() -> std::string { throw std::runtime_error("no luck"); }), "no luck");
  EXPECT_EQ(failure([]() -> std::string { _exit(3); }), "a crash");
  EXPECT_EQ(failure([]() -> std::string {
              raise(SIGTERM);
              return "";
            }),
            "a crash (signal 15)");
  EXPECT_EQ(failure(
                []() -> std::string {
                  for (;;) pause();
                },
                {.time = std::chrono::seconds(1)}),
            "no end within 1 s");
  EXPECT_EQ(failure(
                []() -> std::string {
                  std::vector<std::string> eaten;
                  for (;;) eaten.emplace_back(1 << 20, 'x');
                },
                {.time = std::chrono::seconds(20), .memory = 200 << 20}),
            "a need of more than 200 MiB");
}

Model pyramid() {
  Model model;
  model.meshes.push_back({"mesh", 0, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {{0, 0}, {1, 0}, {0, 1}}});
  model.materials.push_back({});
  model.materials[0].color_image = 0;
  model.images.push_back({"image", std::string("bytes"), false});
  model.images.push_back({"other", std::filesystem::path("a.png"), true});
  model.nodes.push_back({"root", nothing, {}, {}, nothing, nothing});
  model.nodes.push_back({"node", 0, {}, {0}, 0, 0});
  model.cameras.push_back({"eye", 50});
  model.lights.push_back({});
  model.warnings = {"a warning"};
  return model;
}

TEST(ModelBytes, ComeBack) {
  const std::string bytes = bytes_of(pyramid());
  const Model back = model_of("model", bytes);
  EXPECT_EQ(bytes_of(back), bytes);
  EXPECT_EQ(std::get<std::filesystem::path>(back.images[1].source), "a.png");
  EXPECT_EQ(back.warnings, pyramid().warnings);
}

/// What a crashing process may have written.
TEST(ModelBytes, BrokenOnesAreRefused) {
  const std::string bytes = bytes_of(pyramid());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(model_of("model", bytes.substr(0, size)), FileError) << size;
  }
  Random random(5);
  int refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string mutant = bytes;
    for (std::uint32_t k = 1 + random.below(3); k > 0; --k) {
      mutant[random.below(static_cast<std::uint32_t>(mutant.size()))] = static_cast<char>(random.next());
    }
    try {
      const Model model = model_of("model", mutant);
      ASSERT_LT(model.meshes[0].triangles[0][2], model.meshes[0].positions.size());
    } catch (const FileError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 5'000);
}

}  // namespace
}  // namespace sightline
