#include "sightline/scene/scenes.h"

#include <array>
#include <charconv>
#include <stdexcept>

#include "sightline/io/file_error.h"
#include "sightline/io/mesh_file.h"
#include "sightline/scene/procedural.h"
#include "sightline/scene/staged.h"
#include "sightline/scene/teapot.h"

namespace sightline {
namespace {

constexpr int most_patch_segments = 128;
constexpr int most_random = 10'000'000;

/// The order is that of help texts: what is looked at first, then what is hard.
constexpr auto infos = std::to_array<SceneInfo>({
    {"teapot", "the Utah teapot; size: segments along a patch", 16, 1, most_patch_segments},
    {"dragon", "the Stanford dragon, got by data/fetch; size: 1 (871,414 triangles) to 4 (11,102)", 3, 1, 4},
    {"room", "a closed room with the teapot and boxes; size: as of teapot", 16, 1, most_patch_segments},
    {"stadium", "the teapot in a stadium of few large triangles; size: as of teapot", 16, 1, most_patch_segments},
    {"sphere-flake", "spheres around spheres; size: levels", 2, 0, 5},
    {"menger", "Menger's sponge; size: levels", 3, 0, 4},
    {"terrain", "a fractal landscape; size: cells along a side", 128, 1, 2500},
    {"soup", "small triangles anywhere; size: triangles", 10'000, 1, most_random},
    {"sticks", "long thin triangles side by side at 45 degrees, which no box fits; size: triangles", 50'000, 1,
     most_random},
    {"lattice", "triangles with whole-numbered corners; size: triangles", 2'000, 1, most_random},
    {"flat", "triangles in one plane; size: triangles", 1'000, 1, most_random},
    {"copies", "one triangle many times; size: triangles", 100'000, 1, most_random},
});

TriangleMesh load_dragon(int resolution, const std::filesystem::path& data_dir) {
  const std::string suffix = resolution == 1 ? "" : "_res" + std::to_string(resolution);
  const std::filesystem::path path = data_dir / "cache" / ("dragon_vrip" + suffix + ".ply");
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw FileError(path, 0, "the Stanford dragon (run data/fetch, or take --scene teapot)", "no file");
  }
  return read_mesh(path);
}

TriangleMesh make(std::string_view name, int size, const std::filesystem::path& data_dir) {
  if (name == "dragon") return load_dragon(size, data_dir);
  if (name == "room") return make_room(size);
  if (name == "stadium") return make_stadium(size);
  if (name == "sphere-flake") return make_sphere_flake(size);
  if (name == "menger") return make_menger(size);
  if (name == "terrain") return make_terrain(size);
  if (name == "soup") return make_soup(size);
  if (name == "sticks") return make_sticks(size);
  if (name == "lattice") return make_lattice(size);
  if (name == "flat") return make_flat(size);
  if (name == "copies") return make_copies(size);
  return make_teapot(size);
}

int parse_size(const SceneInfo& info, std::string_view text) {
  int size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error != std::errc() || end != text.data() + text.size() || size < info.lowest || size > info.highest) {
    throw std::invalid_argument("scene " + std::string(info.name) + ": expected a size from " +
                                std::to_string(info.lowest) + " to " + std::to_string(info.highest) + ", found \"" +
                                std::string(text) + "\"");
  }
  return size;
}

}  // namespace

std::span<const SceneInfo> scene_infos() { return infos; }

std::shared_ptr<const TriangleMesh> load_scene(const std::string& spec, const std::filesystem::path& data_dir) {
  const std::size_t colon = spec.find(':');
  const std::string_view name = std::string_view(spec).substr(0, colon);
  for (const SceneInfo& info : infos) {
    if (info.name != name) continue;
    const int size =
        colon == std::string::npos ? info.default_size : parse_size(info, std::string_view(spec).substr(colon + 1));
    return std::make_shared<const TriangleMesh>(make(name, size, data_dir));
  }
  // Scenes have neither in their names, files have an extension at least.
  if (spec.find_first_of("./") != std::string::npos) return std::make_shared<const TriangleMesh>(read_mesh(spec));
  std::string names;
  for (const SceneInfo& info : infos) names += " " + std::string(info.name);
  throw std::invalid_argument("scene: expected a mesh file or one of" + names + ", found \"" + spec + "\"");
}

}  // namespace sightline
