#pragma once
/// What there is to say of a scene in few words, and in many.

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sightline/math/aabb.h"
#include "sightline/scene/scene.h"

namespace sightline::scenes_tool {

/// Something that --scene takes.
struct Entry {
  std::string spec;
  std::string description;
};

/// Scenes by name, the scenes of data/scenes, and the models of data/cache, each kind by its order.
std::vector<Entry> entries(const std::filesystem::path& data_dir);

struct Facts {
  std::uint32_t nodes = 0;
  std::uint64_t triangles = 0;  ///< Where nodes place them.
  std::uint32_t solids = 0;     ///< Nodes that have one.
  Aabb bounds;                  ///< Of all triangles.
};
Facts facts_of(const Scene& scene);

/// A line: "teapot  2 nodes  16,256 triangles  6.4 x 3.2 x 4.0".
std::string row(const Entry& entry, const Facts& facts);

/// The tree of nodes, of many alike the first ones, then lists of all that the scene has.
void describe(const Scene& scene, std::ostream& out);

}  // namespace sightline::scenes_tool
