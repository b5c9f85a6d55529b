#pragma once
/// Scenes within scenes.

#include "sightline/scene/scene.h"

namespace sightline {

/// Where the lists of a scene begin within those of another.
struct ListOffsets {
  std::uint32_t geometries = 0, materials = 0, textures = 0;
};

/// More nodes take gigabytes; a short file may place one group any number of times.
inline constexpr std::uint32_t most_nodes = 1u << 22;

/// Scenes within scenes within scenes could bring the same things any number of times.
inline constexpr std::size_t most_items = std::size_t{1} << 20;

/// Appends geometries, materials and textures. \throws std::length_error where there would be too many to count.
ListOffsets append_lists(Scene& into, const Scene& from);

/// Copies the nodes of `from`, with its lights, cameras and animations, below a node of another scene: the root's
/// children, or the root itself where that has a place, geometry or material of its own or is hidden. What is around
/// the scene stays behind. \throws std::length_error where the scene would have more than `most_nodes`.
void graft(Scene& into, NodeId parent, const Scene& from, const ListOffsets& offsets = {});

}  // namespace sightline
