#include "sightline/scene/scenes.h"

#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>
#include <variant>

#include "sightline/io/file_error.h"
#include "sightline/io/mesh_file.h"
#include "sightline/scene/flatten.h"
#include "sightline/scene/levels.h"
#include "sightline/scene/procedural.h"
#include "sightline/scene/scene_file.h"
#include "sightline/scene/scene_parts.h"
#include "sightline/scene/spd/databases.h"
#include "sightline/scene/staged.h"
#include "sightline/scene/teapot.h"

namespace sightline {
namespace {

constexpr int most_patch_segments = 128;
constexpr int most_random = 10'000'000;

/// A maker of one mesh, or of a scene of many nodes. The dragon, which is read, has neither.
using Maker = std::variant<std::monostate, TriangleMesh (*)(int), Scene (*)(int)>;

struct Entry {
  SceneInfo info;
  Maker make;
};

/// The order is that of help texts: what is looked at first, then what is standard, then what is hard. The largest
/// sizes make some ten million triangles.
constexpr auto entries = std::to_array<Entry>({
    {{"teapot", "the Utah teapot; size: segments along a patch", 16, 1, most_patch_segments}, &make_teapot},
    {{"dragon", "the Stanford dragon, got by data/fetch; size: 1 (871,414 triangles) to 4 (11,102)", 3, 1, 4}, {}},
    {{"room", "a closed room with the teapot and boxes; size: as of teapot", 16, 1, most_patch_segments}, &make_room},
    {{"stadium", "the teapot in a stadium of few large triangles; size: as of teapot", 16, 1, most_patch_segments},
     &make_stadium},
    {{"sphere-flake", "spheres around spheres; size: levels", 2, 0, 5}, &make_sphere_flake},
    {{"menger", "Menger's sponge; size: levels", 3, 0, 4}, &make_menger},
    {{"terrain", "a fractal landscape; size: cells along a side", 128, 1, 2500}, &make_terrain},
    {{"levels", "spheres that hang below spheres, as courses have it (renderLevel); size: levels", 10, 1, 15},
     +[](int size) { return make_levels(size); }},
    {{"balls", "Haines' spheres around spheres, over a floor; size: levels", 3, 0, 5}, &spd::make_balls},
    {{"gears", "Haines' meshed gears; size: gears along a side", 4, 1, 25}, &spd::make_gears},
    {{"mountain", "Haines' fractal mountain behind four spheres; size: levels", 7, 1, 11}, &spd::make_mountain},
    {{"rings", "Haines' pyramid of dodecahedra made of rings; size: layers", 5, 1, 15}, &spd::make_rings},
    {{"teapot-board", "Haines' teapot, on a checkerboard; size: squares along a side, and segments as of teapot", 12, 2,
      most_patch_segments},
     &spd::make_teapot_board},
    {{"tetra", "Haines' tetrahedra in tetrahedra; size: levels", 6, 1, 11}, &spd::make_tetra},
    {{"tree", "Haines' bare tree in a field; size: levels", 9, 0, 14}, &spd::make_tree},
    {{"lattice", "Costa's cube of spheres and rods, of Haines' databases; size: cells along a side", 8, 1, 25},
     &spd::make_lattice},
    {{"jacks", "Enzmann's jacks within jacks, of Haines' databases; size: levels", 3, 1, 5}, &spd::make_jacks},
    {{"shells", "Pickover's sea shell of spheres, of Haines' databases; size: doublings of 180 spheres", 3, 1, 8},
     &spd::make_shells},
    {{"sombrero", "Enzmann's damped wave, of Haines' databases; size: doublings of 16 points along a side", 3, 1, 7},
     &spd::make_sombrero},
    {{"soup", "small triangles anywhere; size: triangles", 10'000, 1, most_random}, &make_soup},
    {{"sticks", "long thin triangles side by side at 45 degrees, which no box fits; size: triangles", 50'000, 1,
      most_random},
     &make_sticks},
    {{"integers", "triangles with whole-numbered corners; size: triangles", 2'000, 1, most_random}, &make_integers},
    {{"flat", "triangles in one plane; size: triangles", 1'000, 1, most_random}, &make_flat},
    {{"copies", "one triangle many times; size: triangles", 100'000, 1, most_random}, &make_copies},
});

constexpr auto infos = [] {
  std::array<SceneInfo, entries.size()> list{};
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = entries[i].info;
  return list;
}();

TriangleMesh load_dragon(int resolution, const std::filesystem::path& data_dir) {
  const std::string suffix = resolution == 1 ? "" : "_res" + std::to_string(resolution);
  const std::filesystem::path path = data_dir / "cache" / ("dragon_vrip" + suffix + ".ply");
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw FileError(path, 0, "the Stanford dragon (run data/fetch, or take --scene teapot)", "no file");
  }
  return read_mesh(path);
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

/// Triangles alone where nothing is known of nodes, so that nothing need be placed.
using Made = std::variant<TriangleMesh, Scene>;

enum class Wanted { nodes, triangles };

/// Its extension tells what a file is.
Made read(const std::filesystem::path& path, const std::filesystem::path& data_dir, Wanted wanted) {
  // Of these the shorter way gives the same triangles.
  if (path.extension() == ".obj" && wanted == Wanted::triangles) return read_mesh(path);
  if (is_scene_file(path)) return read_scene(path, data_dir);
  return read_mesh(path);
}

Made make(const std::string& spec, const std::filesystem::path& data_dir, Wanted wanted) {
  const std::size_t colon = spec.find(':');
  const std::string_view name = std::string_view(spec).substr(0, colon);
  for (const auto& [info, maker] : entries) {
    if (info.name != name) continue;
    const int size =
        colon == std::string::npos ? info.default_size : parse_size(info, std::string_view(spec).substr(colon + 1));
    if (const auto* make_scene = std::get_if<Scene (*)(int)>(&maker)) return (*make_scene)(size);
    if (const auto* make_mesh = std::get_if<TriangleMesh (*)(int)>(&maker)) return (*make_mesh)(size);
    return load_dragon(size, data_dir);
  }
  // Scenes have neither in their names, files have an extension at least.
  if (spec.find_first_of("./") != std::string::npos) return read(spec, data_dir, wanted);
  std::string names;
  for (const SceneInfo& info : infos) names += " " + std::string(info.name);
  throw std::invalid_argument("scene: expected a mesh file or one of" + names + ", found \"" + spec + "\"");
}

}  // namespace

std::span<const SceneInfo> scene_infos() { return infos; }

Scene make_scene(const std::string& spec, const std::filesystem::path& data_dir) {
  Made made = make(spec, data_dir, Wanted::nodes);
  if (auto* scene = std::get_if<Scene>(&made)) return std::move(*scene);
  return scene_of(spec, std::make_shared<const TriangleMesh>(std::get<TriangleMesh>(std::move(made))));
}

std::shared_ptr<const TriangleMesh> load_scene(const std::string& spec, const std::filesystem::path& data_dir) {
  Made made = make(spec, data_dir, Wanted::triangles);
  if (const auto* scene = std::get_if<Scene>(&made)) {
    return std::make_shared<const TriangleMesh>(instances_of(*scene).instances.flattened());
  }
  return std::make_shared<const TriangleMesh>(std::get<TriangleMesh>(std::move(made)));
}

}  // namespace sightline
