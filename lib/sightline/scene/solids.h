#pragma once
/// Solids by name, the same on every machine.

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "sightline/csg/solid_tree.h"

namespace sightline {

struct SolidInfo {
  std::string_view name;
  std::string_view description;             ///< What it is, and what its size counts, where it has one.
  int default_size = 0;                     ///< 0 where it has none.
  int lowest = 0, highest = 0;              ///< Sizes that are allowed.
  std::array<double, 3> origin, direction;  ///< Of a ray that meets much of it.
};

std::span<const SolidInfo> solid_infos();

/// `spec` is a name ("widget"), or a name and a size ("menger:2"). Materials are names such as "red", "oak" or "steel".
/// \throws std::invalid_argument for an unknown name, and for a size out of its limits or of what has none.
SolidTree load_solid(const std::string& spec);

/// \throws std::invalid_argument likewise, but does not look at the size.
const SolidInfo& solid_info(const std::string& spec);

}  // namespace sightline
