/// fuzz_scenes: reads changed scene and model files for as long as one likes, to see whether any of them crashes the
/// readers or is answered by anything but a sound scene or one clear line. To be built with the sanitizers.

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>

#include "tests/io/temporary_folder.h"
#include "tests/scene/scene_mutants.h"

namespace sightline {
namespace {

struct Options {
  double seconds = 10;
  std::uint64_t seed = 1;
  std::string models = "/usr/share/assimp/models";
};

int run(const Options& options) {
  const std::filesystem::path scenes = SIGHTLINE_SOURCE_DIR "/data/scenes";
  const TemporaryFolder folder;
  std::filesystem::copy(scenes, folder.path(), std::filesystem::copy_options::recursive);
  std::vector<SceneSeed> seeds = scene_seeds(scenes);
  const std::size_t scene_count = seeds.size();
  if (std::filesystem::exists(options.models)) {
    const std::vector<SceneSeed> models = model_seeds(options.models, 60'000, 4);
    seeds.insert(seeds.end(), models.begin(), models.end());
  }
  Random random(options.seed);
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  std::size_t count = 0, read = 0, faults = 0;
  double slowest = 0, said = 0;
  while (elapsed() < options.seconds) {
    // Scenes as often as all models together: theirs are the readers that nothing isolates.
    const bool is_scene = random.below(2) == 0 || seeds.size() == scene_count;
    const std::size_t place = is_scene
                                  ? random.below(static_cast<std::uint32_t>(scene_count))
                                  : scene_count + random.below(static_cast<std::uint32_t>(seeds.size() - scene_count));
    const SceneSeed& seed = seeds[place];
    const std::string bytes = mutant_of(seed, random);
    // The file stays where a crash ends the program, to be looked at.
    const std::filesystem::path path =
        folder.write("mutant" + std::filesystem::path(seed.name).extension().string(), bytes);
    const double before = elapsed();
    bool is_read = false;
    const std::string fault = fault_of(path, is_read);
    if (elapsed() - before > slowest) {
      slowest = elapsed() - before;
      std::cout << "slowest: " << slowest << " s, of " << seed.name << std::endl;
    }
    ++count;
    read += is_read;
    if (!fault.empty()) {
      ++faults;
      const std::string kept = "fault-" + std::to_string(faults) + path.extension().string();
      std::ofstream(kept, std::ios::binary) << bytes;
      std::cout << "FAULT in a mutant of " << seed.name << ", kept as " << kept << ": " << fault << std::endl;
    }
    if (elapsed() - said > 60) {
      said = elapsed();
      std::cout << said << " s: " << count << " mutants, " << read << " read, " << faults << " faults" << std::endl;
    }
  }
  std::cout << count << " mutants of " << seeds.size() << " files in " << elapsed() << " s: " << read << " read, "
            << count - read - faults << " refused, " << faults << " faults; slowest " << slowest << " s" << std::endl;
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace sightline

int main(int argc, char** argv) {
  sightline::Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--seconds") == 0) {
      options.seconds = std::atof(argv[i + 1]);
    } else if (std::strcmp(argv[i], "--seed") == 0) {
      options.seed = std::strtoull(argv[i + 1], nullptr, 10);
    } else if (std::strcmp(argv[i], "--models") == 0) {
      options.models = argv[i + 1];
    } else {
      argc = 0;
    }
  }
  if (argc % 2 == 0) {
    std::cerr << "usage: fuzz_scenes [--seconds N] [--seed N] [--models FOLDER]\n";
    return 2;
  }
  return sightline::run(options);
}
